// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/call_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "harness/check/march.hpp"

namespace assay::check {

namespace {

Steps room_for(std::size_t n, std::size_t size, double dt) {
  return {n, size, std::vector<double>(9 * n), std::vector<double>(9 * n), std::vector<double>(size * n), 0.5, dt};
}

void put(const Tensor& F, std::vector<double>& all, std::size_t n, std::size_t p) {
  for (int c = 0; c < 9; ++c) all[static_cast<std::size_t>(c) * n + p] = component(F, c);
}

}  // namespace

Steps sheared_steps(const Specimen& specimen, std::size_t n) {
  const Material& material = *specimen.material;
  Steps steps = room_for(n, material.state_size(), 0.05);
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
    put(before, steps.F0, n, p);
    put(after, steps.F1, n, p);
    const Point at = stepped(material, 0, steps.t, Tensor::Identity(), before, specimen.rest_state());
    for (std::size_t c = 0; c < steps.size; ++c) steps.state0[c * n + p] = at.state[c];
  }
  return steps;
}

Steps steps_along(const Specimen& specimen, std::size_t n) {
  const Material& material = *specimen.material;
  const std::size_t size = material.state_size();
  Steps steps = room_for(n, size, 1.0 / static_cast<double>(n));
  std::vector<double> state = specimen.rest_state();
  const auto F = [&](std::size_t k) {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    return Tensor(specimen.space.turn(1.3 * s) * specimen.space.stretch(specimen.amplitude, s));
  };
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor before = F(p), after = F(p + 1);
    put(before, steps.F0, n, p);
    put(after, steps.F1, n, p);
    for (std::size_t c = 0; c < size; ++c) steps.state0[c * n + p] = state[c];
    state = stepped(material, steps.t, steps.dt, before, after, state).state;
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
  return (Placed::line + bytes - address % Placed::line) % Placed::line;
}

Placed::Placed(const std::vector<double>& values, std::size_t bytes)
    : size_(values.size()),
      all_(size_ + line / sizeof(double)),
      first_(bytes_to_place(all_.data(), bytes) / sizeof(double)) {
  std::copy(values.begin(), values.end(), all_.begin() + static_cast<std::ptrdiff_t>(first_));
}

std::vector<double> Placed::values() const {
  const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(first_);
  return {begin, begin + static_cast<std::ptrdiff_t>(size_)};
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
  for (std::size_t v = 0, at = 9; v < table.state_count && at < scales_.size(); ++v) {
    const auto size = static_cast<std::size_t>(components_of_kind(table.state[v].kind));
    share_largest(at, size);
    at += size;
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
