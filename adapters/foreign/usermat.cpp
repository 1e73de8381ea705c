// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/usermat.hpp"

#include <algorithm>
#include <cmath>

namespace assay::adapters {

namespace {

constexpr StateLayout usermat_layout{explicit_order, plain_shear, engineering_shear};

/// Scalars of a point, and among those that the model writes.
enum UsermatScalar : std::size_t { sed_el, sed_pl, eps_eq, usermat_own, eps_zz = usermat_own, usermat_scalars };
enum UsermatGiven : std::size_t { usermat_time, usermat_dtime, usermat_temp, usermat_dtemp, usermat_given };
constexpr std::size_t reserved = 9;  ///< cutFactor, var1 .. var8

}  // namespace

std::vector<ForeignVariable> Usermat::state_of(const ForeignModel& model) {
  using Kind = ForeignVariable::Kind;
  return state_with(model, {{"SEDEL", Kind::scalar, "J/m^3", "elastic work", {}},
                            {"SEDPL", Kind::scalar, "J/m^3", "plastic work", {}},
                            {"EPSEQ", Kind::scalar, "1", "equivalent plastic strain", {}},
                            {"EPSPL", Kind::strain, "1", "plastic strain, as the model leaves it", {}}});
}

Usermat::Usermat(const ForeignTable& table, const double* properties)
    : IncrementBridge(table, properties, usermat_layout, "the USERMAT", "ustatev", usermat_own + 6),
      components_(Components(explicit_order).first(static_cast<std::size_t>(components_served(model_)))) {
  make_arrays(GuardedArrays::usual_fence);
}

void Usermat::add_arrays() {
  const std::size_t n = components_.size();
  stress_ = arrays_.add("stress", n);
  state_ = arrays_.add("ustatev", static_cast<std::size_t>(foreign_state_size(model_.state)));
  moduli_ = arrays_.add("dsdePl", n * n);
  plastic_ = arrays_.add("epsPl", n);
  scalars_ = arrays_.add("the scalars", usermat_scalars);
  shear_ = arrays_.add("tsstif", 2);
  others_ = arrays_.add("cutFactor and var1 to var8", reserved);
  inputs_.begin(arrays_);
  using enum InputWatch::Change;
  strain_ = inputs_.add_array(arrays_, "Strain", n, written_stran, every_call);
  strain_increment_ = inputs_.add_array(arrays_, "dStrain", n, written_dstran, every_call);
  properties_at_ = inputs_.add_array(arrays_, "prop", model_.properties.size(), written_props, once);
  place_ = inputs_.add_array(arrays_, "coords", 3, written_coords, once);
  turn_ = inputs_.add_array(arrays_, "var0", 9, written_others, once);
  F0_ = inputs_.add_array(arrays_, "defGrad_t", 9, written_dfgrd0, every_call);
  F1_ = inputs_.add_array(arrays_, "defGrad", 9, written_dfgrd1, every_call);
  given_ = arrays_.add("the given scalars", usermat_given);
  inputs_.add(written_time, every_call, given_, usermat_time, 1);
  inputs_.add(written_dtime, every_call, given_, usermat_dtime, 1);
  inputs_.add(written_temp, every_call, given_, usermat_temp, 2);
  static_assert(sizeof integers_ % sizeof(int) == 0);
  inputs_.add_integers(written_integers, &integers_.material, sizeof integers_ / sizeof(int));
}

void Usermat::fill_once() {
  std::copy(properties_.begin(), properties_.end(), arrays_[properties_at_]);
  std::copy_n(host_.place.data(), 3, arrays_[place_]);
  write_column_major(Tensor::Identity(), arrays_[turn_]);
  const int n = static_cast<int>(components_.size());
  integers_ = {1,
               host_.element,
               host_.point,
               host_.layer,
               host_.section,
               host_.step,
               1,
               3,
               n - 3,
               n,
               foreign_state_size(model_.state),
               static_cast<int>(model_.properties.size())};
}

void Usermat::hand_over(const PointStep& step, const Increment& increment) {
  const auto put = [&](const Tensor& A, double shear, std::size_t array) {
    write_components(A, components_, shear, arrays_[array]);
  };
  put(increment.stress / model_.units.stress, plain_shear, stress_);
  put(increment.strain_before, engineering_shear, strain_);
  put(increment.strain, engineering_shear, strain_increment_);
  write_column_major(step.F0, arrays_[F0_]);
  write_column_major(step.F1, arrays_[F1_]);
  const double* own = scalars_of(step);
  const Tensor plastic = read_symmetric(own + usermat_own, standard_order, plain_shear);
  put(turned(plastic, increment.rotation), engineering_shear, plastic_);
  double* s = arrays_[scalars_];
  s[sed_el] = own[sed_el] / model_.units.stress, s[sed_pl] = own[sed_pl] / model_.units.stress;
  s[eps_eq] = own[eps_eq], s[eps_zz] = 0;
  arrays_.fill(shear_, 0);
  arrays_.fill(others_, 0);
  arrays_.fill(moduli_, host_.outputs_before);
  double* given = arrays_[given_];
  given[usermat_time] = age_of(step) / model_.units.time + (model_.step - 1);
  given[usermat_dtime] = step.dt / model_.units.time;
  const Temperature temperature = temperature_of(step);
  given[usermat_temp] = temperature.at_begin, given[usermat_dtemp] = temperature.rise;
  integers_.substep = host_.increment.value_or(age_of(step) > 0 ? 2 : 1);
  keycut_ = 0;
}

void Usermat::call_entry() {
  double *s = arrays_[scalars_], *given = arrays_[given_], *var = arrays_[others_];
  Integers& i = integers_;
  reinterpret_cast<UsermatEntry>(table_.entry)(
      &i.material, &i.element, &i.point, &i.layer, &i.section, &i.load_step, &i.substep, &keycut_, &i.direct, &i.shear,
      &i.components, &i.states, &i.properties, given + usermat_time, given + usermat_dtime, given + usermat_temp,
      given + usermat_dtemp, arrays_[stress_], arrays_[state_], arrays_[moduli_], s + sed_el, s + sed_pl, s + eps_eq,
      arrays_[strain_], arrays_[strain_increment_], arrays_[plastic_], arrays_[properties_at_], arrays_[place_],
      arrays_[turn_], arrays_[F0_], arrays_[F1_], arrays_[shear_], s + eps_zz, var, var + 1, var + 2, var + 3, var + 4,
      var + 5, var + 6, var + 7, var + 8);
}

void Usermat::require_good() const {
  if (keycut_ == 0) return;
  const double factor = arrays_[others_][0];  // cutFactor, where the release has one
  constexpr double usual = 0.5;
  const bool is_said = factor > 0 && factor < 1;
  throw PointFailure("the USERMAT asks for a shorter step: keycut = " + std::to_string(keycut_) +
                         (is_said ? ", cutFactor = " + shortest_text(factor) : ""),
                     is_said ? std::max(factor, 0.01) : usual);
}

Tensor Usermat::stress() const {
  return model_.units.stress * read_components(arrays_[stress_], components_, plain_shear);
}

void Usermat::keep_scalars(double* scalars) const {
  const double* s = arrays_[scalars_];
  scalars[sed_el] = s[sed_el] * model_.units.stress, scalars[sed_pl] = s[sed_pl] * model_.units.stress;
  scalars[eps_eq] = s[eps_eq];
  write_symmetric(read_components(arrays_[plastic_], components_, engineering_shear), standard_order, plain_shear,
                  scalars + usermat_own);
}

/// dsdePl, column by column, on a strain in the axes of space [Pa].
Tensor Usermat::moduli_on(const Tensor& strain) const {
  return model_.units.stress * moduli_in_frame(arrays_[moduli_], components_, increment_.frame, strain);
}

void Usermat::tangent(const PointStep& step, double* tangent) {
  call(step);
  const Tensor sigma = turned(stress(), increment_.frame);
  for (int column = 0; column < 9; ++column) {
    Tensor E = Tensor::Zero();
    component(E, column) = 1;
    const auto on = [this](const Tensor& strain) { return moduli_on(strain); };
    const Tensor d = model_.finite_strain  // which no description says: it is tried
                         ? stress_rate_by_moduli(step, E, sigma, model_.moduli, on)
                         : stress_rate_of_step(step, E, sigma, model_, increment_, on);
    for (int row = 0; row < 9; ++row) tangent[9 * row + column] = component(d, row);
  }
}

}  // namespace assay::adapters
