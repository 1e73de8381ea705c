// SPDX-License-Identifier: BSD-3-Clause
// tau(eps) of a material whose stress is a function of F alone, on a straight family of paths.
#include "harness/sheet/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "harness/material/checked_update.hpp"
#include "harness/numeric/central_difference.hpp"
#include "harness/numeric/chebyshev.hpp"
#include "harness/numeric/norms.hpp"
#include "harness/sheet/sheet_build.hpp"

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
  const std::vector<double> state0 = state_at_rest(material, loading);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = loading.deformation_gradient(eps[p], 1);
    const Tensor sigma = stepped(material, 0, 1, Tensor::Identity(), F, state0, eps[p]).cauchy;
    put_tensor(first_piola_kirchhoff(sigma, F), all.data(), n, p);
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
  range_.leave_out_zeros();
  range_.trim();
}

Isochrone Curve::isochrone(double t) const { return Isochrone({range_}, amplitude_(t)); }

namespace {

constexpr int first_nodes = 9;
/// Of the range of eps: irrational, so that no node family has them.
constexpr double places[] = {0.0721, 0.2391, 0.4142, 0.6180, 0.8513, 0.9772};
constexpr double step_share = 0.01;  ///< of the range: step of the differences
constexpr std::size_t stencil = 2 * central_reach + 1;

/// tau and d tau / d eps at the places, from steps of the material itself.
struct Reference {
  std::vector<double> eps;
  std::vector<Tensor> tau, slope;
  double tau_scale = 0, slope_scale = 0;
};

Reference reference_of(const Material& material, const Path& loading) {
  const double width = loading.parameter.width(), step = step_share * width;
  Reference reference;
  std::vector<double> eps;
  for (const double place : places) {
    reference.eps.push_back(loading.parameter.lower + (0.05 + 0.9 * place) * width);
    for (int k = -central_reach; k <= central_reach; ++k) eps.push_back(reference.eps.back() + k * step);
  }
  const std::vector<double> tau = tau_of_eps(material, loading, eps);
  for (std::size_t i = 0; i < reference.eps.size(); ++i) {
    const auto middle = static_cast<int>(stencil * i) + central_reach;
    const auto neighbour = [&](int k) {
      return tensor_at(tau.data(), eps.size(), static_cast<std::size_t>(middle + k));
    };
    reference.tau.push_back(neighbour(0));
    reference.slope.push_back(step > 0 ? central_difference(neighbour, step) : Tensor(Tensor::Zero()));
    reference.tau_scale = larger(reference.tau_scale, largest_of(reference.tau.back()));
    reference.slope_scale = larger(reference.slope_scale, largest_of(reference.slope.back()));
  }
  return reference;
}

/// At the places, and by what follows the last terms of the series: a kink between the places leaves them large.
SheetError error_of(const Curve& curve, const Reference& reference) {
  SheetError error{0, 0, reference.tau_scale, reference.slope_scale};
  const Isochrone isochrone = curve.in_eps();
  for (std::size_t i = 0; i < reference.eps.size(); ++i) {
    Tensor tau, slope;
    isochrone.at(reference.eps[i], tau, slope);
    error.tau = larger(error.tau, largest_of(tau - reference.tau[i]));
    error.dtau = larger(error.dtau, largest_of(slope - reference.slope[i]));
  }
  error.tau = larger(error.tau, curve.left_out());
  const double n = curve.nodes(), width = curve.eps().width();
  if (width > 0) error.dtau = larger(error.dtau, std::min(2 * n * n / width * curve.left_out(), error.dtau_scale));
  if (error.tau_scale > 0) error.tau /= error.tau_scale;
  if (error.dtau_scale > 0) error.dtau /= error.dtau_scale;
  return error;
}

}  // namespace

BuiltCurve build_curve(const Material& material, const Path& path, const SheetOptions& options) {
  const Reference reference = reference_of(material, loading_path(path, options.end));
  const auto probed = static_cast<std::int64_t>(stencil * reference.eps.size());
  BuiltCurve best{Curve(material, path, options.end, first_nodes), {}, probed + first_nodes};
  best.error = error_of(best.curve, reference);
  const auto larger = [](const SheetError& error) { return std::max(error.tau, error.dtau); };
  for (int nodes = 2 * first_nodes - 1; nodes <= options.most_nodes; nodes = 2 * nodes - 1) {
    if (larger(best.error) <= options.tolerance) break;
    Curve finer(material, path, options.end, nodes);
    best.calls += nodes;
    const SheetError error = error_of(finer, reference);
    if (larger(error) >= larger(best.error)) continue;  // more nodes follow a material's rounding more closely
    best.curve = std::move(finer);
    best.error = error;
  }
  return best;
}

}  // namespace assay
