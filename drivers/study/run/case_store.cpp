// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/case_store.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/output/errors_csv.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/sha256.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* record_file = "case.json";
constexpr const char* case_scene_file = "case.yaml";
constexpr const char* result_file = "result.json";
constexpr std::size_t largest_result = std::size_t{1} << 30;

/// Nothing where the file cannot be read.
std::optional<std::string> bytes_of(const fs::path& file) {
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return std::nullopt;
  try {
    return read_bytes(file.string(), largest_result);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The record without its own hash; nothing where it is not what was written.
std::optional<Json> read_record(const fs::path& folder, const std::string& key) {
  const auto text = bytes_of(folder / record_file);
  if (!text || is_nested_deeply(*text)) return std::nullopt;
  Json record = Json::parse(*text, nullptr, false);
  if (!record.is_object() || record.value("key", Json()) != key) return std::nullopt;
  if (!record.value("files", Json()).is_object() || !record.value("clock", Json()).is_object()) return std::nullopt;
  if (!record.value("crashed", Json()).is_string() || !record.value("stopped", Json()).is_boolean())
    return std::nullopt;
  const Json seal = record.value("sha256", Json());
  record.erase("sha256");
  return seal == sha256_hex(json_document(record)) ? std::optional(record) : std::nullopt;
}

/// Every file that a run has left, without the record and what is hidden.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->is_regular_file(error) && !name.starts_with('.') && name != record_file) names.push_back(name);
  }
  if (error) fail(folder, "folder cannot be read", error);
  std::ranges::sort(names);
  return names;
}

/// All but what is hidden goes, the record first.
void clear_case(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder / record_file, error);
  std::vector<fs::path> rest;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (!entry->path().filename().string().starts_with('.')) rest.push_back(entry->path());
  }
  for (auto path = rest.begin(); !error && path != rest.end(); ++path) fs::remove_all(*path, error);
  if (error) fail(folder, "an earlier result cannot be removed", error);
}

Figure number_in(const std::map<std::string, FlatValue>& figures, const std::string& key) {
  const auto* number = value_in<double>(figures, key);
  return number ? Figure(*number) : Figure();
}

/// What result.json and errors.csv say.
void read_result(const fs::path& folder, StudyCase& found) {
  const auto read = read_result_json(bytes_of(folder / result_file).value_or(""));
  if (!read) return;
  found.figures.insert(read->figures.begin(), read->figures.end());
  found.passes = read->passes;
  const auto* outcome = value_in<std::string>(found.figures, "outcome");
  const auto* reason = value_in<std::string>(found.figures, "reason");
  found.outcome = outcome ? *outcome : "", found.reason = reason ? *reason : "";
  found.work = number_in(found.figures, "work.particle_steps");
  found.history = displacement_history(bytes_of(folder / "errors.csv").value_or(""));
}

std::string state_text(const PlannedCase& one, const CaseStore& store) {
  if (!one.invalid.empty()) return "n/a";
  constexpr const char* names[] = {"finished", "missing", "torn", "crashed", "stopped"};
  return names[static_cast<std::size_t>(store.state_of(one.key))];
}

/// Some network file systems cannot lock: then two studies at once are the user's affair.
bool held_by_another(int file) { return ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; }

/// A run locks its folder (output_folder.cpp); that of a study that was killed may take a moment to die.
bool is_written_to(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return false;
  const bool written = held_by_another(file);
  ::close(file);
  return written;
}

}  // namespace

std::optional<CaseLock> CaseLock::tried(const fs::path& folder) {
  std::error_code error;
  if (fs::is_symlink(folder, error)) throw SystemError(folder.string() + ": is a link, and not followed");
  fs::create_directories(folder, error);
  if (error) fail(folder, "folder cannot be created", error);
  const int file = ::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) fail(folder, "folder cannot be written to", errno);
  CaseLock lock(file);
  if (held_by_another(file) || is_written_to(folder)) return std::nullopt;
  return lock;
}

CaseLock::~CaseLock() {
  if (file_ >= 0) ::close(file_);
}

fs::path CaseStore::record_of(const std::string& key) const { return folder_of(key) / record_file; }

CaseState CaseStore::state_of(const std::string& key) const {
  const fs::path folder = folder_of(key);
  std::error_code error;
  if (key.empty() || !fs::exists(folder / record_file, error)) return CaseState::missing;
  const auto record = read_record(folder, key);
  if (!record) return CaseState::torn;
  bool has_result = false;
  for (const auto& file : record->at("files").items()) {
    const auto bytes = bytes_of(folder / file.key());
    if (!bytes || file.value() != sha256_hex(*bytes)) return CaseState::torn;
    has_result = has_result || file.key() == result_file;
  }
  if (!record->at("crashed").get_ref<const std::string&>().empty()) return CaseState::crashed;
  if (record->at("stopped").get<bool>()) return CaseState::stopped;
  return has_result ? CaseState::finished : CaseState::torn;
}

bool CaseStore::is_timed(const std::string& key) const {
  const auto record = read_record(folder_of(key), key);
  return record && what_is_there<ClockReadings>(record->at("clock")).alone;
}

double CaseStore::limit_of(const std::string& key) const {
  const auto record = read_record(folder_of(key), key);
  const Json limit = record ? record->value("limit", Json()) : Json();
  return limit.is_number() ? limit.get<double>() : 0;
}

fs::path CaseStore::begin(const PlannedCase& one) const {
  const fs::path folder = folder_of(one.key);
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && fs::is_symlink(folder, error)) throw SystemError(folder.string() + ": is a link, and not followed");
  if (error) fail(folder, "folder cannot be created", error);
  clear_case(folder);
  write_file(folder / case_scene_file, one.yaml);
  return folder / case_scene_file;
}

void CaseStore::finish(const PlannedCase& one, const CaseRecord& record) const {
  const fs::path folder = folder_of(one.key);
  Json files = Json::object();
  for (const std::string& name : files_in(folder)) {
    const auto bytes = bytes_of(folder / name);
    if (!bytes) fail(folder / name, "cannot be read", EIO);
    files[name] = sha256_hex(*bytes);
  }
  Json text = {{"key", one.key},
               {"threads", one.threads},
               {"crashed", record.crashed},
               {"stopped", record.stopped},
               {"limit", record.limit_s},
               {"clock", JsonFields<Json>::of(record.clock)},
               {"files", files}};
  // As it will be read: a text that is no UTF-8 is replaced, and a number that is none becomes null.
  text = Json::parse(json_document(text));
  text["sha256"] = sha256_hex(json_document(text));
  write_file(folder / record_file, json_document(text));
}

StudyCase CaseStore::read(const PlannedCase& one) const {
  StudyCase found;
  found.number = one.number, found.key = one.key, found.values = one.values;
  found.label = one.label, found.series = one.series, found.resolution = one.resolution;
  found.budget = one.base.has_value();
  if (!one.invalid.empty()) {
    found.outcome = "n/a", found.reason = one.invalid;
    return found;
  }
  const CaseState state = state_of(one.key);
  if (state == CaseState::missing || state == CaseState::torn) return found;
  const fs::path folder = folder_of(one.key);
  sweep_dead(folder);
  const auto record = read_record(folder, one.key);
  if (!record) return found;
  found.clock = what_is_there<ClockReadings>(record->at("clock"));
  found.figures["threads"] = static_cast<double>(one.threads);
  if (state == CaseState::crashed) {
    found.outcome = "crashed", found.reason = record->at("crashed").get<std::string>();
  } else if (state == CaseState::stopped) {
    found.outcome = "stopped", found.reason = "it took longer than the limit of the study";
  } else {
    read_result(folder, found);
  }
  return found;
}

std::size_t CaseStore::finished_besides(const std::set<std::string>& keys) const {
  std::size_t count = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder_ / "cases", error), end; !error && entry != end; entry.increment(error)) {
    const std::string key = entry->path().filename().string();
    count += !keys.contains(key) && fs::is_regular_file(entry->path() / record_file, error) ? 1 : 0;
  }
  return count;
}

bool CaseStore::take(const PlannedCase& one, const CaseStore& from, CaseState state) const {
  if (from.state_of(one.key) != state) return false;
  const fs::path folder = folder_of(one.key), source = from.folder_of(one.key);
  std::error_code error;
  if (fs::equivalent(folder, source, error)) return true;
  const auto lock = this->lock(one);
  if (!lock) return false;
  begin(one);
  for (const std::string& name : files_in(source)) write_file(folder / name, bytes_of(source / name).value_or(""));
  write_file(folder / record_file, bytes_of(source / record_file).value_or(""));
  return true;
}

Figure figure_of(const fs::path& file, const std::string& key) {
  const auto read = read_result_json(bytes_of(file).value_or(""));
  return read ? number_in(read->figures, key) : std::nullopt;
}

std::string list_text(const Plan& plan, const CaseStore& store) {
  std::string text;
  for (const PlannedCase& one : plan.cases) {
    text += std::to_string(one.number) + "\t" + (one.key.empty() ? "-" : one.key) + "\t" + state_text(one, store) +
            "\t" + std::to_string(std::llround(one.particle_steps)) + "\t" + one_line(one.label) + "\n";
  }
  return text;
}

std::string list_json(const Plan& plan, const CaseStore& store) {
  Json all = Json::array();
  for (const PlannedCase& one : plan.cases) {
    Json values = Json::object();
    for (const AxisValue& value : one.values) values[value.axis] = value.value;
    all.push_back(Json::object({{"number", one.number},
                                {"key", one.key.empty() ? Json(nullptr) : Json(one.key)},
                                {"state", state_text(one, store)},
                                {"threads", one.threads},
                                {"timed", one.timed},
                                {"particle_steps", one.particle_steps},
                                {"label", one.label},
                                {"values", values},
                                {"reason", one.invalid.empty() ? Json(nullptr) : Json(one.invalid)}}));
  }
  return json_document(all);
}

}  // namespace assay::drivers
