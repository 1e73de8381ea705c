// SPDX-License-Identifier: BSD-3-Clause
#include "tests/adapters/models/properties.hpp"

#include <algorithm>
#include <cstring>

#include "tests/adapters/models/property_samples.hpp"

namespace assay::model_tests {
namespace {

double largest_entry(const std::vector<double>& a) {
  double most = 0;
  for (const double x : a) most = std::max(most, std::abs(x));
  return most;
}

/// (state, cauchy) after a step, in one vector; blocks of it are compared each relative to its own size.
std::vector<std::vector<double>> blocks_of(const Material& material, const std::vector<double>& state,
                                           const double* cauchy) {
  std::vector<std::vector<double>> blocks{{cauchy, cauchy + 9}};
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < material.table().state_count; ++v) {
    const auto n = static_cast<std::size_t>(components_of_kind(material.table().state[v].kind));
    blocks.emplace_back(state.begin() + static_cast<std::ptrdiff_t>(at),
                        state.begin() + static_cast<std::ptrdiff_t>(at + n));
    at += n;
  }
  return blocks;
}

bool is_stress(const Material& material, std::size_t block) {
  return block == 0 || std::strcmp(material.table().state[block - 1].unit, "Pa") == 0;
}

std::vector<double> tangent_by_differences(const Material& material, const Sample& s) {
  const double h = 1e-5;
  std::vector<double> tangent(81);
  for (int j = 0; j < 9; ++j) {
    const auto stress = [&](double change) {
      Tensor F = s.F1;
      F(j / 3, j % 3) += change;
      return point_after(material, s.t, s.dt, s.F0, F, s.state0).cauchy;
    };
    const Tensor slope = (8 * (stress(h) - stress(-h)) - (stress(2 * h) - stress(-2 * h))) / (12 * h);
    for (int i = 0; i < 9; ++i) tangent[static_cast<std::size_t>(9 * i + j)] = slope(i / 3, i % 3);
  }
  return tangent;
}

}  // namespace

Measured rate_error(const Material& material) {
  Measured measured;
  const auto* form = material.extension<assay_rate>(ASSAY_EXTENSION_RATE);
  if (!form) return measured;
  const double floor = stress_floor(material);
  for (const Sample& s : samples_of(material)) {
    const Tensor& F = s.F1;
    const double t = s.t + s.dt;
    double f[9], l[9], sigma[9], sigma_rate[9];
    nine(F, f), nine(s.F_rate * F.inverse(), l), nine(s.end.cauchy, sigma);
    std::vector<double> state_rate(s.end.state.size() + 1);
    if (form->rate(material.self(), t, 1, f, l, sigma, s.end.state.data(), sigma_rate, state_rate.data()) !=
        ASSAY_GOOD) {
      measured.add(INFINITY);
      continue;
    }
    // Forward differences over h, h/2, h/4, h/8, extrapolated: their error is of fourth order.
    const auto quotient = [&](double dt) {
      const Point end = point_after(material, t, dt, F, F + dt * s.F_rate, s.end.state);
      std::vector<double> state(end.state.size());
      for (std::size_t c = 0; c < state.size(); ++c) state[c] = (end.state[c] - s.end.state[c]) / dt;
      double rate[9];
      nine((end.cauchy - s.end.cauchy) / dt, rate);
      return blocks_of(material, state, rate);
    };
    const double h = 2e-4;
    const auto q0 = quotient(h), q1 = quotient(h / 2), q2 = quotient(h / 4), q3 = quotient(h / 8);
    const auto found = blocks_of(material, state_rate, sigma_rate);
    for (std::size_t b = 0; b < found.size(); ++b) {
      double difference = 0, size = is_stress(material, b) ? floor * s.F_rate.norm() : 1e-300;
      for (std::size_t c = 0; c < found[b].size(); ++c) {
        const double limit = (64 * q3[b][c] - 56 * q2[b][c] + 14 * q1[b][c] - q0[b][c]) / 21;
        difference = std::max(difference, std::abs(limit - found[b][c]));
        size = std::max({size, std::abs(limit), std::abs(found[b][c])});
      }
      measured.add(difference / size);
    }
  }
  return measured;
}

Measured tangent_error(const Material& material) {
  Measured measured;
  const auto* form = material.extension<assay_tangent>(ASSAY_EXTENSION_TANGENT);
  if (!form) return measured;
  for (const Sample& s : samples_of(material)) {
    double f0[9], f1[9];
    nine(s.F0, f0), nine(s.F1, f1);
    const assay_step step{s.t, s.dt, f0, f1};
    std::vector<double> found(81), expected = tangent_by_differences(material, s);
    if (form->tangent(material.self(), &step, 1, s.state0.data(), found.data()) != ASSAY_GOOD) found[0] = NAN;
    double difference = 0;
    for (std::size_t i = 0; i < 81; ++i) difference = std::fmax(difference, std::abs(found[i] - expected[i]));
    measured.add(std::isnan(found[0]) ? INFINITY : difference / largest_entry(expected));
  }
  return measured;
}

Measured objectivity_error(const Material& material) {
  Measured measured;
  constexpr double angle = 2.3;
  const auto ramp = [](double from, double to, double t) { return std::clamp((t - from) / (to - from), 0.0, 1.0); };
  for (const History& history : {cyclic_shear(0.45), stretch_and_rotation(0.12)}) {
    // Rest until 1, loading until 2, rest until 3.
    const auto loading = [&](double t) { return history.F(history.end * ramp(1, 2, t)); };
    for (const int steps : {60, 120}) {
      const Point still = marched(material, loading, 3, steps);
      for (int phase = 0; phase < 4; ++phase) {
        const double from = phase < 3 ? phase : 0, to = phase < 3 ? phase + 1 : 3;
        const auto turned = [&](double t) { return Tensor(turn(angle * ramp(from, to, t)) * loading(t)); };
        const Tensor seen = marched(material, turned, 3, steps).cauchy, Q = turn(angle);
        measured.add(relative(Q.transpose() * seen * Q, still.cauchy, stress_floor(material)));
      }
    }
  }
  return measured;
}

Measured energy_error(const Material& material) {
  Measured measured;
  const auto* form = material.extension<assay_energy>(ASSAY_EXTENSION_ENERGY);
  if (!form) return measured;
  for (const Sample& s : samples_of(material)) {
    // Held for a moment: what remains of the stress is elastic.
    const Point held = point_after(material, s.t + s.dt, 1e-3 * s.dt, s.F1, s.F1, s.end.state);
    const auto energy = [&](int j, double change) {
      double f[9], W = 0;
      nine(s.F1, f);
      f[j] += change;
      return form->energy(material.self(), 1, f, held.state.data(), &W) == ASSAY_GOOD ? W : NAN;
    };
    const double h = 1e-4;
    Tensor P;
    for (int j = 0; j < 9; ++j) {
      P(j / 3, j % 3) = (8 * (energy(j, h) - energy(j, -h)) - (energy(j, 2 * h) - energy(j, -2 * h))) / (12 * h);
    }
    measured.add(relative(P, piola(held.cauchy, s.F1), stress_floor(material)));
  }
  return measured;
}

}  // namespace assay::model_tests
