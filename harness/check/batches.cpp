// SPDX-License-Identifier: BSD-3-Clause
// That a point's answer is its own: not that of its place in a batch, of the size of that, of where arrays lie, or of
// another thread.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <thread>
#include <utility>

#include "harness/check/tests.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/material/stack_below.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay::check {

namespace {

/// The largest first, which tell most, then those beside powers of two and small ones: code that works on some points
/// at a time begins and ends anew there.
std::vector<std::size_t> sizes() {
  std::vector<std::size_t> all{4096, 4095, 2049};
  for (std::size_t n = 2; n <= 34; ++n) all.push_back(n);
  all.insert(all.end(), {63,  64,  65,  100, 127, 128,  129,  137,  200,  255,  256,  257,  500,
                         511, 512, 513, 700, 999, 1023, 1024, 1025, 1501, 2001, 2047, 2048, 3000});
  return all;
}

/// Steps one by one.
struct Expected {
  Steps steps;
  std::vector<Result> results;
};

Expected expected_of(const Specimen& specimen, Steps steps) {
  std::vector<Result> results = one_by_one(*specimen.material, steps);
  return {std::move(steps), std::move(results)};
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
  const Expected expected = expected_of(specimen, later_of(steps_along(specimen, quick ? 12 : 40)));
  const std::int64_t begin = now_ns();
  const auto since = [begin] { return 1e-9 * static_cast<double>(now_ns() - begin); };
  if (!tried(specimen, expected, least, finding)) return finding;
  const double step_s = since() / static_cast<double>(least);
  const double allowed_s = since() + std::max(brief_s, share * step_s);
  for (const std::size_t n : sizes()) {
    if (n > few && since() + static_cast<double>(n) * step_s > allowed_s) continue;
    if (!tried(specimen, expected, n, finding)) break;
  }
  return finding;
}

/// As `judge`, of a material that may refuse to be loaded while it rotates.
TestResult while_it_turns(const std::function<TestResult()>& judge) {
  return if_taken(judge, left_out("the model cannot be loaded while it rotates"));
}

/// What such a finding says.
std::string words_of(const BatchFinding& finding) {
  if (!finding.refusal.empty()) {
    return "a batch of " + std::to_string(finding.n) +
           " points that are loaded alike is refused, and a point alone is not: " + finding.refusal;
  }
  return where(finding) + " otherwise than alone; the difference is " + rounded(finding.worst) +
         " of the largest stress: the points of a batch influence each other";
}

}  // namespace

TestResult batches(const Specimen& specimen, const BatchFinding& alike) {
  return while_it_turns([&] {
    const BatchFinding finding = alike.wrong > 0 ? alike : find_in_batches(specimen, alike);
    return finding.wrong > 0 ? failed(causes::of_batch, finding.worst, same_in_batch, words_of(finding))
                             : passed(finding.worst, same_in_batch,
                                      "each point of a batch of up to " + std::to_string(finding.largest) +
                                          " points has the same result as alone");
  });
}

namespace {

/// The largest difference that such a place of the arrays makes, in a batch and of single steps.
double effect_of_place(const Material& material, const Expected& expected, const std::vector<Result>& batch,
                       std::size_t bytes) {
  Difference difference;
  const Comparison with_batch(material.table(), batch), with_single(material.table(), expected.results);
  const std::vector<Result> found = together(material, expected.steps, bytes);
  difference.note(with_batch, found, "");
  for (std::size_t p = 0; p < expected.steps.n; p += 4) {
    difference.note(with_single.difference(p, alone(material, expected.steps, p, bytes)), "");
  }
  return difference.worst;
}

}  // namespace

/// Arrays that begin 8, 16, 32 bytes ... beyond a multiple of 64 give the same, but for rounding.
TestResult alignment(const Specimen& specimen) {
  return while_it_turns([&] {
    const Expected expected = expected_of(specimen, steps_along(specimen, specimen.options.effort.quick ? 9 : 37));
    const std::vector<Result> batch = together(*specimen.material, expected.steps);
    double worst = 0;
    std::size_t place = 0;
    for (const std::size_t bytes : {8, 16, 24, 32, 48}) {
      const double effect = effect_of_place(*specimen.material, expected, batch, bytes);
      if (effect > worst) worst = effect, place = bytes;
    }
    return judged(worst, same_in_batch, "the result does not depend on the addresses of the arrays",
                  causes::of_alignment,
                  "if the arrays of a step begin " + std::to_string(place) +
                      " bytes beyond a multiple of 64, and not at a multiple, the result differs by " + rounded(worst) +
                      " of the largest stress");
  });
}

namespace {

constexpr int at_once = 2;

/// Stress and state of all points; nothing where one is refused.
std::vector<double> taken(const Material& material, const Steps& batch) {
  std::vector<double> all((9 + material.state_size()) * batch.n);
  const UpdateReport report = material.update(batch.t, batch.dt, batch.n, batch.F0.data(), batch.F1.data(),
                                              batch.state0.data(), all.data() + 9 * batch.n, all.data());
  return report.worst == ASSAY_FAILED ? std::vector<double>() : all;
}

/// Over the largest of all.
double difference(const std::vector<double>& expected, const std::vector<double>& found) {
  if (found.size() != expected.size()) return INFINITY;
  double scale = 0, worst = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    scale = std::max(scale, std::abs(expected[k]));
    worst = std::max(worst, std::abs(found[k] - expected[k]));
  }
  return scale > 0 ? worst / scale : worst;
}

/// Until all threads have begun, or long enough: where all cores are in use one might end before the other begins.
void await_others(std::atomic<int>& begun) {
  constexpr std::int64_t patience_ns = 200'000'000;
  const std::int64_t begin = now_ns();
  ++begun;
  while (begun < at_once && now_ns() - begin < patience_ns) std::this_thread::yield();
}

/// The largest difference that a thread meets in so many calls.
double in_threads(const Material& material, const std::vector<Steps>& batches,
                  const std::vector<std::vector<double>>& expected, int calls) {
  std::deque<Material> own;
  for (int k = 0; k < at_once; ++k) own.push_back(material.clone());
  std::vector<double> worst(batches.size(), 0);
  std::atomic<bool> found{false};
  std::atomic<int> begun{0};
  for_each_index(at_once, {.threads = at_once}, [&](int thread) {
    const OverStack zeros(0);  // as in the thread of the tests
    const auto k = static_cast<std::size_t>(thread);
    const Material& mine = material.has(ASSAY_THREAD_SAFE) ? own.front() : own[k];
    await_others(begun);
    for (int call = 0; call < calls && !found; ++call) {
      worst[k] = std::max(worst[k], difference(expected[k], taken(mine, batches[k])));
      if (worst[k] > 0) found = true;
    }
  });
  return *std::max_element(worst.begin(), worst.end());
}

TestResult judged_threads(const Material& material, double worst) {
  constexpr double most = 1e-12;  // as in calls.repeated
  return judged(worst, most, "two threads at once get the same results as one thread", causes::hidden_state,
                "the same steps in two threads at once differ by " + rounded(worst) + ": " +
                    (material.has(ASSAY_THREAD_SAFE)
                         ? "ASSAY_THREAD_SAFE is declared, but both threads write to the same data"
                         : "data is kept outside the instance, although each thread has its own instance"));
}

}  // namespace

/// Two threads at once get what each gets alone: of one instance with ASSAY_THREAD_SAFE, each of its own without. A
/// race is met by chance: none that is short is sure to be found.
TestResult threads(const Specimen& specimen) {
  constexpr std::size_t points = 256;
  if (specimen.options.declarations.guesses_roles) {
    return left_out("foreign routines run in processes of their own, not in threads");
  }
  constexpr int smaller = 6;
  double amplitude = specimen.amplitude;
  for (int k = 0; k < smaller; ++k, amplitude *= 0.5) {
    const std::vector<Steps> batches{steps_from_rest(specimen, points, amplitude),
                                     steps_from_rest(specimen, points, -amplitude)};
    const std::int64_t begin = now_ns();
    const std::vector<std::vector<double>> expected{taken(specimen, batches[0]), taken(specimen, batches[1])};
    if (expected[0].empty() || expected[1].empty()) continue;
    const double pair_s = 1e-9 * static_cast<double>(now_ns() - begin);
    const double long_enough = specimen.options.effort.quick ? 0.03 : 0.06;  // [s], many slices of a scheduler
    const int calls = static_cast<int>(std::clamp(long_enough / pair_s, 2.0, 1e5));
    return judged_threads(specimen, in_threads(specimen, batches, expected, calls));
  }
  return left_out("no batch of moderate steps from rest is taken");
}

}  // namespace assay::check
