// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/call_steps.hpp"

#include <cmath>
#include <cstdint>

#include "harness/material/state_variable.hpp"

namespace assay::check {

namespace {

Steps room_for(std::size_t n, std::size_t size, double dt) {
  return {n, size, std::vector<double>(9 * n), std::vector<double>(9 * n), std::vector<double>(size * n), 0.5, dt};
}

/// Point p of a batch of n.
void put(const FailedStep& step, Steps& batch, std::size_t p) {
  put_tensor(step.F0, batch.F0.data(), batch.n, p);
  put_tensor(step.F1, batch.F1.data(), batch.n, p);
  for (std::size_t c = 0; c < batch.size; ++c) batch.state0[c * batch.n + p] = step.state0[c];
}

}  // namespace

Steps sheared_steps(const Specimen& specimen, std::size_t n) {
  Steps steps = room_for(n, specimen.material->state_size(), 0.05);
  const std::size_t planes = specimen.space.is_plane() ? 1 : 3;
  for (std::size_t p = 0; p < n; ++p) {
    const auto sheared = [&](double by) {
      constexpr int place[] = {1, 5, 6};
      Tensor F = Tensor::Identity();
      component(F, place[p % planes]) = specimen.amplitude * by;
      return F;
    };
    const double share = 0.3 * static_cast<double>(p + 1) / static_cast<double>(n);
    const Tensor before = sheared(share), after = sheared(share + 0.05);
    const Point at = stepped(specimen, 0, steps.t, Tensor::Identity(), before, specimen.rest_state());
    put({steps.t, steps.dt, before, after, at.state}, steps, p);
  }
  return steps;
}

Steps steps_along(const Specimen& specimen, std::size_t n) {
  Steps steps = room_for(n, specimen.material->state_size(), 1.0 / static_cast<double>(n));
  std::vector<double> state = specimen.rest_state();
  const auto F = [&](std::size_t k) {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    return Tensor(specimen.space.turn(1.3 * s) * specimen.stretch(s));
  };
  for (std::size_t p = 0; p < n; ++p) {
    const FailedStep step{steps.t, steps.dt, F(p), F(p + 1), state};
    put(step, steps, p);
    state = stepped(specimen, step).state;
  }
  return steps;
}

Steps steps_from_rest(const Specimen& specimen, std::size_t n, double amplitude) {
  Steps steps = room_for(n, specimen.material->state_size(), 1);
  steps.t = 0;
  for (std::size_t p = 0; p < n; ++p) {
    const double s = (static_cast<double>(p) + 1) / static_cast<double>(n);
    put({0, 1, Tensor::Identity(), specimen.space.stretch(amplitude, s), specimen.rest_state()}, steps, p);
  }
  return steps;
}

namespace {

/// n points, of which point p has step (p + first) % steps.n.
Steps taken_from(const Steps& steps, std::size_t n, std::size_t first) {
  Steps taken = room_for(n, steps.size, steps.dt);
  const auto copy = [&](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t k = 0; k < to.size(); ++k) to[k] = from[k / n * steps.n + (k % n + first) % steps.n];
  };
  copy(steps.F0, taken.F0);
  copy(steps.F1, taken.F1);
  copy(steps.state0, taken.state0);
  return taken;
}

}  // namespace

Steps one_of(const Steps& steps, std::size_t p) { return taken_from(steps, 1, p); }

Steps later_of(const Steps& steps) { return taken_from(steps, steps.n - 1, 1); }

Steps many_of(const Steps& steps, std::size_t n) { return taken_from(steps, n, 0); }

std::size_t bytes_to_place(const void* at, std::size_t bytes) {
  const auto address = reinterpret_cast<std::uintptr_t>(at);
  return (cache_line + bytes - address % cache_line) % cache_line;
}

std::vector<Result> together(const Material& material, const Steps& steps, std::size_t bytes) {
  const std::size_t n = steps.n;
  Placed F0(steps.F0, bytes), F1(steps.F1, bytes), state0(steps.state0, bytes),
      cauchy(std::vector<double>(9 * n), bytes), state1(std::vector<double>(steps.size * n), bytes);
  const UpdateReport report =
      material.update(steps.t, steps.dt, n, F0.data(), F1.data(), state0.data(), state1.data(), cauchy.data());
  std::vector<Result> results(n, Result(9 + steps.size, NAN));
  if (report.worst == ASSAY_FAILED) return results;
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) results[p][c] = cauchy.data()[c * n + p];
    for (std::size_t c = 0; c < steps.size; ++c) results[p][9 + c] = state1.data()[c * n + p];
  }
  return results;
}

Result alone(const Material& material, const Steps& steps, std::size_t p, std::size_t bytes) {
  return together(material, one_of(steps, p), bytes).front();
}

std::vector<Result> one_by_one(const Material& material, const Steps& steps) {
  std::vector<Result> results;
  for (std::size_t p = 0; p < steps.n; ++p) results.push_back(alone(material, steps, p));
  return results;
}

Comparison::Comparison(const assay_material& table, const std::vector<Result>& expected)
    : expected_(expected), scales_(expected.empty() ? 9 : expected[0].size(), 0.0) {
  for (const Result& result : expected) {
    for (std::size_t c = 0; c < result.size(); ++c) scales_[c] = std::max(scales_[c], std::abs(result[c]));
  }
  const auto share_largest = [&](std::size_t begin, std::size_t size) {
    const auto first = scales_.begin() + static_cast<std::ptrdiff_t>(begin),
               last = first + static_cast<std::ptrdiff_t>(size);
    std::fill(first, last, *std::max_element(first, last));
  };
  share_largest(0, 9);
  for (const StatePlace& place : state_of(table)) {
    if (9 + place.first < scales_.size()) share_largest(9 + place.first, place.size);
  }
}

double Comparison::difference(std::size_t p, const Result& found) const {
  double worst = 0;
  for (std::size_t c = 0; c < found.size(); ++c) {
    if (!std::isfinite(found[c]) && !std::isfinite(expected_[p][c])) continue;
    const double d = std::abs(found[c] - expected_[p][c]) / (scales_[c] > 0 ? scales_[c] : 1);
    worst = d <= worst ? worst : std::isfinite(d) ? d : INFINITY;
  }
  return worst;
}

}  // namespace assay::check
