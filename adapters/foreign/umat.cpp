// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/umat.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_library.hpp"
#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/membrane.hpp"

namespace assay::adapters {

namespace {

constexpr std::size_t least_fields = 16;

/// Scalars that are handed over by reference: for the model to write, and given.
enum UmatScalar : std::size_t { sse, spd, scd, rpl, drpldt, pnewdt, umat_scalar_count };
enum Given : std::size_t { dtime, temp, dtemp, celent, given_count };

constexpr StateLayout umat_layout{standard_order, plain_shear, engineering_shear};

/// Where a point's own state begins.
enum UmatState : std::size_t {
  umat_stress = 0,
  umat_strain = 6,
  umat_energies = 12,
  umat_time = 15,
  umat_element = 16,
  umat_state_count = 16
};

}  // namespace

std::vector<ForeignVariable> Umat::state_of(const ForeignModel& model) {
  using Kind = ForeignVariable::Kind;
  const bool turning = model.axes == Axes::corotational;
  const char* axes = turning ? "; in axes that turn with the body" : "; rotated by the host";
  std::vector<ForeignVariable> all{{"STRESS", Kind::symmetric_tensor, "Pa", std::string("Cauchy") + axes, {}},
                                   {"STRAN", Kind::symmetric_tensor, "1", std::string("plain shears") + axes, {}},
                                   {"SSE", Kind::scalar, "J/m^3", "elastic energy", {}},
                                   {"SPD", Kind::scalar, "J/m^3", "plastic dissipation", {}},
                                   {"SCD", Kind::scalar, "J/m^3", "creep dissipation", {}},
                                   {"TIME", Kind::scalar, "s", "since the beginning of the point", {}}};
  if (model.each_its_element) all.push_back({"NOEL", Kind::scalar, "1", "of the point alone", {}});
  all.insert(all.end(), model.state.begin(), model.state.end());
  return all;
}

Umat::Umat(const ForeignTable& table, const double* properties)
    : AbaqusBridge(table, properties),
      ntens_(components_served(model_)),
      components_(is_plane_stress() ? Components(plane_stress_order)
                                    : Components(standard_order).first(static_cast<std::size_t>(ntens_))),
      nstatv_(foreign_state_size(model_.state)),
      own_state_(umat_state_count + (model_.each_its_element ? 1 : 0)) {
  make_arrays(GuardedArrays::usual_fence);
}

void Umat::make_arrays(std::size_t fence) {
  arrays_ = GuardedArrays(fence);
  inputs_ = InputWatch();
  add_arrays();
  std::copy(properties_.begin(), properties_.end(), arrays_[props_]);
  integers_.ndi = is_plane_stress() ? 2 : 3;
  integers_.nshr = ntens_ - integers_.ndi;
  integers_.ntens = ntens_;
  integers_.nstatv = nstatv_;
  integers_.nprops = static_cast<int>(model_.properties.size());
  hold(host_);
}

void Umat::widen() { make_arrays(GuardedArrays::widest_fence); }

void Umat::hold(const HostValues& values) {
  constexpr int static_procedure = 1;
  host_ = values;
  integers_.noel = values.element;
  integers_.npt = values.point;
  integers_.layer = values.layer;
  integers_.kspt = values.section;
  const int jstep[] = {values.step, static_procedure, model_.finite_strain ? 1 : 0, 0};
  std::copy_n(jstep, 4, integers_.jstep);
  std::copy_n(values.place.data(), 3, arrays_[coords_]);
  arrays_.fill(predef_, 0);
  const std::size_t fields = std::min(values.fields.size(), arrays_.size(predef_));
  std::copy_n(values.fields.data(), fields, arrays_[predef_]);
  inputs_.forget();
}

void Umat::add_arrays() {
  const auto n = static_cast<std::size_t>(ntens_);
  stress_ = arrays_.add("STRESS", n);
  statev_ = arrays_.add("STATEV", static_cast<std::size_t>(nstatv_));
  ddsdde_ = arrays_.add("DDSDDE", n * n);
  ddsddt_ = arrays_.add("DDSDDT", n);
  drplde_ = arrays_.add("DRPLDE", n);
  scalars_ = arrays_.add("the scalars", umat_scalar_count);
  inputs_.begin(arrays_);
  const auto input = [&](WrittenInput name, const char* words, std::size_t size, InputWatch::Change change) {
    return inputs_.add_array(arrays_, words, size, name, change);
  };
  using enum InputWatch::Change;
  stran_ = input(written_stran, "STRAN", n, every_call);
  dstran_ = input(written_dstran, "DSTRAN", n, every_call);
  time_ = input(written_time, "TIME", 2, every_call);
  const InputWatch::Change of_fields = model_.varying.empty() ? once : every_call;
  predef_ = input(written_predef, "PREDEF", std::max(least_fields, model_.fields.size()), of_fields);
  dpred_ = input(written_predef, "DPRED", arrays_.size(predef_), of_fields);
  props_ = input(written_props, "PROPS", model_.properties.size(), once);
  coords_ = input(written_coords, "COORDS", 3, once);
  drot_ = input(written_drot, "DROT", 9, every_call);
  dfgrd0_ = input(written_dfgrd0, "DFGRD0", 9, every_call);
  dfgrd1_ = input(written_dfgrd1, "DFGRD1", 9, every_call);
  given_ = arrays_.add("the given scalars", given_count);
  inputs_.add(written_dtime, every_call, given_, dtime, 1);
  inputs_.add(written_temp, every_call, given_, temp, 2);
  inputs_.add(written_celent, every_call, given_, celent, 1);
  static_assert(sizeof integers_ % sizeof(int) == 0);
  inputs_.add_integers(written_integers, &integers_.ndi, sizeof integers_ / sizeof(int));
}

void Umat::initial_state(const Tensor& cauchy, double* state) {
  constexpr double nothing = 1e-13;
  if (is_plane_stress() && cauchy.col(2).cwiseAbs().maxCoeff() > nothing * cauchy.norm())
    throw PointFailure("a model of plane stress (NTENS = 3) carries no stress 13, 23 or 33");
  std::fill_n(state, own_state_, 0.0);
  write_symmetric(cauchy, standard_order, plain_shear, state + umat_stress);
  write_initial(model_.state, state + own_state_);
  if (model_.each_its_element) state[umat_element] = table_.counts_elements ? ++table_.elements : host_.element;
  if (void* sdvini = dlsym(table_.library, "sdvini_")) {
    to_foreign(umat_layout, model_.state, state + own_state_, arrays_[statev_]);
    int statev = nstatv_, ncrds = 3, layer = host_.layer, section = host_.section, point = host_.point,
        element = model_.each_its_element ? static_cast<int>(state[umat_element]) : host_.element;
    const auto ended = ended_in([&] {
      reinterpret_cast<SdviniEntry>(sdvini)(arrays_[statev_], arrays_[coords_], &statev, &ncrds, &element, &point,
                                            &layer, &section);
    });
    std::copy_n(host_.place.data(), 3, arrays_[coords_]);
    if (ended) throw PointFailure("SDVINI " + *ended);
    if (const auto broken = arrays_.broken_fence()) throw PointFailure(overrun_words + ("SDVINI " + *broken));
    from_foreign(umat_layout, model_.state, arrays_[statev_], state + own_state_);
  }
}

void Umat::hand_over_tensors(const PointStep& step) {
  increment_ = increment_of(model_, step, umat_stress, umat_strain);
  write_components(increment_.stress / model_.units.stress, components_, plain_shear, arrays_[stress_]);
  write_components(increment_.strain_before, components_, engineering_shear, arrays_[stran_]);
  write_components(increment_.strain, components_, engineering_shear, arrays_[dstran_]);
  write_column_major(increment_.rotation, arrays_[drot_]);
  write_column_major(increment_.F0, arrays_[dfgrd0_]);
  write_column_major(increment_.F1, arrays_[dfgrd1_]);
}

/// The clock is the point's own: a step of a loaded point is never the first, whatever t is.
void Umat::hand_over_scalars(const PointStep& step) {
  to_foreign(umat_layout, model_.state, step.state0 + own_state_, arrays_[statev_]);
  for (const std::size_t array : {ddsddt_, drplde_, scalars_}) arrays_.fill(array, 0);
  arrays_.fill(ddsdde_, host_.outputs_before);
  const double age = step.state0[umat_time];
  const double time = age / model_.units.time;
  arrays_[time_][0] = host_.step_time_times * time;
  arrays_[time_][1] = time + (model_.step - 1);  // steps before, each of Abaqus' default length
  double* s = arrays_[scalars_];
  for (std::size_t k = 0; k < 3; ++k) s[sse + k] = step.state0[umat_energies + k] / model_.units.stress;
  s[pnewdt] = 1;
  double* given = arrays_[given_];
  given[dtime] = step.dt / model_.units.time;
  const Temperature temperature = temperature_of(step);
  given[temp] = temperature.at_begin, given[dtemp] = temperature.rise;
  for (std::size_t k = 0; k < model_.fields.size(); ++k) {
    const auto at = place_of_varying(model_, model_.fields[k].name);
    if (!at) continue;
    arrays_[predef_][k] = step.fields0[*at] + host_.field_shift(model_, k);
    arrays_[dpred_][k] = step.fields1[*at] - step.fields0[*at];
  }
  given[celent] = host_.length;
  integers_.kinc = host_.increment.value_or(age > 0 ? 2 : 1);
  if (model_.each_its_element) integers_.noel = std::max(1, static_cast<int>(step.state0[umat_element]));
}

std::optional<std::string> Umat::call_entry() {
  const auto name = cmname_of(model_);
  double *s = arrays_[scalars_], *given = arrays_[given_];
  Integers& i = integers_;
  return ended_in([&] {
    reinterpret_cast<UmatEntry>(table_.entry)(
        arrays_[stress_], arrays_[statev_], arrays_[ddsdde_], s + sse, s + spd, s + scd, s + rpl, arrays_[ddsddt_],
        arrays_[drplde_], s + drpldt, arrays_[stran_], arrays_[dstran_], arrays_[time_], given + dtime, given + temp,
        given + dtemp, arrays_[predef_], arrays_[dpred_], name.data(), &i.ndi, &i.nshr, &i.ntens, &i.nstatv,
        arrays_[props_], &i.nprops, arrays_[coords_], arrays_[drot_], s + pnewdt, given + celent, arrays_[dfgrd0_],
        arrays_[dfgrd1_], &i.noel, &i.npt, &i.layer, &i.kspt, i.jstep, &i.kinc, name.size());
  });
}

void Umat::call(const PointStep& step) {
  require_served(model_, step.F0, step.F1);
  hand_over_tensors(step);
  hand_over_scalars(step);
  inputs_.keep(arrays_);
  if (surroundings_.lent()) surroundings_.lend(arrays_);
  probe_.lend(arrays_);
  const auto ended = call_entry();
  probe_.take_back(arrays_);
  if (surroundings_.lent()) surroundings_.take_back(arrays_);
  const auto broken = inputs_.broken_fence(arrays_);
  if (ended) throw PointFailure("the UMAT " + *ended);
  if (broken) throw PointFailure(overrun_words + ("the UMAT " + *broken));
  const double factor = arrays_[scalars_][pnewdt];
  if (std::isnan(factor)) throw PointFailure(not_finite_words + std::string("PNEWDT, as the UMAT leaves it"));
  if (factor < 1) {
    throw PointFailure("the UMAT asks for a shorter step: PNEWDT = " + shortest_text(factor),
                       std::clamp(factor, 0.01, 0.99));
  }
}

Tensor Umat::stress() const {
  return model_.units.stress * read_components(arrays_[stress_], components_, plain_shear);
}

PointStep Umat::of_model(PointStep step) const {
  if (is_plane_stress()) step.F0 = with_thickness(model_, step.F0), step.F1 = with_thickness(model_, step.F1);
  return step;
}

void Umat::update(const PointStep& given, PointEnd& end) {
  const PointStep step = of_model(given);
  call(step);
  if (probe_.is_due()) probe_.look(arrays_, {stress_, statev_}, "STATEV", [&] { call(step); });
  const Tensor found = stress();
  end.cauchy = turns() ? turned(found, increment_.frame) : found;
  if (is_plane_stress()) end.cauchy *= membrane_factor(model_, given.F1);
  write_symmetric(found, standard_order, plain_shear, end.state1 + umat_stress);
  write_symmetric(increment_.strain_after(), standard_order, plain_shear, end.state1 + umat_strain);
  for (std::size_t k = 0; k < 3; ++k) end.state1[umat_energies + k] = model_.units.stress * arrays_[scalars_][sse + k];
  end.state1[umat_time] = step.state0[umat_time] + step.dt;
  if (model_.each_its_element) end.state1[umat_element] = step.state0[umat_element];
  from_foreign(umat_layout, model_.state, arrays_[statev_], end.state1 + own_state_);
}

}  // namespace assay::adapters
