// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>

#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// Results of which a folder holds one kind, for their files bear the same names.
struct Kind {
  const char* last_file;  ///< which marks a complete result
  const char* results;
  bool reports;  ///< in report.html
};
constexpr std::array kinds{Kind{"result.json", "a run", true}, Kind{"study.json", "a study", true},
                           Kind{"judge.json", "a judgement", true}, Kind{"card.json", "a card", false}};

constexpr const char* our_table = "xi,t,gamma,";  ///< how the tables of tabulate begin

/// The folders in `root` in which a file of that name lies; those that were made, the outermost first.
std::vector<fs::path> make_parents(const fs::path& root, const fs::path& name) {
  std::vector<fs::path> made;
  fs::path folder = root;
  for (const fs::path& part : name.parent_path()) {
    folder /= part;
    std::error_code error;
    const bool is_new = fs::create_directory(folder, error);
    if (error) fail(folder, "folder cannot be created", error);
    if (!is_new) continue;
    made.push_back(folder);
    fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, error);  // whatever the umask
  }
  return made;
}

/// Renames that can be taken back.
class Moves {
 public:
  Moves() = default;
  Moves(const Moves&) = delete;
  Moves& operator=(const Moves&) = delete;
  ~Moves() {
    std::error_code ignored;
    for (auto move = done_.rbegin(); move != done_.rend(); ++move) fs::rename(move->second, move->first, ignored);
  }
  void move(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    if (error) fail(to, "cannot be put in place", error);
    done_.emplace_back(from, to);
  }
  void keep() { done_.clear(); }

 private:
  std::vector<std::pair<fs::path, fs::path>> done_;
};

bool is_among(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(), [&](std::string_view pattern) {
    return matches(pattern.starts_with('+') ? pattern.substr(1) : pattern, name);
  });
}

/// Null where the names are of no kind.
const Kind* kind_of(const std::vector<std::string>& names) {
  const auto kind = std::ranges::find_if(kinds, [&](const Kind& each) { return is_among(names, each.last_file); });
  return kind == kinds.end() ? nullptr : &*kind;
}

}  // namespace

std::vector<std::string> result_files() {
  std::vector<std::string> files{"result.json",     "errors.csv",        "resolved.yaml",     "particles.pvd",
                                 "particles_#.vtu", "report.html",       "error.png",         "shear.png",
                                 "jacobian.png",    "cut_error.png",     "cut_shear.png",     "cut_jacobian.png",
                                 "view_error.png",  "view_shear.png",    "view_jacobian.png", "error_history.png",
                                 "replay.yaml",     "replay_scene.yaml", "last_good.vtu",     "material.log",
                                 "sheet.csv",       "curve.csv",         "tau.png",           "slope.png",
                                 "sheet.png",       "history.csv",       "histories.png",     "+points.csv"};
  append_all(files, {"path.csv",         "path_#.csv",          "path.npz",
                     "path_#.npz",       "path_stress.png",     "path_stresses.png",
                     "path_strains.png", "path_volume.png",     "path_invariants.png",
                     "path_energy.png",  "path_state.png",      "comparisons.csv",
                     "increments.csv",   "increments_#.csv",    "increments.png",
                     "increments_#.png", "increments_cost.png", "increments_cost_#.png",
                     "iso_error.csv",    "iso_error_#.csv",     "iso_error.png",
                     "iso_error_#.png",  "path_compare.png"});
  return files;
}

OutputFolder::OutputFolder(fs::path target, std::vector<std::string> names)
    : target_(target.empty() ? fs::path(".") : std::move(target)), names_(std::move(names)) {
  if (const Kind* kind = kind_of(names_)) last_file_ = kind->last_file;
  constexpr std::size_t most_files_at_once = 8;  // with fewer what is staged cannot be cleared away
  require_open_files(most_files_at_once);
  put_files_right();
  try {
    // Another run that fails takes its empty folders away, perhaps between our looking and our locking.
    for (int attempt = 0; !make_folders() || !lock(); ++attempt) {
      if (attempt == 100) fail(target_, "folder cannot be created", ENOENT);
    }
    refuse_another_kind(target_, names_);
    make_staging();
  } catch (...) {
    give_back();
    throw;
  }
}

OutputFolder::~OutputFolder() { give_back(); }

void OutputFolder::give_back() {
  put_files_right();
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
  for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);  // only empty ones go
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
}

/// False when a folder vanished meanwhile.
bool OutputFolder::make_folders() {
  std::error_code error;
  fs::path path;
  for (const fs::path& part : target_) {
    path /= part;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) continue;
    if (fs::exists(status)) fail(path, "is no folder", ENOTDIR);
    if (status.type() != fs::file_type::not_found) fail(path, "cannot be reached", error);
    const bool made = fs::create_directory(path, error);
    if (error == std::errc::no_such_file_or_directory && !fs::exists(path.parent_path() / ".")) return false;
    if (error) fail(path, "folder cannot be created", error);
    if (!made) continue;
    if (std::find(made_.begin(), made_.end(), path) == made_.end()) made_.push_back(path);
    fs::permissions(path, fs::perms::owner_all, fs::perm_options::add, error);  // whatever the umask
  }
  return true;
}

/// The lock is on the folder itself and leaves no file. False when the folder is no longer the one at the path.
bool OutputFolder::lock() {
  if (lock_ >= 0) ::close(lock_);
  lock_ = ::open(target_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0 && errno == ENOENT) return false;
  if (lock_ < 0) return true;  // a folder that may be written and not read
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    // Some network file systems cannot lock a folder: then two runs at once are the user's affair.
    if (errno == EWOULDBLOCK) throw FolderBusy(target_.string() + ": another run is writing here");
    return true;
  }
  struct stat locked = {}, there = {};
  if (::fstat(lock_, &locked) != 0) return true;
  return ::stat(target_.c_str(), &there) == 0 && there.st_dev == locked.st_dev && there.st_ino == locked.st_ino;
}

void OutputFolder::make_staging() {
  sweep_dead(target_);
  const fs::path staging = target_ / hidden_name();
  std::error_code error;
  fs::remove_all(staging, error);  // of a dead process that had our number
  fs::create_directory(staging, error);
  if (!error) staging_ = staging;
  if (!error) fs::permissions(staging, fs::perms::owner_all, error);  // whatever the umask
  if (error) fail(target_, "folder cannot be written to", error);
}

void OutputFolder::refuse_another_kind(const fs::path& target, const std::vector<std::string>& names) {
  const Kind* mine = kind_of(names);
  if (!mine || !mine->reports) return;
  std::error_code error;
  for (const Kind& other : kinds) {
    if (&other == mine || !other.reports || !fs::is_regular_file(target / other.last_file, error)) continue;
    throw InputError({target.string(), 0, 0}, "",
                     std::string("holds the results of ") + other.results + " (" + other.last_file + "), and " +
                         mine->results + " would replace its report.html: choose another folder with -o");
  }
}

bool OutputFolder::is_ours(const std::string& name) const { return is_among(names_, name); }

void OutputFolder::keep_inputs() const {
  put_files_right();
  std::error_code error;
  for (fs::directory_iterator entry(target_, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code code;
    const std::string name = entry->path().filename().string();
    if (is_ours(name) && fs::is_regular_file(entry->path(), code) && is_input(entry->path().string())) {
      throw InputError({entry->path().string()}, "",
                       "an input of this name would be replaced by the result; choose another name or folder");
    }
  }
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  stage(name, [&](const fs::path& path) { write_bytes(path, bytes, O_CREAT | O_EXCL); });
}

void OutputFolder::write_pieces(const std::string& name, const std::function<void(const PutBytes&)>& write) {
  stage(name, [&](const fs::path& path) { drivers::write_pieces(path, write, O_CREAT | O_EXCL); });
}

void OutputFolder::stage(const std::string& name, const std::function<void(const fs::path&)>& write) {
  if (!is_ours(name)) throw std::logic_error("OutputFolder: " + name + " is not among the names of this result");
  put_files_right();
  const fs::path final_path = target_ / name;
  std::error_code error;
  const fs::file_status there = fs::symlink_status(final_path, error);
  if (fs::is_directory(there)) fail(final_path, "cannot be replaced", EISDIR);
  if (std::find(staged_.begin(), staged_.end(), name) == staged_.end()) staged_.push_back(name);
  make_parents(staging_, name);
  fs::remove(staging_ / name, error);  // under a strict umask it could not be opened again
  try {
    write(staging_ / name);
  } catch (const SystemError& failure) {
    rethrow_with(failure, staging_ / name, final_path);
  }
}

/// Whether a file of the name may be taken for part of an earlier result.
bool OutputFolder::is_stale(const std::string& name) const {
  if (!is_ours(name)) return false;
  if (std::find(names_.begin(), names_.end(), "+" + name) == names_.end()) return true;
  std::error_code error;
  if (!fs::is_regular_file(target_ / name, error)) return false;
  std::ifstream file(target_ / name, std::ios::binary);
  std::string begin(std::string_view(our_table).size(), '\0');
  return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == our_table;
}

/// The files that make way for the new result, the mark of completeness first.
std::vector<std::string> OutputFolder::replaced() const {
  std::vector<std::string> names;
  std::error_code error;
  const bool complete = !last_file_.empty() && fs::exists(fs::symlink_status(target_ / last_file_, error));
  for (fs::directory_iterator entry(target_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->symlink_status(error).type() == fs::file_type::directory) continue;
    const bool written = std::find(staged_.begin(), staged_.end(), name) != staged_.end();
    if (written || (complete && is_stale(name))) names.push_back(name);
  }
  if (error) fail(target_, "folder cannot be read", error);
  for (const std::string& name : staged_) {  // of sub-folders
    if (name.find('/') != name.npos && fs::exists(fs::symlink_status(target_ / name, error))) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  std::stable_partition(names.begin(), names.end(), [&](const std::string& name) { return name == last_file_; });
  return names;
}

void OutputFolder::commit() {
  const fs::path old = staging_ / "old";
  stop_if_interrupted();
  put_files_right();
  std::error_code error;
  fs::create_directory(old, error);
  if (!error) fs::permissions(old, fs::perms::owner_all, error);
  if (error) fail(target_, "folder cannot be written to", error);
  std::stable_partition(staged_.begin(), staged_.end(), [&](const std::string& name) { return name != last_file_; });

  Moves moves;
  for (const std::string& name : replaced()) {
    make_parents(old, name);
    moves.move(target_ / name, old / name);
  }
  for (const std::string& name : staged_) {
    for (const fs::path& made : make_parents(target_, name)) made_.push_back(made);
    if (name == last_file_) sync_path(target_);
    moves.move(staging_ / name, target_ / name);
  }
  moves.keep();
  sync_path(target_);
  fs::remove_all(staging_, error);
  staging_.clear();
  made_.clear();
}

}  // namespace assay::drivers
