// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/niemunis_file.hpp"

#include <cmath>
#include <numbers>

#include "drivers/point_drivers/niemunis_steps.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr int most_steps_repeated = 10000;
constexpr int most_variables = 1'000'000;

bool is_end(const NiemunisLines& lines) { return small_letters(lines.fields().front().text) == "*end"; }

/// "*Repetition" is the present line: the next one says how many steps are repeated, and how often.
NiemunisBlock read_repetition(NiemunisLines& lines, const std::string& file) {
  const Location where = lines.where();
  lines.need("the numbers of steps and of repetitions");
  const std::vector<NiemunisField> fields = lines.fields();
  if (fields.size() < 2) throw InputError(lines.where(), "*Repetition", "2 numbers are needed: steps, repetitions");
  const int steps = niemunis_count(fields[0], 1);
  if (steps > most_steps_repeated) throw InputError(fields[0].where, "*Repetition", "too many steps");
  NiemunisBlock block;
  block.repetitions = niemunis_count(fields[1], 1);
  for (int i = 0; i < steps; ++i) {
    if (!lines.next() || is_end(lines))
      throw InputError(where, "*Repetition", "has " + std::to_string(i) + " of " + std::to_string(steps) + " steps");
    if (lines.fields().front().text == "*Repetition")
      throw InputError(lines.where(), "*Repetition", "cannot be repeated itself");
    block.steps.push_back(read_niemunis_step(lines, file));
  }
  return block;
}

/// Before a '#', without blanks at its ends.
std::string before_remark(std::string_view line) { return std::string(stripped(line.substr(0, line.find('#')))); }

}  // namespace

SixBySix niemunis_matrix(NiemunisVariables variables) {
  SixBySix matrix{};
  for (std::size_t i = 0; i < 6; ++i) matrix[i][i] = 1;
  const double s2 = std::sqrt(2.0), s3 = std::sqrt(3.0), s6 = std::sqrt(6.0);
  switch (variables) {
    case NiemunisVariables::cartesian:
      break;
    case NiemunisVariables::roscoe:
      matrix[0] = {-1.0 / 3, -1.0 / 3, -1.0 / 3, 0, 0, 0};
      matrix[1] = {-1, 0.5, 0.5, 0, 0, 0};
      matrix[2] = {0, -1, 1, 0, 0, 0};
      break;
    case NiemunisVariables::roscoe_isomorph:
      matrix[0] = {-1 / s3, -1 / s3, -1 / s3, 0, 0, 0};
      matrix[1] = {-2 / s6, 1 / s6, 1 / s6, 0, 0, 0};
      matrix[2] = {0, -1 / s2, 1 / s2, 0, 0, 0};
      break;
    case NiemunisVariables::rendulic:
      matrix[0] = {-1, 0, 0, 0, 0, 0};
      matrix[1] = {0, -1 / s2, -1 / s2, 0, 0, 0};
      matrix[2] = {0, -1 / s2, 1 / s2, 0, 0, 0};
  }
  return matrix;
}

double niemunis_change(const NiemunisStep& step, std::size_t variable, double begin, double elapsed) {
  double change = step.duration > 0 ? step.change[variable] * (elapsed / step.duration) : step.change[variable];
  if (step.kind == NiemunisStep::Kind::circulating) {
    const double frequency = 2 * std::numbers::pi / step.duration, phase = step.phase[variable];
    change += step.amplitude[variable] *
              (std::sin(frequency * (begin + elapsed) + phase) - std::sin(frequency * begin + phase));
  }
  return change;
}

NiemunisFile niemunis_from_text(const std::string& text, const std::string& file) {
  NiemunisLines lines(text, file);
  NiemunisFile out;
  out.file = file;
  lines.need("the name of the output");
  const std::size_t hash = lines.line().find('#');
  out.output = before_remark(lines.line());
  if (hash != std::string_view::npos) out.heading = stripped(lines.line().substr(hash + 1));
  if (out.output.starts_with("*"))
    throw InputError(lines.where(), "",
                     "the first line is the name of the output, found '" + one_line(out.output, 60) + "'");
  while (lines.next() && !is_end(lines)) {
    if (lines.fields().front().text == "*Repetition") {
      out.blocks.push_back(read_repetition(lines, file));
    } else {
      out.blocks.push_back({1, {read_niemunis_step(lines, file)}});
    }
  }
  if (out.blocks.empty()) throw InputError({file, 0, 0}, "", "has no step", joined(niemunis_keywords()));
  return out;
}

NiemunisFile read_niemunis(const std::string& file) { return niemunis_from_text(read_bytes(file), file); }

NiemunisStart niemunis_start_from_text(const std::string& text, const std::string& file) {
  NiemunisLines lines(text, file);
  NiemunisStart start;
  const int components = lines.count(1, "the number of components of the stress");
  if (components > 6) throw InputError(lines.where(), "", "a stress has at most 6 components");
  for (int i = 0; i < components; ++i)
    start.stress[static_cast<std::size_t>(i)] =
        lines.numbers(1, "component " + std::to_string(i + 1) + " of the stress")[0];
  lines.need("the number of state variables");
  if (const std::size_t equals = lines.line().find('='); equals != std::string_view::npos) {
    const std::vector<NiemunisField> behind = lines.fields(equals + 1);
    if (behind.empty()) throw InputError(lines.where(equals), "", "a temperature is missing behind '='");
    start.temperature = niemunis_number(behind[0]);
    lines.need("the number of state variables");
  }
  const int count = niemunis_count(lines.fields().front(), 0);
  if (count > most_variables) throw InputError(lines.where(), "", "too many state variables");
  start.state.assign(static_cast<std::size_t>(count), 0);
  for (double& value : start.state) {
    if (!lines.next()) break;
    value = niemunis_number(lines.fields().front());
  }
  return start;
}

NiemunisStart read_niemunis_start(const std::string& file) { return niemunis_start_from_text(read_bytes(file), file); }

NiemunisParameters niemunis_parameters_from_text(const std::string& text, const std::string& file) {
  NiemunisLines lines(text, file);
  NiemunisParameters parameters;
  lines.need("the name of the material");
  parameters.material = before_remark(lines.line());
  const int count = lines.count(0, "the number of parameters");
  for (int i = 0; i < count; ++i)
    parameters.values.push_back(
        lines.numbers(1, "parameter " + std::to_string(i + 1) + " of " + std::to_string(count))[0]);
  return parameters;
}

NiemunisParameters read_niemunis_parameters(const std::string& file) {
  return niemunis_parameters_from_text(read_bytes(file), file);
}

}  // namespace assay::drivers
