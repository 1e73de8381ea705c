// SPDX-License-Identifier: BSD-3-Clause
// What a patch test found is judged by what the method promises.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mpm/patch/patch.hpp"

namespace assay::mpm {

check::TestResult judged(const Method& method, const std::string& id, const Figure& figure, double threshold,
                         const std::string& broken) {
  check::TestResult result{.id = id, .order = figure.order, .sentence = figure.sentence};
  if (!std::isnan(figure.measure)) result.measure = figure.measure;
  const std::string reason = exemption(method, id);
  if (!reason.empty()) {
    result.verdict = check::Verdict::not_applicable;
    result.sentence += "; not promised: " + reason;
    return result;
  }
  result.threshold = threshold;
  if (!(figure.measure <= threshold)) {
    result.verdict = check::Verdict::fail;
    result.cause = broken;
  }
  return result;
}

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

bool MethodReport::passes() const {
  return std::none_of(tests.begin(), tests.end(),
                      [](const auto& test) { return test.verdict == check::Verdict::fail; });
}

}  // namespace assay::mpm
