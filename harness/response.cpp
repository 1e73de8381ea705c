// SPDX-License-Identifier: BSD-3-Clause
#include "harness/response.hpp"

namespace assay {

std::optional<ClosedForm> ClosedForm::of(std::shared_ptr<const Material> material, const Path& path) {
  const auto* form = material->extension<assay_closed_form>(ASSAY_EXTENSION_CLOSED_FORM);
  const int baseline = path.name == "simple_shear"      ? ASSAY_BASELINE_SIMPLE_SHEAR
                       : path.name == "uniaxial_strain" ? ASSAY_BASELINE_UNIAXIAL_STRAIN
                                                        : 0;
  if (!form || !form->tau || baseline == 0) return std::nullopt;
  const double eps = 0;
  double tau[9], dtau[9];
  if (form->tau(material->self(), baseline, 1, &eps, tau, dtau) == ASSAY_FAILED) return std::nullopt;
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
  form_->tau(material_->self(), baseline_, 1, &eps, values, slopes);
  for (int c = 0; c < 9; ++c) {
    component(tau, c) = values[c];
    component(dtau_dxi, c) = g * slopes[c];
  }
}

void Response::at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const {
  at_time(t, std::span(&xi, 1), [&](std::size_t, const Tensor& value, const Tensor& slope) {
    tau = value;
    dtau_dxi = slope;
  });
}

void Response::at_time(double t, std::span<const double> xi,
                       const std::function<void(std::size_t, const Tensor&, const Tensor&)>& visit) const {
  Tensor tau, dtau;
  if (const Sheet* table = sheet()) {
    const Sheet::Slice slice = table->slice(t);
    for (std::size_t i = 0; i < xi.size(); ++i) {
      slice.at(xi[i], tau, dtau);
      visit(i, tau, dtau);
    }
    return;
  }
  for (std::size_t i = 0; i < xi.size(); ++i) {
    std::get<ClosedForm>(source_).at(xi[i], t, tau, dtau);
    visit(i, tau, dtau);
  }
}

}  // namespace assay
