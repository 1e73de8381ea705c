// SPDX-License-Identifier: BSD-3-Clause
// The properties of calls: purity, closed forms, rest, and what the state tells of a step.
#include <cstring>

#include "tests/adapters/models/properties.hpp"
#include "tests/adapters/models/property_samples.hpp"

namespace assay::model_tests {
namespace {

/// Through equal steps N, 2N, 4N ...; the error of a step that is symmetric in time has even powers of it alone.
Tensor extrapolated(const Material& material, const std::function<Tensor(double)>& F, int steps, int levels) {
  std::vector<Tensor> row;
  for (int k = 0; k < levels; ++k, steps *= 2) {
    std::vector<Tensor> next{marched(material, F, 1, steps).cauchy};
    for (int i = 0; i < k; ++i) {
      const double power = std::pow(4.0, i + 1);
      next.push_back((power * next.back() - row[static_cast<std::size_t>(i)]) / (power - 1));
    }
    row = next;
  }
  return row.back();
}

Tensor baseline_direction(int baseline) {
  Tensor D = Tensor::Zero();
  if (baseline == ASSAY_BASELINE_SIMPLE_SHEAR) D(1, 0) = 2;
  if (baseline == ASSAY_BASELINE_UNIAXIAL_STRAIN) D(0, 0) = 1;
  return D;
}

constexpr int baselines[] = {ASSAY_BASELINE_SIMPLE_SHEAR, ASSAY_BASELINE_UNIAXIAL_STRAIN};

bool closed_form(const Material& material, int baseline, double eps, Tensor& tau, Tensor& slope) {
  const auto* form = material.extension<assay_closed_form>(ASSAY_EXTENSION_CLOSED_FORM);
  double value[9], derivative[9];
  if (!form || form->tau(material.self(), baseline, 1, &eps, value, derivative) == ASSAY_FAILED) return false;
  tau = tensor_of(value), slope = tensor_of(derivative);
  return true;
}

}  // namespace

Measured impurity(const Material& material) {
  Measured measured;
  const std::vector<Sample> samples = samples_of(material);
  const std::size_t n = samples.size(), m = material.state_size();
  std::vector<double> F0(9 * n), F1(9 * n), state0(m * n + 1), state1(m * n + 1), cauchy(9 * n);
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) {
      F0[c * n + p] = samples[p].F0(static_cast<int>(c / 3), static_cast<int>(c % 3));
      F1[c * n + p] = samples[p].F1(static_cast<int>(c / 3), static_cast<int>(c % 3));
    }
    for (std::size_t c = 0; c < m; ++c) state0[c * n + p] = samples[p].state0[c];
  }
  material.update(0, samples[0].dt, n, F0.data(), F1.data(), state0.data(), state1.data(), cauchy.data());
  const auto same = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  for (std::size_t p = 0; p < n; ++p) {
    for (int repeat = 0; repeat < 2; ++repeat) {
      const Point alone = point_after(material, 0, samples[0].dt, samples[p].F0, samples[p].F1, samples[p].state0);
      double nine_components[9];
      nine(alone.cauchy, nine_components);
      bool equal = true;
      for (std::size_t c = 0; c < 9; ++c) equal = equal && same(nine_components[c], cauchy[c * n + p]);
      for (std::size_t c = 0; c < m; ++c) equal = equal && same(alone.state[c], state1[c * n + p]);
      measured.add(equal ? 0 : 1);
    }
  }
  return measured;
}

Measured closed_form_error(const Material& material) {
  Measured measured;
  for (const int baseline : baselines) {
    for (const double eps : {-0.4, -0.05, 0.2, 0.7}) {
      Tensor tau, slope;
      if (!closed_form(material, baseline, eps, tau, slope)) continue;
      const Tensor D = baseline_direction(baseline);
      const auto F = [&](double t) { return Tensor(Tensor::Identity() + eps * t * D); };
      const Tensor expected = piola(extrapolated(material, F, 16, 6), F(1));
      measured.add(relative(tau, expected, stress_floor(material)));
    }
  }
  return measured;
}

Measured closed_form_slope_error(const Material& material) {
  Measured measured;
  for (const int baseline : baselines) {
    for (const double eps : {-0.4, 0.0, 0.2, 0.7}) {
      Tensor tau, slope, unused;
      if (!closed_form(material, baseline, eps, tau, slope)) continue;
      const auto at = [&](double change) {
        Tensor value;
        closed_form(material, baseline, eps + change, value, unused);
        return value;
      };
      const double h = 1e-3;
      const Tensor expected =
          (45 * (at(h) - at(-h)) - 9 * (at(2 * h) - at(-2 * h)) + at(3 * h) - at(-3 * h)) / (60 * h);
      measured.add(relative(slope, expected, stress_floor(material)));
    }
  }
  return measured;
}

Measured rest_error(const Material& material) {
  Measured measured;
  const Tensor F = Tensor::Identity();
  const Point rest = point_after(material, 0, 0.1, F, F, material.initial_state(1));
  measured.add(rest.cauchy.norm() / stress_floor(material));
  return measured;
}

Measured regime_error(const Material& material) {
  Measured measured;
  if (!material.has(ASSAY_NON_SMOOTH)) return measured;
  const auto scalars_change = [&](const std::vector<double>& a, const std::vector<double>& b) {
    std::size_t at = 0;
    bool change = false;
    for (std::uint32_t v = 0; v < material.table().state_count; ++v) {
      const auto n = static_cast<std::size_t>(components_of_kind(material.table().state[v].kind));
      if (n == 1) change = change || std::memcmp(&a[at], &b[at], sizeof(double)) != 0;
      at += n;
    }
    return change;
  };
  const auto sheared = [](double gamma) {
    Tensor F = Tensor::Identity();
    F(1, 0) = gamma;
    return F;
  };
  const auto step = [&](double from, double to, const std::vector<double>& state) {
    return point_after(material, 0, 1e-2, sheared(from), sheared(to), state).state;
  };
  const std::vector<double> fresh = material.initial_state(1);
  const std::vector<double> elastic = step(0, 1e-4, fresh), loaded = step(1e-4, 0.3, elastic);
  measured.add(scalars_change(fresh, elastic) ? 1 : 0);
  measured.add(scalars_change(elastic, loaded) ? 0 : 1);
  std::vector<double> relaxed = loaded;  // a rate-dependent model comes back to its threshold first
  double dt = 1e-3;
  for (int i = 0; i < 160 && material.has(ASSAY_RATE_DEPENDENT); ++i, dt *= 1.06) {
    relaxed = point_after(material, 0, dt, sheared(0.3), sheared(0.3), relaxed).state;
  }
  const std::vector<double> unloaded = step(0.295, 0.29, step(0.3, 0.295, relaxed));  // the first ends the flow
  const std::vector<double> further = step(0.29, 0.285, unloaded);  // a variable that names the regime is back by now
  measured.add(scalars_change(further, step(0.285, 0.28, further)) ? 1 : 0);
  if (!material.has(ASSAY_RATE_DEPENDENT)) measured.add(scalars_change(loaded, unloaded) ? 1 : 0);
  return measured;
}

}  // namespace assay::model_tests
