// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/output_folder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "drivers/input_error.hpp"
#include "drivers/output/numbers.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

constexpr const char* last_file = "result.json";

[[noreturn]] void fail(const fs::path& path, const std::string& what, int error) {
  throw SystemError(path.string() + ": " + what + ": " + std::generic_category().message(error));
}

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::error_code& error) {
  throw SystemError(path.string() + ": " + what + ": " + error.message());
}

void write_all(int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "cannot be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Opens, writes, syncs and closes, and believes none of them.
void write_bytes(const fs::path& path, std::string_view bytes, int flags) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) fail(path, "cannot be created", errno);
  try {
    write_all(descriptor, bytes, path);
    // Pipes and terminals cannot be synced and say so.
    if (::fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS) {
      fail(path, "cannot be written", errno);
    }
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0 && errno != EINTR) fail(path, "cannot be written", errno);
}

void sync_folder(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);  // best effort: the files themselves are synced
  ::close(descriptor);
}

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
  return name.data();
}

bool digit(char c) { return c >= '0' && c <= '9'; }

bool matches(std::string_view pattern, std::string_view name) {
  while (!pattern.empty()) {
    if (name.empty()) return false;
    if (pattern[0] != '#') {
      if (pattern[0] != name[0]) return false;
      name.remove_prefix(1);
    } else {
      if (!digit(name[0])) return false;
      while (!name.empty() && digit(name[0])) name.remove_prefix(1);
    }
    pattern.remove_prefix(1);
  }
  return name.empty();
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

}  // namespace

std::vector<std::string> result_files() {
  return {last_file,     "errors.csv", "resolved.yaml", "particles.pvd",     "particles_#.vtu",
          "report.html", "error.png",  "shear.png",     "error_history.png", "replay.yaml",
          "sheet.csv",   "curve.csv",  "tau.png",       "slope.png",         "+points.csv"};
}

OutputFolder::OutputFolder(fs::path target, std::vector<std::string> names)
    : target_(target.empty() ? fs::path(".") : std::move(target)), names_(std::move(names)) {
  try {
    make_folders();
    make_staging();
  } catch (...) {
    std::error_code ignored;
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);
    throw;
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
  for (auto made = made_.rbegin(); made != made_.rend(); ++made) fs::remove(*made, ignored);  // only empty ones go
}

void OutputFolder::make_folders() {
  std::error_code error;
  fs::path path;
  for (const fs::path& part : target_) {
    path /= part;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) continue;
    if (fs::exists(status)) fail(path, "is no folder", ENOTDIR);
    if (status.type() != fs::file_type::not_found) fail(path, "cannot be reached", error);
    if (fs::create_directory(path, error)) made_.push_back(path);
    if (error) fail(path, "folder cannot be created", error);
  }
}

void OutputFolder::make_staging() {
  static std::atomic<int> counter{0};
  sweep_dead_stagings();
  const std::string name = ".assay-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "@" + host_name();
  const fs::path staging = target_ / name;
  std::error_code error;
  fs::remove_all(staging, error);  // of a dead process that had our number
  fs::create_directory(staging, error);
  if (error) fail(target_, "folder cannot be written to", error);
  staging_ = staging;
}

/// A killed process leaves its staging folder behind: ".assay-PID-N@HOST".
void OutputFolder::sweep_dead_stagings() const {
  const std::string tail = "@" + host_name();
  std::error_code error;
  std::vector<fs::path> dead;
  for (fs::directory_iterator entry(target_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.ends_with(tail) || !matches(".assay-#-#", name.substr(0, name.size() - tail.size()))) continue;
    const auto process = parse_integer(name.substr(7, name.find('-', 7) - 7));
    if (process && ::kill(static_cast<pid_t>(*process), 0) != 0 && errno == ESRCH) dead.push_back(entry->path());
  }
  for (const fs::path& path : dead) fs::remove_all(path, error);
}

bool OutputFolder::is_ours(const std::string& name) const {
  return std::any_of(names_.begin(), names_.end(), [&](std::string_view pattern) {
    return matches(pattern.starts_with('+') ? pattern.substr(1) : pattern, name);
  });
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
  if (!is_ours(name)) throw std::logic_error("OutputFolder: " + name + " is not among the names of this result");
  const fs::path final_path = target_ / name;
  std::error_code error;
  const fs::file_status there = fs::symlink_status(final_path, error);
  if (fs::is_directory(there)) fail(final_path, "cannot be replaced", EISDIR);
  if (std::find(staged_.begin(), staged_.end(), name) == staged_.end()) staged_.push_back(name);
  try {
    write_bytes(staging_ / name, bytes, O_CREAT | O_TRUNC);
  } catch (const SystemError& failure) {
    // The user knows the final name, not the hidden one.
    std::string what = failure.what();
    const std::string hidden = (staging_ / name).string();
    if (what.starts_with(hidden)) what.replace(0, hidden.size(), final_path.string());
    throw SystemError(what);
  }
}

/// The files that make way for the new result, the mark of completeness first.
std::vector<std::string> OutputFolder::replaced() const {
  std::vector<std::string> names;
  std::error_code error;
  const bool complete = fs::exists(fs::symlink_status(target_ / last_file, error));
  for (fs::directory_iterator entry(target_, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->symlink_status(error).type() == fs::file_type::directory) continue;
    const bool written = std::find(staged_.begin(), staged_.end(), name) != staged_.end();
    const bool stale = complete && is_ours(name) && std::find(names_.begin(), names_.end(), "+" + name) == names_.end();
    if (written || stale) names.push_back(name);
  }
  if (error) fail(target_, "folder cannot be read", error);
  std::sort(names.begin(), names.end());
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == last_file; });
  return names;
}

void OutputFolder::commit() {
  const fs::path old = staging_ / "old";
  std::error_code error;
  fs::create_directory(old, error);
  if (error) fail(target_, "folder cannot be written to", error);
  std::stable_partition(staged_.begin(), staged_.end(), [](const std::string& name) { return name != last_file; });

  Moves moves;
  for (const std::string& name : replaced()) moves.move(target_ / name, old / name);
  for (const std::string& name : staged_) {
    if (name == last_file) sync_folder(target_);
    moves.move(staging_ / name, target_ / name);
  }
  moves.keep();
  sync_folder(target_);
  fs::remove_all(staging_, error);
  staging_.clear();
  made_.clear();
}

void write_file(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  const fs::file_status there = fs::status(path, error);
  if (fs::exists(there) && !fs::is_regular_file(there)) return write_bytes(path, bytes, 0);
  // Through a link the file is replaced, not the link.
  const fs::path real = fs::exists(there) ? fs::canonical(path, error) : path;
  const fs::path temporary =
      real.parent_path() / ("." + real.filename().string() + "." + std::to_string(::getpid()) + ".tmp");
  try {
    write_bytes(temporary, bytes, O_CREAT | O_TRUNC);
    fs::rename(temporary, real, error);
    if (error) fail(path, "cannot be put in place", error);
  } catch (const SystemError& failure) {
    fs::remove(temporary, error);
    std::string what = failure.what();
    if (what.starts_with(temporary.string())) what.replace(0, temporary.string().size(), path.string());
    throw SystemError(what);
  }
}

}  // namespace assay::drivers
