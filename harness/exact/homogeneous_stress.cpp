// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/homogeneous_stress.hpp"

#include <stdexcept>

#include "harness/material/checked_update.hpp"

namespace assay {

HomogeneousStress::HomogeneousStress(std::shared_ptr<const Material> material, const Path& path, double own, double end,
                                     double tolerance)
    : material_(std::move(material)), path_(path), own_(own) {
  if (material_->is_function_of_F()) {
    state_ = material_->initial_state(1, {}, path_.material_direction);
    return;
  }
  course_.emplace(*material_, path_, end);
  history_.emplace(*course_, std::vector{own_},
                   HistoryOptions{.tolerance = tolerance, .watch = material_->has(ASSAY_NON_SMOOTH)});
}

const Tensor& HomogeneousStress::at(double t) {
  if (t == t_) return piola_;
  piola_ = history_ ? by_history(t) : by_update(t);
  t_ = t;
  return piola_;
}

Tensor HomogeneousStress::by_update(double t) {
  const Tensor F = path_.deformation_gradient(own_, t), I = Tensor::Identity();
  double F0[9], F1[9], values[9];
  for (int c = 0; c < 9; ++c) F0[c] = component(I, c), F1[c] = component(F, c);
  std::vector<double> after(state_.size());
  checked_update(*material_, own_, 0, t > 0 ? t : 1, 1, F0, F1, state_.data(), after.data(), values);
  ++calls_;
  Tensor cauchy;
  for (int c = 0; c < 9; ++c) component(cauchy, c) = values[c];
  return first_piola_kirchhoff(cauchy, F);
}

Tensor HomogeneousStress::by_history(double t) {
  if (t < t_) throw std::logic_error("HomogeneousStress: a history does not go back in time");
  history_->advance(t);
  return history_->tau(0);
}

}  // namespace assay
