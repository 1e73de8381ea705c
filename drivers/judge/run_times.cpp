// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/run_times.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/system/input_error.hpp"
#include "drivers/text/natural_order.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_time(const ParticleTable& table, const std::string& what) {
  throw InputError({table.file, 0, 0}, "time", what);
}

}  // namespace

RunFiles files_of_run(const std::string& run) {
  std::error_code code;
  if (!fs::is_directory(run, code)) return {{run}, {}};
  std::map<std::string, std::vector<std::string>> kinds;  // files by their names with # for numbers
  std::vector<std::string> collections;
  for (const auto& entry : fs::directory_iterator(run, code)) {
    const std::string name = entry.path().filename().string(), suffix = entry.path().extension().string();
    if (!entry.is_regular_file(code) || name.starts_with('.')) continue;
    if (suffix == ".pvd") collections.push_back(entry.path().string());
    const bool other = suffix == ".yaml" || suffix == ".json" || suffix == ".html" || suffix == ".png" ||
                       suffix == ".md" || suffix == ".log" || suffix == ".py" || suffix == ".xml";
    if (!other) kinds[std::regex_replace(name, std::regex("[0-9]+"), "#")].push_back(entry.path().string());
  }
  if (collections.size() == 1) return {collections, {}};
  const auto most = std::ranges::max_element(kinds, {}, [](const auto& kind) { return kind.second.size(); });
  if (most == kinds.end()) throw InputError({run, 0, 0}, "", "the folder holds no file with particles");
  RunFiles found{most->second, {}};
  for (const auto& [name, files] : kinds) {
    if (name != most->first && files.size() == most->second.size()) {
      throw InputError({run, 0, 0}, "",
                       "the folder holds as many files " + shown(name, 40) + " as " + shown(most->first, 40) +
                           ": which are the particles? Name the file, or move the others away");
    }
    for (const std::string& file : files) {
      if (name != most->first) found.left_out.push_back(fs::path(file).filename().string());
    }
  }
  std::ranges::sort(found.files, in_natural_order);
  std::ranges::sort(found.left_out);
  return found;
}

std::string seeds_file_of(const std::string& run, const std::string& seeds) {
  if (seeds.empty() || fs::path(seeds).is_absolute()) return seeds;
  std::error_code code;
  const fs::path whole = fs::absolute(run, code).lexically_normal();
  const fs::path folder = fs::is_directory(whole, code) ? whole / "" : whole;
  for (const fs::path& beside : {folder.parent_path(), folder.parent_path().parent_path()}) {
    const fs::path file = beside / seeds;
    if (fs::is_regular_file(file, code)) return fs::proximate(file, code).string();
  }
  if (fs::exists(seeds, code)) return seeds;
  throw InputError({run, 0, 0}, "seeds",
                   shown(seeds, 80) + " lies neither in the folder of the run nor in the one above it");
}

std::string cost_file_of(const std::string& run) {
  std::error_code code;
  const fs::path file =
      fs::is_directory(run, code) ? fs::path(run) / "cost.yaml" : fs::path(run).replace_extension("cost.yaml");
  return fs::is_regular_file(file, code) ? file.string() : std::string();
}

TimeOf::TimeOf(const JudgeTime& time) : time_(time) {
  if (!time.pattern.empty()) {
    try {
      pattern_ = std::regex(time.pattern);
      if (pattern_.mark_count() == 0)
        throw InputError({}, "time.pattern", "has no group around the number: 'dump[.](\\d+)' has one");
    } catch (const std::regex_error& error) {
      throw InputError({}, "time.pattern", "is no regular expression: " + std::string(error.what()));
    }
  }
}

std::map<double, std::vector<std::size_t>> TimeOf::operator()(const ParticleTable& table, std::size_t number) {
  using From = JudgeTime::From;
  std::map<double, std::vector<std::size_t>> rows;
  const From from = time_.from == From::guess ? guessed(table) : time_.from;
  if (from == From::column) {
    const ParticleArray* times = table.array(column_);
    if (!times) refuse_time(table, "there is no column '" + shown(column_, 40) + "' with the time");
    for (std::size_t p = 0; p < table.rows; ++p) {
      if (!std::isfinite(times->values[p * times->components]))
        refuse_time(table, "a time that is no number, of particle " + std::to_string(p + 1));
      rows[times->values[p * times->components]].push_back(p);
    }
    return rows;
  }
  std::vector<std::size_t>& all = rows[one_time(from, table, number)];
  for (std::size_t p = 0; p < table.rows; ++p) all.push_back(p);
  return rows;
}
JudgeTime::From TimeOf::guessed(const ParticleTable& table) {
  using From = JudgeTime::From;
  if (table.time) return From::header;
  for (const char* name : {"t", "time", "Time", "TIME", "TimeValue"}) {
    const ParticleArray* array = table.array(name);
    if (array && array->components == 1) {
      column_ = name;
      return From::column;
    }
  }
  if (time_.step > 0 && table.step) return From::step;
  refuse_time(table,
              "the file says no time: the map says `time: {from: step, step: DT}` if its files are numbered 0, 1, ..., "
              "`{from: name, pattern: '(\\d+)', step: DT}`, `{from: column, column: NAME}` or "
              "`{from: list, values: [0, .1]}`");
}
double TimeOf::one_time(JudgeTime::From from, const ParticleTable& table, std::size_t number) {
  using From = JudgeTime::From;
  if (from == From::header) {
    words_ = "times are those that the files say";
    if (!table.time) refuse_time(table, "the file says no time");
    return *table.time;
  }
  if (from == From::list) {
    words_ = "times are the map's";
    if (number >= time_.values.size())
      refuse_time(table, "is table " + std::to_string(number + 1) + ", and time.values has " +
                             std::to_string(time_.values.size()) + " times");
    return time_.values[number];
  }
  if (from == From::step) {
    words_ = "times are step numbers, times " + rounded_text(time_.step, 6);
    return time_.start + time_.step * table.step.value_or(static_cast<double>(number));
  }
  const std::string name = fs::path(table.file).filename().string();
  std::smatch found;
  if (!std::regex_search(name, found, pattern_) || found.size() < 2)
    refuse_time(table, "its name does not match time.pattern, " + shown(time_.pattern, 60));
  const auto value = parse_number(found[1].str());
  if (!value) refuse_time(table, "'" + shown(found[1].str(), 40) + "' of its name is no number");
  words_ = "times are numbers of the files' names" +
           (time_.step > 0 ? ", times " + rounded_text(time_.step, 6) : std::string());
  return time_.start + (time_.step > 0 ? time_.step : 1) * *value;
}

}  // namespace assay::drivers
