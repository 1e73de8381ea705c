// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/lsdyna.hpp"

#include <algorithm>
#include <cstring>

namespace assay::adapters {

namespace {

constexpr StateLayout lsdyna_layout{explicit_order, plain_shear, engineering_shear};

enum LsdynaGiven : std::size_t { lsdyna_dt, lsdyna_capa, lsdyna_time, lsdyna_temper, lsdyna_length, lsdyna_given };

constexpr std::size_t gradient_size = 9;
constexpr std::size_t no_curves = 2 * 101;  ///< one curve of zeros, as long as curves are by default
constexpr double shear_factor = 5.0 / 6;    ///< capa, of shells alone
constexpr const char* element_type = "solid";

}  // namespace

std::vector<ForeignVariable> Lsdyna::state_of(const ForeignModel& model) {
  return state_with(model, {{"EPSP", ForeignVariable::Kind::scalar, "1", "effective plastic strain", {}}});
}

Lsdyna::Lsdyna(const ForeignTable& table, const double* properties)
    : IncrementBridge(table, properties, lsdyna_layout, "the user material of LS-DYNA", "hsv", 1),
      history_size_(static_cast<std::size_t>(foreign_state_size(model_.state))) {
  make_arrays(GuardedArrays::usual_fence);
}

void Lsdyna::add_arrays() {
  stress_ = arrays_.add("sig", 6);
  history_ = arrays_.add("hsv", history_size_ + (model_.finite_strain ? gradient_size : 0));
  scalars_ = arrays_.add("epsp", 1);
  inputs_.begin(arrays_);
  using enum InputWatch::Change;
  constants_ = inputs_.add_array(arrays_, "cm", model_.properties.size(), written_props, once);
  strain_ = inputs_.add_array(arrays_, "eps", 6, written_dstran, every_call);
  curves_ = inputs_.add_array(arrays_, "crv", no_curves, written_others, once);
  counts_ = inputs_.add_array(arrays_, "nnpcrv", 8, written_others, once);
  constants_of_all_ = inputs_.add_array(arrays_, "cma", model_.properties.size(), written_others, once);
  axes_ = inputs_.add_array(arrays_, "qmat", 9, written_others, once);
  given_ = arrays_.add("the given scalars", lsdyna_given);
  inputs_.add(written_dtime, every_call, given_, lsdyna_dt, 1);
  inputs_.add(written_others, every_call, given_, lsdyna_capa, 1);
  inputs_.add(written_time, every_call, given_, lsdyna_time, 1);
  inputs_.add(written_temp, every_call, given_, lsdyna_temper, 1);
  inputs_.add(written_celent, every_call, given_, lsdyna_length, 1);
}

void Lsdyna::fill_once() {
  std::copy(properties_.begin(), properties_.end(), arrays_[constants_]);
  std::copy(properties_.begin(), properties_.end(), arrays_[constants_of_all_]);
  write_column_major(Tensor::Identity(), arrays_[axes_]);
}

void Lsdyna::hand_over(const PointStep& step, const Increment& increment) {
  write_symmetric(increment.stress / model_.units.stress, explicit_order, plain_shear, arrays_[stress_]);
  write_symmetric(increment.strain, explicit_order, engineering_shear, arrays_[strain_]);
  F_ = increment.F1;
  if (model_.finite_strain) write_column_major(F_, arrays_[history_] + history_size_);
  arrays_[scalars_][0] = *scalars_of(step);
  double* given = arrays_[given_];
  given[lsdyna_dt] = step.dt / model_.units.time, given[lsdyna_capa] = shear_factor;
  given[lsdyna_time] = age_of(step) / model_.units.time;
  const Temperature temperature = temperature_of(step);
  given[lsdyna_temper] = temperature.at_begin + temperature.rise, given[lsdyna_length] = host_.length;
  fails_ = rejects_ = 0, element_ = host_.element;
}

void Lsdyna::call_entry() {
  double* given = arrays_[given_];
  double *cm = arrays_[constants_], *eps = arrays_[strain_], *sig = arrays_[stress_], *epsp = arrays_[scalars_],
         *hsv = arrays_[history_], *crv = arrays_[curves_], *cma = arrays_[constants_of_all_], *qmat = arrays_[axes_],
         *dt = given + lsdyna_dt, *capa = given + lsdyna_capa, *tt = given + lsdyna_time,
         *temper = given + lsdyna_temper, *length = given + lsdyna_length;
  const std::size_t letters = std::strlen(element_type);
  switch (model_.arguments) {
    case 12:
      return reinterpret_cast<LsdynaEntryOf12>(table_.entry)(cm, eps, sig, epsp, hsv, dt, capa, element_type, tt,
                                                             temper, &fails_, crv, letters);
    case 13:
      return reinterpret_cast<LsdynaEntryOf13>(table_.entry)(cm, eps, sig, epsp, hsv, dt, capa, element_type, tt,
                                                             temper, &fails_, crv, arrays_[counts_], letters);
    case 16:
      return reinterpret_cast<LsdynaEntryOf16>(table_.entry)(cm, eps, sig, epsp, hsv, dt, capa, element_type, tt,
                                                             temper, &fails_, crv, cma, qmat, length, &element_,
                                                             letters);
    default:
      return reinterpret_cast<LsdynaEntry>(table_.entry)(cm, eps, sig, epsp, hsv, dt, capa, element_type, tt, temper,
                                                         &fails_, crv, arrays_[counts_], cma, qmat, length, &element_,
                                                         &rejects_, letters);
  }
}

void Lsdyna::require_good() const {
  if (model_.finite_strain && !std::equal(F_.data(), F_.data() + gradient_size, arrays_[history_] + history_size_)) {
    throw PointFailure(overrun_words + ("the user material of LS-DYNA writes past hsv, which has " +
                                        std::to_string(history_size_) + " components, where IHYPER keeps F"));
  }
  constexpr double shorter = 0.5;
  if (rejects_ != 0) throw PointFailure("the user material of LS-DYNA asks for a shorter step: reject", shorter);
  if (fails_ != 0) throw PointFailure("the user material of LS-DYNA deletes the point: failel");
}

Tensor Lsdyna::stress() const {
  return model_.units.stress * read_symmetric(arrays_[stress_], explicit_order, plain_shear);
}

void Lsdyna::keep_scalars(double* scalars) const { *scalars = arrays_[scalars_][0]; }

}  // namespace assay::adapters
