// SPDX-License-Identifier: BSD-3-Clause
// What is found, as text of 80 columns and as JUnit's XML.
#include <fmt/core.h>
#include <algorithm>
#include <filesystem>

#include "drivers/findings/findings.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

std::string figure(const Figure& value, const Scale& scale = {}) {
  return value ? rounded_text(scale.from_si(*value), 3) : "-";
}

/// With its unit.
std::string figure_text(const Figure& value, const Units& units, const char* si) {
  return figure(value, units.scale(si)) + " " + units.name(si);
}

std::string error_row(const std::string& name, const std::string& half, const std::string& end, const std::string& l2,
                      const std::string& linf = {}) {
  return table_line(fmt::format("  {:22} {:>10} {:>10} {:>10} {:>12}", name, half, end, l2, linf));
}

std::string error_lines(const ErrorFigures& e, const Units& units) {
  const Scale length = units.scale("m");
  const auto headed = [&](const char* name, const char* si) { return name + (" [" + units.name(si) + "]"); };
  std::string text = error_row("error", "at T/2", "at end", "max L2", "max Linf") +
                     error_row(headed("displacement", "m"), figure(e.l2_half, length), figure(e.l2_end, length),
                               figure(e.l2_max, length), figure(e.linf_max, length)) +
                     error_row("  rms, all particles", figure(e.rms36_half, length), figure(e.rms36_end, length),
                               figure(e.rms36_max, length));
  struct Maximum {
    const char *name, *si;
    const FieldMaximum& of;
  };
  const Maximum maxima[] = {{"velocity", "m/s", e.velocity},
                            {"F", "1", e.deformation_gradient},
                            {"det F", "1", e.jacobian},
                            {"Cauchy stress", "Pa", e.stress}};
  for (const auto& [name, si, of] : maxima) {
    const Scale scale = units.scale(si);
    text += error_row(headed(name, si), "", "", figure(of.l2_max, scale), figure(of.linf_max, scale));
  }
  if (e.relative) text += error_row("relative to the motion", "", "", figure(e.relative));
  return text;
}

std::string work_line(const Result& r) {
  return fmt::format("  {} steps of {}, {} particles stepped\n{}  {} million particle-steps/s\n",
                     r.steps ? grouped_text(*r.steps) : "-", figure_text(r.dt, r.units, "s"),
                     r.moving_particles ? grouped_text(*r.moving_particles) : "-", times_text(r, "stepping"),
                     r.particle_steps_per_s ? rounded_text(*r.particle_steps_per_s * 1e-6, 3) : "-");
}

std::string profile_lines(const Result& r) {
  std::string text;
  for (const PassFigures& pass : r.passes) {
    const double nanoseconds = r.particle_steps > 0 ? 1e9 * pass.seconds / static_cast<double>(r.particle_steps) : 0;
    text += fmt::format("  {:26} {:>9} s {:>8} ns and {:>4} bytes a particle-step\n", pass.name,
                        rounded_text(pass.seconds, 3), rounded_text(nanoseconds, 3), pass.bytes_per_particle);
  }
  return text;
}

std::string summary_of(const Result& result) {
  if (exit_status(result) != 0) return "NOT AS EXPECTED";
  return result.expect.empty() ? "NOTHING WAS EXPECTED" : "AS EXPECTED";
}

std::string outcome_text(const Result& result) {
  std::string text = (result.title.empty() ? "" : result.title + ": ") + result.outcome;
  if (result.t) text += " at t = " + figure_text(result.t, result.units, "s");
  return wrapped(text + ": " + summary_of(result), "", "  ") + expectations_text(result, false);
}

std::string reason_text(const Result& result) {
  return result.reason.empty() ? "" : wrapped(result.reason, "  ", "  ");
}

}  // namespace

std::string times_text(const Result& result, const std::string& work) {
  const std::string times =
      fmt::format("{} s: set-up {} s, {} {} s, {}pictures and files {} s",
                  rounded_text(result.setup_s + result.wall_s + result.finish_s, 3), rounded_text(result.setup_s, 3),
                  work, rounded_text(result.wall_s - result.observed_s, 3), result.observed_s > 0 ? "errors, " : "",
                  rounded_text(result.finish_s + result.observed_s, 3));
  return wrapped(times, "  ", "    ");
}

std::string process_lines(const Result& result, const std::string& folder) {
  const auto there = [&](const std::string& file) { return one_line((std::filesystem::path(folder) / file).string()); };
  std::string text;
  for (const std::string& warning : result.warnings) text += wrapped("warning: " + warning, "  ", "    ");
  if (!result.replay.empty()) {
    const bool scene = result.replay == "replay_scene.yaml";
    text += (result.failed_step ? "  the failing step is in "
             : scene            ? "  to see each of its last steps: assay run "
                                : "  to repeat it: assay check --replay ") +
            there(result.replay) + "\n";
  }
  if (!result.last_good.empty()) text += "  the particles before the failure: " + there(result.last_good) + "\n";
  if (!result.advice.empty()) text += wrapped(result.advice, "  to try: ", "    ");
  if (!result.printed.empty()) text += std::string("  what the model printed is in ") + there(material_log) + "\n";
  return text;
}

std::string sheet_text(const SheetFigures& sheet) {
  const bool missed = !(sheet.error_tau <= sheet.asked) || !(sheet.error_dtau.value_or(0) <= sheet.asked);
  const std::string asked = missed ? " (asked: " + rounded_text(sheet.asked, 2) + ")" : "";
  if (!sheet.along.empty()) {
    return wrapped(fmt::format("response: {}, error {} of tau{}", sheet.along, rounded_text(sheet.error_tau, 2), asked),
                   "  ", "    ");
  }
  const std::string of_b = sheet.error_b ? fmt::format(", {} of b", rounded_text(*sheet.error_b, 2)) : "";
  return wrapped(
      fmt::format("sheet: {} points, error {} of tau, {} of d tau/d xi{}{}, {} s{}", grouped_text(sheet.points),
                  rounded_text(sheet.error_tau, 2), rounded_text(*sheet.error_dtau, 2), of_b, asked,
                  rounded_text(sheet.wall_s, 2), sheet.cached ? " from disk" : ""),
      "  ", "    ");
}

std::string expectations_text(const Result& result, bool that_hold) {
  std::string text;
  for (const ExpectationOutcome& e : result.expect) {
    if (e.holds != that_hold) continue;
    text +=
        fmt::format("  {:5} {} {}: found {}\n", e.holds ? "holds" : "FAILS", e.key, e.expected, shortened(e.found, 4));
  }
  return text;
}

std::string said_of(const Result& result, const SceneOptions& options, const std::string& text) {
  if (!options.quiet()) return text;
  return exit_status(result) == 0 ? "" : outcome_text(result) + reason_text(result);
}

std::string verdict_text(const Result& result, const std::string& folder, bool with_profile) {
  std::string text = outcome_text(result);
  if (!result.subject.empty()) text += wrapped(result.subject, "  ", "    ");
  text += reason_text(result);
  text += process_lines(result, folder);
  if (result.error.l2_max) text += error_lines(result.error, result.units);
  if (result.steps) text += work_line(result);
  if (result.sheet) text += sheet_text(*result.sheet);
  if (result.rim) {
    text += fmt::format("  plastic rim: {} wide, {} cells{}\n", result.units.text(result.rim->width, "m", 3),
                        rounded_text(result.rim->cells, 2), result.rim->cells < fewest_rim_cells ? ": too few" : "");
  }
  if (with_profile) text += profile_lines(result);
  text += expectations_text(result, true);
  text += fmt::format("{}; results in {}\n", summary_of(result), one_line(folder));
  return text;
}

namespace fs = std::filesystem;

namespace {

std::string stem_of_scene(const RunOptions& options) { return fs::path(options.scene).stem().string(); }

/// "the run was unstable: why"; empty of one that has reached its end.
std::string death_sentence(const Result& result) {
  if (result.outcome == "completed") return {};
  const std::string how = result.outcome == "material_failed" ? "the material failed" : "the run was " + result.outcome;
  return result.reason.empty() ? how : how + ": " + result.reason;
}

/// An early end that the scene expects is none to complain of.
JunitCase outcome_case(const Result& result, const std::string& classname, double seconds) {
  using enum JunitCase::Kind;
  const bool expected =
      std::ranges::any_of(result.expect, [](const auto& line) { return line.key == "outcome" && line.holds; });
  if (result.outcome == "completed" || expected) return {classname, "outcome", seconds};
  return {classname,     "outcome", seconds, result.outcome == "refused" ? error : failure, death_sentence(result),
          result.outcome};
}

/// The same name whatever number is expected, so that CI knows the test again.
std::string name_of_line(const ExpectationOutcome& line) {
  const bool is_number = figure_of_result(line.key).kind == Field::Kind::number;
  return line.key + " " + (is_number ? line.expected.substr(0, line.expected.find(' ')) : "equals");
}

JunitCase expectation_case(const Result& result, const ExpectationOutcome& line, const std::string& classname) {
  using enum JunitCase::Kind;
  if (line.holds) return {classname, name_of_line(line)};
  const bool never_tried = result.outcome == "refused" && line.found == "null";
  const std::string death = death_sentence(result);
  const std::string message =
      line.key + ": expected " + line.expected + ", found " + line.found + (death.empty() ? "" : "; " + death);
  return {classname, name_of_line(line),
          0,         never_tried ? error : failure,
          message,   never_tried ? result.outcome : "expectation"};
}

/// Whether a path names a file of the result.
bool is_of_the_result(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const auto real = [&](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path), error); };
  const std::string name = file.filename().string();
  if (real(file) != real(folder / name)) return false;
  const std::vector<std::string> names = result_files();
  return std::ranges::any_of(names, [&name](const std::string& pattern) {
    return matches(pattern.starts_with('+') ? pattern.substr(1) : pattern, name);
  });
}

}  // namespace

std::string run_junit(const Result& result, const RunOptions& options, double seconds) {
  const std::string& given = options.junit_name;
  const std::string stem = given.empty() ? stem_of_scene(options) : given, classname = "assay.run." + stem;
  JunitSuite suite{"assay run " + (result.title.empty() || !given.empty() ? stem : result.title), "assay.run"};
  suite.seconds = seconds;
  suite.properties = {{"scene", options.scene}, {"results", options.out}, {"subject", result.subject}};
  suite.cases.push_back(outcome_case(result, classname, seconds));
  for (const ExpectationOutcome& line : result.expect) suite.cases.push_back(expectation_case(result, line, classname));
  suite.said = verdict_text(result, options.out);
  return junit_text({suite});
}

void refuse_junit_in_the_way(const RunOptions& options) {
  if (options.junit.empty()) return;
  const std::string shown = "'" + one_line(options.junit, 60) + "'";
  if (options.junit == "-") {
    if (options.json) throw InputError({}, "--junit", "takes the standard output that --json takes: " + shown);
    return;
  }
  refuse_input_as_output(options.junit, "--junit");
  if (is_of_the_result(options.junit, options.out))
    throw InputError({}, "--junit", "is a file of the result: " + shown);
}

}  // namespace assay::drivers
