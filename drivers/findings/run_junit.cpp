// SPDX-License-Identifier: BSD-3-Clause
// A run as JUnit's XML.
#include <algorithm>
#include <filesystem>

#include "drivers/findings/findings.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

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
  JunitCase out{classname, "outcome", seconds};
  const bool expected = std::any_of(result.expect.begin(), result.expect.end(),
                                    [](const auto& line) { return line.key == "outcome" && line.holds; });
  if (result.outcome == "completed" || expected) return out;
  out.kind = result.outcome == "refused" ? JunitCase::Kind::error : JunitCase::Kind::failure;
  out.message = death_sentence(result);
  out.type = result.outcome;
  return out;
}

/// The same name whatever number is expected, so that CI knows the test again.
std::string name_of_line(const ExpectationOutcome& line) {
  const bool is_number = figure_of_result(line.key).kind == Field::Kind::number;
  return line.key + " " + (is_number ? line.expected.substr(0, line.expected.find(' ')) : "equals");
}

JunitCase expectation_case(const Result& result, const ExpectationOutcome& line, const std::string& classname) {
  JunitCase out{classname, name_of_line(line)};
  if (line.holds) return out;
  const bool never_tried = result.outcome == "refused" && line.found == "null";
  const std::string death = death_sentence(result);
  out.kind = never_tried ? JunitCase::Kind::error : JunitCase::Kind::failure;
  out.message =
      line.key + ": expected " + line.expected + ", found " + line.found + (death.empty() ? "" : "; " + death);
  out.type = never_tried ? result.outcome : "expectation";
  return out;
}

/// Whether a path names a file of the result.
bool is_of_the_result(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const auto real = [&](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path), error); };
  const std::string name = file.filename().string();
  if (real(file) != real(folder / name)) return false;
  const std::vector<std::string> names = result_files();
  return std::any_of(names.begin(), names.end(), [&name](const std::string& pattern) {
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
  for (const ExpectationOutcome& line : result.expect) {
    suite.cases.push_back(expectation_case(result, line, classname));
  }
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
  if (is_of_the_result(options.junit, options.out)) {
    throw InputError({}, "--junit", "is a file of the result: " + shown);
  }
}

}  // namespace assay::drivers
