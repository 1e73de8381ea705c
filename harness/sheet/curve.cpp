// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/curve.hpp"

#include <algorithm>
#include <cmath>

#include "harness/material/checked_update.hpp"
#include "harness/numeric/chebyshev.hpp"

namespace assay {

namespace {

/// What follows the last terms of a series of nine components, falling on as from its third quarter to its fourth.
double rest_of(std::span<const double> coefficients) {
  constexpr double margin = 4;  // terms that fold back onto the nodes; algebraic decay, which slows down
  const std::size_t terms = coefficients.size() / 9, quarter = terms / 4;
  const auto largest = [&](std::size_t begin, std::size_t end) {
    double size = 0;
    for (std::size_t i = 9 * begin; i < 9 * end; ++i) size = std::max(size, std::abs(coefficients[i]));
    return size;
  };
  const double early = largest(terms - 2 * quarter, terms - quarter), late = largest(terms - quarter, terms);
  if (late == 0) return 0;
  const double fall = std::min(1.0, late / early), ratio = std::pow(fall, 1 / static_cast<double>(quarter));
  return margin * late * fall * std::min(static_cast<double>(terms), 1 / (1 - ratio));
}

}  // namespace

std::vector<double> tau_of_eps(const Material& material, const Path& loading, std::span<const double> eps) {
  const std::size_t n = eps.size();
  std::vector<double> all(9 * n);
  std::vector<double> state0 = material.initial_state(1, {}, loading.material_direction), state1(state0.size());
  double F0[9], F1[9], cauchy[9];
  for (int c = 0; c < 9; ++c) F0[c] = c % 4 == 0 ? 1 : 0;
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = loading.deformation_gradient(eps[p], 1);
    for (int c = 0; c < 9; ++c) F1[c] = component(F, c);
    checked_update(material, eps[p], 0, 1, 1, F0, F1, state0.data(), state1.data(), cauchy);
    Tensor sigma;
    for (int c = 0; c < 9; ++c) component(sigma, c) = cauchy[c];
    const Tensor tau = first_piola_kirchhoff(sigma, F);
    for (std::size_t c = 0; c < 9; ++c) all[c * n + p] = component(tau, static_cast<int>(c));
  }
  return all;
}

Curve::Curve(const Material& material, const Path& path, double end, int n) : amplitude_(path.amplitude), nodes_(n) {
  const Path loading = loading_path(path, end);
  range_.map.xi = loading.parameter;
  const std::vector<double> places = chebyshev::nodes(loading.parameter, n);
  const std::vector<double> tau = tau_of_eps(material, loading, places);
  const auto count = static_cast<std::size_t>(n);
  range_.active = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  range_.coefficients.resize(9 * count);
  for (std::size_t c = 0; c < 9; ++c) {
    const auto terms = chebyshev::coefficients(std::span(tau).subspan(c * count, count));
    for (std::size_t k = 0; k < count; ++k) range_.coefficients[k * 9 + c] = terms[k];
  }
  left_out_ = rest_of(range_.coefficients);
  range_.trim();
}

Slice Curve::slice(double t) const { return Slice({range_}, amplitude_(t)); }

}  // namespace assay
