// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/threads.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <thread>

#include "harness/check/judge.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/parallel.hpp"

namespace assay::check {

namespace {

constexpr int at_once = 2;

/// Steps from rest, component-major, and what they give.
struct Batch {
  std::size_t n;
  std::vector<double> F0, F1, state0;
};

Batch batch_of(const Specimen& specimen, std::size_t n, double amplitude) {
  Batch batch{n, std::vector<double>(9 * n), std::vector<double>(9 * n), {}};
  const std::vector<double> rest = specimen.rest_state();
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = specimen.space.stretch(amplitude, (static_cast<double>(p) + 1) / static_cast<double>(n));
    for (std::size_t c = 0; c < 9; ++c) {
      batch.F0[c * n + p] = c % 4 == 0 ? 1 : 0;
      batch.F1[c * n + p] = component(F, static_cast<int>(c));
    }
  }
  for (const double value : rest) batch.state0.insert(batch.state0.end(), n, value);
  return batch;
}

/// Stress and state of all points; nothing where one is refused.
std::vector<double> taken(const Material& material, const Batch& batch) {
  std::vector<double> all((9 + material.state_size()) * batch.n);
  const UpdateReport report = material.update(0, 1, batch.n, batch.F0.data(), batch.F1.data(), batch.state0.data(),
                                              all.data() + 9 * batch.n, all.data());
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
double in_threads(const Material& material, const std::vector<Batch>& batches,
                  const std::vector<std::vector<double>>& expected, int calls) {
  std::deque<Material> own;
  for (int k = 0; k < at_once; ++k) own.push_back(material.clone());
  std::vector<double> worst(batches.size(), 0);
  std::atomic<bool> found{false};
  std::atomic<int> begun{0};
  for_each_index(at_once, {.threads = at_once}, [&](int thread) {
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

TestResult judged(const Material& material, double worst) {
  constexpr double most = 1e-12;  // as in calls.repeated
  TestResult result{.id = "calls.threads", .measure = worst, .threshold = most};
  result.sentence = "two threads at once get the same results as one thread";
  if (worst <= most) return result;
  const bool shared = material.has(ASSAY_THREAD_SAFE);
  result.verdict = Verdict::fail;
  result.cause = causes::hidden_state;
  result.sentence = "the same steps in two threads at once differ by " + rounded(worst) + ": " +
                    (shared ? "ASSAY_THREAD_SAFE is declared, but both threads write to the same data"
                            : "data is kept outside the instance, although each thread has its own instance");
  return result;
}

}  // namespace

TestResult threads(const Specimen& specimen) {
  constexpr std::size_t points = 256;
  const Material& material = *specimen.material;
  TestResult result{.id = "calls.threads", .verdict = Verdict::not_applicable};
  result.sentence = "foreign routines run in processes of their own, not in threads";
  if (specimen.options.declarations.guesses_roles) return result;
  result.sentence = "no batch of moderate steps from rest is taken";
  constexpr int smaller = 6;
  double amplitude = specimen.amplitude;
  for (int k = 0; k < smaller; ++k, amplitude *= 0.5) {
    const std::vector<Batch> batches{batch_of(specimen, points, amplitude), batch_of(specimen, points, -amplitude)};
    const std::int64_t begin = now_ns();
    const std::vector<std::vector<double>> expected{taken(material, batches[0]), taken(material, batches[1])};
    if (expected[0].empty() || expected[1].empty()) continue;
    const double pair_s = 1e-9 * static_cast<double>(now_ns() - begin);
    const double long_enough = specimen.options.effort.quick ? 0.03 : 0.06;  // [s], many slices of a scheduler
    const int calls = static_cast<int>(std::clamp(long_enough / pair_s, 2.0, 1e5));
    return judged(material, in_threads(material, batches, expected, calls));
  }
  return result;
}

}  // namespace assay::check
