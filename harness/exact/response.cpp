// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/response.hpp"

#include <cmath>

namespace assay {

std::optional<ClosedForm> ClosedForm::of(std::shared_ptr<const Material> material, const Path& path) {
  const Offer<assay_closed_form> form(*material);
  const int baseline = path.name == "simple_shear"      ? ASSAY_BASELINE_SIMPLE_SHEAR
                       : path.name == "uniaxial_strain" ? ASSAY_BASELINE_UNIAXIAL_STRAIN
                                                        : 0;
  if (!form || baseline == 0) return std::nullopt;
  if (path.material_direction != std::array<double, 3>{1, 0, 0}) return std::nullopt;  // a form knows only this one
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

void ClosedForm::at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const {
  const double g = amplitude_(t), eps = xi * g;
  double values[9], slopes[9];
  if ((*form_)(baseline_, 1, &eps, values, slopes) == ASSAY_FAILED) {
    throw MaterialFailure(with_reason("its closed form failed", *material_), xi, t);
  }
  bool finite = true;
  for (int c = 0; c < 9; ++c) {
    component(tau, c) = values[c];
    component(dtau_dxi, c) = g * slopes[c];
    finite = finite && std::isfinite(values[c]) && std::isfinite(slopes[c]);
  }
  if (!finite) throw MaterialFailure("its closed form is not finite", xi, t);
}

void Response::at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const {
  if (const Sheet* table = sheet()) return table->at(xi, t, tau, dtau_dxi);
  if (const Shadow* points = marched(t)) return points->at(xi, tau, dtau_dxi);
  std::get<ClosedForm>(source_).at(xi, t, tau, dtau_dxi);
}

void Response::at_time(double t, std::span<const double> xi,
                       const std::function<void(std::size_t, const Tensor&, const Tensor&)>& visit) const {
  Tensor tau, dtau;
  if (sheet()) {
    const Slice& slice = slice_at(t);
    for (std::size_t i = 0; i < xi.size(); ++i) {
      slice.at(xi[i], tau, dtau);
      visit(i, tau, dtau);
    }
    return;
  }
  const Shadow* points = marched(t);
  for (std::size_t i = 0; i < xi.size(); ++i) {
    if (points)
      points->at(xi[i], tau, dtau);
    else
      std::get<ClosedForm>(source_).at(xi[i], t, tau, dtau);
    visit(i, tau, dtau);
  }
}

const Slice& Response::slice_at(double t) const {
  if (!slice_ || slice_->first != t) slice_.emplace(t, sheet()->slice(t));
  return slice_->second;
}

Shadow* Response::marched(double t) const {
  const auto* points = std::get_if<std::shared_ptr<Shadow>>(&source_);
  if (!points) return nullptr;
  (*points)->advance(t);
  return points->get();
}

void Response::plane_tau_at_time(double t, std::span<const double> xi, std::span<double> tau,
                                 const InPieces& pieces) const {
  if (sheet()) {
    const Slice& slice = slice_at(t);
    return pieces(xi.size(), [&](std::size_t begin, std::size_t end) { slice.plane_tau(xi, tau, begin, end); });
  }
  const std::size_t n = xi.size();
  at_time(t, xi, [&](std::size_t i, const Tensor& value, const Tensor&) {
    tau[i] = value(0, 0), tau[n + i] = value(0, 1), tau[2 * n + i] = value(1, 0), tau[3 * n + i] = value(1, 1);
  });
}

std::vector<double> Response::fronts(double t) const {
  if (const Shadow* points = marched(t)) return points->fronts();
  const Sheet* table = sheet();
  return table && table->has_kinks() ? slice_at(t).kinks() : std::vector<double>();
}

}  // namespace assay
