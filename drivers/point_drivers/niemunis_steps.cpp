// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/niemunis_steps.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "drivers/point_drivers/mtest_file.hpp"
#include "drivers/point_drivers/niemunis_terms.hpp"
#include "drivers/point_drivers/number_columns.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using Kind = NiemunisStep::Kind;

constexpr const char* what_commons = "increments, iterations, duration";

/// "100 20 1.0 : 10 T 5.0": increments, iterations, duration; each tenth one is written; the temperature rises by 5.
void read_commons(NiemunisLines& lines, NiemunisStep& step, double least_duration) {
  lines.need(what_commons);
  const std::string_view line = lines.line();
  const std::size_t colon = line.find(':');
  const std::vector<NiemunisField> fields = lines.fields();
  if (fields.size() < 3)
    throw InputError(lines.where(), step.keyword, std::string("3 numbers are needed: ") + what_commons);
  step.increments = niemunis_count(fields[0], 1);
  step.most_iterations = niemunis_count(fields[1], 0);
  NiemunisField duration = fields[2];
  duration.text = duration.text.substr(0, duration.text.find(':'));
  step.duration = niemunis_number(duration);
  if (!(step.duration >= least_duration))
    throw InputError(duration.where, step.keyword, "the duration must not be negative");
  if (colon != line.npos) {
    const std::vector<NiemunisField> behind = lines.fields(colon + 1);
    if (behind.empty()) throw InputError(lines.where(colon), step.keyword, "a whole number is missing behind ':'");
    step.every = std::min(niemunis_count(behind[0], 1), step.increments);
  }
  for (std::size_t i = 3; i + 1 < fields.size(); ++i)
    if (fields[i].text == "T") step.temperature_change = niemunis_number(fields[i + 1]);
}

void need_duration(const NiemunisStep& step) {
  if (!(step.duration > 0)) throw InputError(step.where, step.keyword, "needs a duration");
}

void read_variables(NiemunisLines& lines, NiemunisStep& step) {
  static const std::vector<std::string> names{"*Cartesian", "*Roscoe", "*RoscoeIsomorph", "*Rendulic"};
  lines.need("the variables, as *Cartesian");
  const NiemunisField word = lines.fields().front();
  if (!is_one_of(word.text, names))
    throw InputError(word.where, step.keyword, unknown("kind of variables", word.text, names), joined(names));
  step.variables = static_cast<NiemunisVariables>(index_of(word.text, names));
}

bool stress_or_strain(const NiemunisStep& step, const NiemunisField& field) {
  if (field.text != "0" && field.text != "1")
    throw InputError(field.where, step.keyword, "'" + field.text + "' must be 0, a strain, or 1, a stress");
  return field.text == "1";
}

/// A line for each variable: stress or strain, and `count` numbers.
std::vector<double> read_variable(NiemunisLines& lines, NiemunisStep& step, std::size_t i, std::size_t count) {
  const std::string what = "0 or 1 of variable " + std::to_string(i + 1) + ", and " + std::to_string(count) + " more";
  lines.need(what);
  const std::vector<NiemunisField> fields = lines.fields();
  if (fields.size() <= count)
    throw InputError(lines.where(), step.keyword, std::to_string(count + 1) + " numbers are needed: " + what);
  step.is_stress[i] = stress_or_strain(step, fields[0]);
  std::vector<double> values;
  for (std::size_t k = 1; k <= count; ++k) values.push_back(niemunis_number(fields[k]));
  return values;
}

void read_linear(NiemunisLines& lines, NiemunisStep& step, const std::string&) {
  read_commons(lines, step, 0);
  read_variables(lines, step);
  for (std::size_t i = 0; i < 6; ++i) step.change[i] = read_variable(lines, step, i, 1)[0];
}

void read_circulating(NiemunisLines& lines, NiemunisStep& step, const std::string&) {
  step.kind = Kind::circulating;
  read_commons(lines, step, 0);
  need_duration(step);
  read_variables(lines, step);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::vector<double> values = read_variable(lines, step, i, 3);
    step.amplitude[i] = values[0], step.phase[i] = values[1], step.change[i] = values[2];
  }
}

void read_gradient(NiemunisLines& lines, NiemunisStep& step, const std::string&) {
  step.kind = Kind::deformation_gradient;
  read_commons(lines, step, 0);
  need_duration(step);
  for (double& component : step.gradient)
    component = lines.numbers(1, "a component of the deformation gradient: 11, 22, 33, 12, 21, 13, 31, 23, 32")[0];
}

/// A path with a name: which variables are stresses, and which one has the number of the next line.
struct NamedPath {
  NiemunisVariables variables;
  std::array<bool, 6> is_stress;
  int given;  ///< from 0; -1: none, nothing changes
};

const std::map<std::string, NamedPath>& named_paths() {
  using V = NiemunisVariables;
  static const std::map<std::string, NamedPath> paths{
      {"*OedometricE1", {V::cartesian, {}, 0}},
      {"*OedometricS1", {V::cartesian, {true}, 0}},
      {"*TriaxialE1", {V::cartesian, {false, true, true}, 0}},
      {"*TriaxialS1", {V::cartesian, {true, true, true}, 0}},
      {"*TriaxialUEq", {V::roscoe, {}, 1}},
      {"*TriaxialUq", {V::roscoe, {false, true}, 1}},
      {"*PureRelaxation", {V::cartesian, {}, -1}},
      {"*PureCreep", {V::cartesian, {true, true, true, true, true, true}, -1}},
      {"*UndrainedCreep", {V::roscoe, {false, true, true, true, true, true}, -1}}};
  return paths;
}

void read_named_path(NiemunisLines& lines, NiemunisStep& step, const NamedPath& path) {
  read_commons(lines, step, 0);
  step.variables = path.variables;
  step.is_stress = path.is_stress;
  if (path.given >= 0)
    step.change[static_cast<std::size_t>(path.given)] = lines.numbers(1, "what " + step.keyword + " prescribes")[0];
}

void read_restrictions(NiemunisLines& lines, NiemunisStep& step, const std::string&) {
  step.kind = Kind::restricted;
  read_commons(lines, step, 0);
  step.is_stress.fill(true);
  for (std::size_t i = 0; i < 6; ++i) {
    lines.need("restriction " + std::to_string(i + 1) + ", as sd1 + 3.0*ed2 = 10");
    read_restriction(lines.line(), lines.where(), i, step.restrictions);
  }
}

/// "1 3 * 0.5": a stress from the third column, times 0.5. Column 0: the variable does not change.
struct ImportedColumn {
  int column = 0;
  double factor = 1;
};

ImportedColumn read_imported_column(const NiemunisLines& lines, const NiemunisStep& step, std::size_t first, int most) {
  const std::size_t star = lines.line().find('*');
  const std::vector<NiemunisField> fields = lines.fields();
  if (fields.size() <= first) throw InputError(lines.where(), step.keyword, "the number of a column is missing");
  NiemunisField column = fields[first];
  column.text = column.text.substr(0, column.text.find('*'));
  ImportedColumn imported{niemunis_count(column, 0), 1};
  if (imported.column > most)
    throw InputError(column.where, step.keyword, "the file is said to have " + std::to_string(most) + " columns");
  if (star != std::string_view::npos) {
    const std::vector<NiemunisField> behind = lines.fields(star + 1);
    if (behind.empty()) throw InputError(lines.where(star), step.keyword, "a factor is missing behind '*'");
    imported.factor = niemunis_number(behind[0]);
  }
  return imported;
}

/// The lines of numbers of a file, without the lines before the first one that begins like a number.
std::vector<NumberLine> read_imported_lines(const std::string& file) {
  std::vector<NumberLine> lines = number_lines(read_table_bytes(file));
  const auto first = std::ranges::find_if(lines, [](const NumberLine& line) {
    return std::string_view("1234567890+-.").find(line.fields[0][0]) != std::string_view::npos;
  });
  lines.erase(lines.begin(), first);
  return lines;
}

/// "*ImportFile NAME | COLUMNS". The first line of numbers is the state at the begin.
void read_import(NiemunisLines& lines, NiemunisStep& step, const std::string& file) {
  step.kind = Kind::imported;
  const std::string_view line = lines.line();
  const std::size_t name = line.find_first_not_of(" \t", std::string_view("*ImportFile").size()), bar = line.find('|');
  const std::vector<NiemunisField> behind = lines.fields(bar == line.npos ? line.size() : bar + 1);
  if (behind.empty() || name >= bar)
    throw InputError(step.where, step.keyword, "write *ImportFile NAME | COLUMNS, the number of columns");
  const int most = niemunis_count(behind[0], 1);
  step.import.file = mtest_path(file, std::string(stripped(line.substr(name, bar - name))));
  read_commons(lines, step, -1e300);
  read_variables(lines, step);
  std::array<ImportedColumn, 7> columns;
  for (std::size_t i = 0; i < 6; ++i) {
    lines.need("0 or 1 and the column of variable " + std::to_string(i + 1));
    step.is_stress[i] = stress_or_strain(step, lines.fields()[0]);
    columns[i] = read_imported_column(lines, step, 1, most);
  }
  if (step.duration <= 0) {
    lines.need("the column of the time");
    columns[6] = read_imported_column(lines, step, 0, most);
  }
  const std::vector<NumberLine> rows = read_imported_lines(step.import.file);
  const std::size_t increments =
      std::min(static_cast<std::size_t>(step.increments), rows.empty() ? 0 : rows.size() - 1);
  step.import.changes.assign(increments, {});
  step.import.durations.assign(increments, step.duration);
  for (std::size_t i = 0; i < 7; ++i) {
    if (columns[i].column == 0) continue;
    const std::vector<double> values = column_values(rows, columns[i].column, step.import.file);
    for (std::size_t k = 0; k < increments; ++k) {
      const double change = (values[k + 1] - values[k]) * columns[i].factor;
      (i < 6 ? step.import.changes[k][i] : step.import.durations[k]) = change;
    }
  }
}

using StepReader = void (*)(NiemunisLines& lines, NiemunisStep& step, const std::string& file);

const std::map<std::string, StepReader>& step_readers() {
  static const std::map<std::string, StepReader> readers{{"*LinearLoad", read_linear},
                                                         {"*CirculatingLoad", read_circulating},
                                                         {"*DeformationGradient", read_gradient},
                                                         {"*ObeyRestrictions", read_restrictions},
                                                         {"*ImportFile", read_import}};
  return readers;
}

const std::map<std::string, std::string>& unserved_steps() {
  static const std::map<std::string, std::string> steps{
      {"*PerturbationsS", "each increment begins at the same state, which a path cannot say"},
      {"*PerturbationsE", "each increment begins at the same state, which a path cannot say"},
      {"*RandomWalk", "its increments are random numbers of the driver"},
      {"*ImpactTriaxialE1", "it is of one version of the driver only"}};
  return steps;
}

}  // namespace

NiemunisStep read_niemunis_step(NiemunisLines& lines, const std::string& file) {
  const std::string_view line = lines.line();
  const std::size_t question = line.find('?');
  const NiemunisField word = lines.fields().empty() ? NiemunisField{"", lines.where()} : lines.fields().front();
  NiemunisStep step;
  step.keyword = word.text.substr(0, word.text.find('?'));
  if (step.keyword.starts_with("*ImportFile")) step.keyword = "*ImportFile";
  step.where = word.where;
  if (question != line.npos) step.exit = read_exit(line.substr(question + 1), lines.where(question + 1));
  const auto reader = step_readers().find(step.keyword);
  const auto path = named_paths().find(step.keyword);
  const auto unserved = unserved_steps().find(step.keyword);
  if (reader != step_readers().end()) {
    reader->second(lines, step, file);
  } else if (path != named_paths().end()) {
    read_named_path(lines, step, path->second);
  } else if (unserved != unserved_steps().end()) {
    throw InputError(step.where, step.keyword, "is not served: " + unserved->second);
  } else {
    const std::string what = step.keyword.starts_with("*") ? unknown("keyword", step.keyword, niemunis_keywords())
                                                           : "a keyword as *LinearLoad belongs here";
    throw InputError(step.where, "", what + ": '" + one_line(step.keyword, 60) + "'", joined(niemunis_keywords()));
  }
  return step;
}

const std::vector<std::string>& niemunis_keywords() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"*End", "*Repetition"};
    for (const auto& each : step_readers()) all.push_back(each.first);
    for (const auto& each : named_paths()) all.push_back(each.first);
    std::sort(all.begin(), all.end());
    return all;
  }();
  return names;
}

}  // namespace assay::drivers
