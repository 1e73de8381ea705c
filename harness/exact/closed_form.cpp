// SPDX-License-Identifier: BSD-3-Clause
// The closed form of a material on a baseline, as a source of tau(xi, t).
#include <array>
#include <cmath>

#include "harness/exact/response.hpp"

namespace assay {

std::optional<ClosedForm> ClosedForm::of(std::shared_ptr<const Material> material, const Path& path) {
  const Offer<assay_closed_form> form(*material);
  const int baseline = path.name == "simple_shear"      ? ASSAY_BASELINE_SIMPLE_SHEAR
                       : path.name == "uniaxial_strain" ? ASSAY_BASELINE_UNIAXIAL_STRAIN
                                                        : 0;
  if (!form || baseline == 0) return std::nullopt;
  if (path.material_direction != std::array<double, 3>{1, 0, 0}) return std::nullopt;  // a form knows only this one
  if (!path.initial_cauchy.isZero(0)) return std::nullopt;                             // and begins without stress
  const double eps = 0;
  double tau[9], dtau[9];
  if (form(baseline, 1, &eps, tau, dtau) == ASSAY_FAILED) return std::nullopt;
  ClosedForm result;
  result.material_ = std::move(material);
  result.form_ = form;
  result.baseline_ = baseline;
  result.amplitude_ = path.amplitude;
  return result;
}

void ClosedForm::at(double xi, double t, double g, Tensor& tau, Tensor& dtau_dxi) const {
  double values[9], slopes[9];
  at({&xi, 1}, t, g, values, slopes);
  tau = tensor_of(values), dtau_dxi = tensor_of(slopes);
}

void ClosedForm::at(std::span<const double> xi, double t, double g, double* tau, double* dtau_dxi) const {
  const std::size_t n = xi.size();
  std::array<double, at_once> eps;
  for (std::size_t i = 0; i < n; ++i) eps[i] = xi[i] * g;
  const auto fails = [&](std::size_t first, std::size_t count) {
    return (*form_)(baseline_, count, &eps[first], tau, dtau_dxi) == ASSAY_FAILED;
  };
  const std::lock_guard lock(*one_at_a_time_);
  if (fails(0, n)) {
    std::size_t bad = 0;
    while (bad + 1 < n && !fails(bad, 1)) ++bad;
    throw MaterialFailure(with_reason("its closed form failed", *material_), xi[bad], t);
  }
  for (std::size_t i = 0; i < 9 * n; ++i) {
    dtau_dxi[i] *= g;
    if (std::isfinite(tau[i]) && std::isfinite(dtau_dxi[i])) continue;
    throw MaterialFailure("its closed form is not finite", xi[i % n], t);
  }
}

}  // namespace assay
