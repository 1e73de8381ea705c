// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/umat.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>

#include "adapters/foreign/component_order.hpp"
#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/kinematics.hpp"
#include "adapters/foreign/model_end.hpp"

namespace assay::adapters {

namespace {

constexpr std::size_t name_length = 80, fields = 16;

/// Scalars that are handed over by reference, in the array `scalars`.
enum Scalar : std::size_t { sse, spd, scd, rpl, drpldt, dtime, temp, dtemp, pnewdt, celent, scalar_count };

constexpr StateLayout layout{standard_order, plain_shear, engineering_shear};

/// Where a point's own state begins.
enum Own : std::size_t { own_stress = 0, own_strain = 6, own_energies = 12 };

/// Fortran's order of a matrix.
void write_column_major(const Tensor& A, double* out) { Eigen::Map<Tensor>(out, 3, 3) = A; }

}  // namespace

std::vector<ForeignVariable> Umat::state_of(const ForeignModel& model) {
  using Kind = ForeignVariable::Kind;
  std::vector<ForeignVariable> all{{"STRESS", Kind::symmetric_tensor, "Pa", "Cauchy, rotated by the host", {}},
                                   {"STRAN", Kind::symmetric_tensor, "1", "plain shears; rotated by the host", {}},
                                   {"SSE", Kind::scalar, "J/m^3", "elastic energy", {}},
                                   {"SPD", Kind::scalar, "J/m^3", "plastic dissipation", {}},
                                   {"SCD", Kind::scalar, "J/m^3", "creep dissipation", {}}};
  all.insert(all.end(), model.state.begin(), model.state.end());
  return all;
}

Umat::Umat(const ForeignTable& table, const double* properties)
    : table_(table),
      model_(table.model),
      ntens_(serves_all_components(model_) ? 6 : 4),
      nstatv_(foreign_state_size(model_.state)) {
  const auto n = static_cast<std::size_t>(ntens_);
  stress_ = arrays_.add("STRESS", n);
  statev_ = arrays_.add("STATEV", static_cast<std::size_t>(nstatv_));
  ddsdde_ = arrays_.add("DDSDDE", n * n);
  ddsddt_ = arrays_.add("DDSDDT", n);
  drplde_ = arrays_.add("DRPLDE", n);
  stran_ = arrays_.add("STRAN", n);
  dstran_ = arrays_.add("DSTRAN", n);
  time_ = arrays_.add("TIME", 2);
  predef_ = arrays_.add("PREDEF", fields);
  dpred_ = arrays_.add("DPRED", fields);
  props_ = arrays_.add("PROPS", model_.properties.size());
  coords_ = arrays_.add("COORDS", 3);
  drot_ = arrays_.add("DROT", 9);
  dfgrd0_ = arrays_.add("DFGRD0", 9);
  dfgrd1_ = arrays_.add("DFGRD1", 9);
  scalars_ = arrays_.add("the scalars", scalar_count);
  std::copy_n(properties, model_.properties.size(), arrays_[props_]);
}

void Umat::initial_state(const Tensor& cauchy, double* state) {
  std::fill_n(state, own_state, 0.0);
  write_symmetric(cauchy, standard_order, plain_shear, state + own_stress);
  write_initial(model_.state, state + own_state);
  if (void* sdvini = dlsym(table_.library, "sdvini_")) {
    arrays_.fill(coords_, 0);
    to_foreign(layout, model_.state, state + own_state, arrays_[statev_]);
    int statev = nstatv_, ncrds = 3, one = 1, point = 1, layer = 1, section = 1;
    reinterpret_cast<SdviniEntry>(sdvini)(arrays_[statev_], arrays_[coords_], &statev, &ncrds, &one, &point, &layer,
                                          &section);
    from_foreign(layout, model_.state, arrays_[statev_], state + own_state);
  }
}

void Umat::hand_over(const PointStep& step) {
  require_served(model_, step.F0, step.F1);
  const StepStrain increment = step_strain(step.F0, step.F1, model_.kinematics);
  const Tensor& R = increment.rotation;
  const auto n = static_cast<std::size_t>(ntens_);
  const auto put = [&](const Tensor& A, double shear, std::size_t array) {
    double six[6];
    write_symmetric(A, standard_order, shear, six);
    std::copy_n(six, n, arrays_[array]);
  };
  const auto own = [&](std::size_t at) { return read_symmetric(step.state0 + at, standard_order, plain_shear); };
  put(R * own(own_stress) * R.transpose() / model_.units.stress, plain_shear, stress_);
  put(R * own(own_strain) * R.transpose(), engineering_shear, stran_);
  put(increment.strain, engineering_shear, dstran_);
  strain_after_ = R * own(own_strain) * R.transpose() + increment.strain;
  to_foreign(layout, model_.state, step.state0 + own_state, arrays_[statev_]);
  write_column_major(R, arrays_[drot_]);
  write_column_major(step.F0, arrays_[dfgrd0_]);
  write_column_major(step.F1, arrays_[dfgrd1_]);
  for (const std::size_t array : {ddsdde_, ddsddt_, drplde_, predef_, dpred_, coords_, scalars_})
    arrays_.fill(array, 0);
  arrays_[time_][0] = arrays_[time_][1] = step.t / model_.units.time;
  double* s = arrays_[scalars_];
  for (std::size_t k = 0; k < 3; ++k) s[sse + k] = step.state0[own_energies + k] / model_.units.stress;
  s[dtime] = step.dt / model_.units.time;
  s[temp] = model_.temperature;
  s[pnewdt] = 1;
  s[celent] = model_.characteristic_length;
}

void Umat::call(std::size_t number, double t) {
  char name[name_length];
  std::fill_n(name, name_length, ' ');
  std::copy_n(model_.material_name.data(), std::min(name_length, model_.material_name.size()), name);
  int ndi = 3, nshr = ntens_ - 3, ntens = ntens_, nstatv = nstatv_;
  auto nprops = static_cast<int>(model_.properties.size());
  int noel = static_cast<int>(number) + 1, npt = 1, layer = 1, kspt = 1, kinc = t > 0 ? 2 : 1;
  constexpr int static_procedure = 1;
  int jstep[4] = {1, static_procedure, model_.finite_strain ? 1 : 0, 0};
  double* s = arrays_[scalars_];
  const auto ended = ended_in([&] {
    reinterpret_cast<UmatEntry>(table_.entry)(
        arrays_[stress_], arrays_[statev_], arrays_[ddsdde_], s + sse, s + spd, s + scd, s + rpl, arrays_[ddsddt_],
        arrays_[drplde_], s + drpldt, arrays_[stran_], arrays_[dstran_], arrays_[time_], s + dtime, s + temp, s + dtemp,
        arrays_[predef_], arrays_[dpred_], name, &ndi, &nshr, &ntens, &nstatv, arrays_[props_], &nprops,
        arrays_[coords_], arrays_[drot_], s + pnewdt, s + celent, arrays_[dfgrd0_], arrays_[dfgrd1_], &noel, &npt,
        &layer, &kspt, jstep, &kinc, name_length);
  });
  if (ended) throw PointFailure("the UMAT " + *ended);
  if (const auto broken = arrays_.broken_fence()) throw PointFailure(overrun_words + ("the UMAT " + *broken));
  if (s[pnewdt] < 1) {
    throw PointFailure("the UMAT asks for a shorter step: PNEWDT = " + shortest_text(s[pnewdt]),
                       std::clamp(s[pnewdt], 0.01, 0.99));
  }
}

Tensor Umat::stress() const {
  double six[6] = {};
  std::copy_n(arrays_[stress_], ntens_, six);
  return model_.units.stress * read_symmetric(six, standard_order, plain_shear);
}

void Umat::update(const PointStep& step, PointEnd& end) {
  hand_over(step);
  call(step.number, step.t);
  end.cauchy = stress();
  write_symmetric(end.cauchy, standard_order, plain_shear, end.state1 + own_stress);
  // not what the UMAT may have made of its own copies
  write_symmetric(strain_after_, standard_order, plain_shear, end.state1 + own_strain);
  for (std::size_t k = 0; k < 3; ++k) end.state1[own_energies + k] = model_.units.stress * arrays_[scalars_][sse + k];
  from_foreign(layout, model_.state, arrays_[statev_], end.state1 + own_state);
}

}  // namespace assay::adapters
