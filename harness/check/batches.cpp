// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/batches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/call_steps.hpp"
#include "harness/check/judge.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::check {

namespace {

/// The largest first, which tell most, then those beside powers of two and small ones: code that works on some points
/// at a time begins and ends anew there.
std::vector<std::size_t> sizes() {
  std::vector<std::size_t> all{4096, 4095, 2049};
  for (std::size_t n = 2; n <= 34; ++n) all.push_back(n);
  for (const std::size_t n : {63, 64, 65, 100, 127, 128, 129, 137, 200, 255, 256, 257, 500, 511, 512, 513}) {
    all.push_back(n);
  }
  for (const std::size_t n : {700, 999, 1023, 1024, 1025, 1501, 2001, 2047, 2048, 3000}) all.push_back(n);
  return all;
}

/// Steps one by one.
struct Expected {
  Steps steps;
  std::vector<Result> results;
};

Expected expected_of(const Specimen& specimen, Steps steps) {
  Expected expected{std::move(steps), {}};
  for (std::size_t p = 0; p < expected.steps.n; ++p) {
    expected.results.push_back(alone(*specimen.material, expected.steps, p));
  }
  return expected;
}

/// One batch, and whether all is well there.
bool tried(const Material& material, const Expected& expected, std::size_t n, BatchFinding& finding) {
  const Comparison with(material.table(), expected.results);
  const std::vector<Result> found = together(material, many_of(expected.steps, n));
  finding.largest = std::max(finding.largest, n);
  for (std::size_t p = 0; p < n; ++p) {
    const double difference = with.difference(p % expected.steps.n, found[p]);
    finding.worst = std::max(finding.worst, difference);
    if (difference <= same_in_batch) continue;
    if (finding.wrong++ == 0) finding.n = n, finding.point = p + 1;
  }
  return finding.wrong == 0;
}

/// "point 1501 of a batch of 4096 answers"
std::string where(const BatchFinding& finding) {
  const std::string batch = " of a batch of " + std::to_string(finding.n);
  if (finding.wrong == finding.n) return "every point" + batch + " answers";
  const std::string point = std::to_string(finding.point);
  if (finding.wrong == 1) return "point " + point + batch + " answers";
  return std::to_string(finding.wrong) + " points" + batch + ", the first of them point " + point + ", answer";
}

BatchFinding find_in_batches(const Specimen& specimen, BatchFinding finding) {
  const bool quick = specimen.options.effort.quick;
  const std::size_t least = quick ? 300 : 1037, few = 9;  // whatever they cost
  const double brief_s = quick ? 0.002 : 0.05;            // some hundredths of the battery
  const double share = quick ? 300.0 : 4200.0;            // of its updates, likewise
  const Material& material = *specimen.material;
  const Expected expected = expected_of(specimen, later_of(steps_along(specimen, quick ? 12 : 40)));
  const std::int64_t begin = now_ns();
  const auto since = [begin] { return 1e-9 * static_cast<double>(now_ns() - begin); };
  if (!tried(material, expected, least, finding)) return finding;
  const double step_s = since() / static_cast<double>(least);
  const double allowed_s = since() + std::max(brief_s, share * step_s);
  for (const std::size_t n : sizes()) {
    if (n > few && since() + static_cast<double>(n) * step_s > allowed_s) continue;
    if (!tried(material, expected, n, finding)) break;
  }
  return finding;
}

TestResult not_loaded_while_it_turns(const char* id) {
  return {.id = id, .verdict = Verdict::not_applicable, .sentence = "the model cannot be loaded while it rotates"};
}

}  // namespace

TestResult batches(const Specimen& specimen, const BatchFinding& alike) {
  constexpr const char* id = "calls.batch";
  try {
    const BatchFinding finding = alike.wrong > 0 ? alike : find_in_batches(specimen, alike);
    TestResult result{.id = id, .measure = finding.worst, .threshold = same_in_batch};
    result.sentence =
        "each point of a batch of up to " + std::to_string(finding.largest) + " points has the same result as alone";
    if (finding.wrong == 0) return result;
    result.verdict = Verdict::fail;
    result.cause = causes::of_batch;
    if (!finding.refusal.empty()) {
      result.sentence = "a batch of " + std::to_string(finding.n) +
                        " points that are loaded alike is refused, and a point alone is not: " + finding.refusal;
      return result;
    }
    result.sentence = where(finding) + " otherwise than alone; the difference is " + rounded(finding.worst) +
                      " of the largest stress: the points of a batch influence each other";
    return result;
  } catch (const MaterialFailure&) {
    return not_loaded_while_it_turns(id);
  }
}

namespace {

/// The largest difference that such a place of the arrays makes, in a batch and of single steps.
double effect_of_place(const Material& material, const Expected& expected, const std::vector<Result>& batch,
                       std::size_t bytes) {
  Difference difference;
  const Comparison with_batch(material.table(), batch), with_single(material.table(), expected.results);
  const std::vector<Result> found = together(material, expected.steps, bytes);
  for (std::size_t p = 0; p < expected.steps.n; ++p) difference.note(with_batch.difference(p, found[p]), "");
  for (std::size_t p = 0; p < expected.steps.n; p += 4) {
    difference.note(with_single.difference(p, alone(material, expected.steps, p, bytes)), "");
  }
  return difference.worst;
}

}  // namespace

TestResult alignment(const Specimen& specimen) {
  constexpr const char* id = "calls.alignment";
  try {
    const Expected expected = expected_of(specimen, steps_along(specimen, specimen.options.effort.quick ? 9 : 37));
    const std::vector<Result> batch = together(*specimen.material, expected.steps);
    TestResult result{.id = id, .measure = 0, .threshold = same_in_batch};
    result.sentence = "the result does not depend on the addresses of the arrays";
    std::size_t place = 0;
    for (const std::size_t bytes : {8, 16, 24, 32, 48}) {
      const double effect = effect_of_place(*specimen.material, expected, batch, bytes);
      if (effect > *result.measure) result.measure = effect, place = bytes;
    }
    if (*result.measure <= same_in_batch) return result;
    result.verdict = Verdict::fail;
    result.cause = causes::of_alignment;
    result.sentence = "if the arrays of a step begin " + std::to_string(place) +
                      " bytes beyond a multiple of 64, and not at a multiple, the result differs by " +
                      rounded(*result.measure) + " of the largest stress";
    return result;
  } catch (const MaterialFailure&) {
    return not_loaded_while_it_turns(id);
  }
}

}  // namespace assay::check
