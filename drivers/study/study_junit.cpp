// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_junit.hpp"

#include "drivers/output/junit.hpp"
#include "drivers/study/study_words.hpp"

namespace assay::drivers {

namespace {

/// Wall time of all repeats [s].
double seconds_of(const StudyCase& one) {
  double sum = 0;
  for (const double seconds : one.clock.wall_s) sum += seconds;
  return sum;
}

JunitCase test_of(const StudyFindings& findings, const StudyCase& one) {
  JunitCase out{"assay.study.cases", one.label, seconds_of(one)};
  out.message = one.reason.empty() ? outcome_text(one) : one.reason;
  out.type = one.outcome;
  if (one.outcome == "n/a") out.kind = JunitCase::Kind::skipped;
  if (one.outcome == "missing" || findings.ended_badly(one)) out.kind = JunitCase::Kind::failure;
  return out;
}

JunitCase test_of(const StudyExpectationOutcome& line) {
  JunitCase out{"assay.study.expect", line.where + ": " + line.outcome.key + " " + line.outcome.expected};
  if (line.outcome.holds) return out;
  out.kind = JunitCase::Kind::failure;
  out.message = line.outcome.key + ": expected " + line.outcome.expected + ", found " + line.outcome.found;
  out.type = "expectation";
  return out;
}

}  // namespace

std::string study_junit(const StudyFindings& findings) {
  JunitSuite suite{"assay study " + findings.title, "assay.study"};
  suite.properties = {{"question", findings.question}, {"error", findings.error_key}, {"cost", findings.cost_key}};
  for (const StudyCase& one : findings.cases) {
    suite.cases.push_back(test_of(findings, one));
    suite.seconds += suite.cases.back().seconds;
  }
  for (const StudyExpectationOutcome& line : findings.expect) suite.cases.push_back(test_of(line));
  for (const std::string& warning : findings.warnings) suite.said += warning + "\n";
  return junit_text({suite});
}

}  // namespace assay::drivers
