// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/mfront.hpp"

#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/kinematics.hpp"
#include "harness/material/stack_below.hpp"

namespace assay::adapters {

namespace {

constexpr StateLayout layout{standard_order, mfront_shear, mfront_shear};
constexpr double stress_alone = 0, consistent_operator = 4;  ///< what K[0] asks for
constexpr std::size_t operator_size = 128;                   ///< of at least 81 components

/// Where a point's own state begins.
enum Own : std::size_t { own_force = 0, own_stored = 6, own_dissipated = 7 };

/// Scalars that are handed over by reference.
enum Scalar : std::size_t { rdt, speed_of_sound, scalar_count };

using Kind = ForeignVariable::Kind;

std::size_t properties_of(const MfrontBehaviour& behaviour) {
  return behaviour.prepended.size() + behaviour.properties.size();
}

constexpr int always_tridimensional = 24;  ///< beside the kind of a variable

}  // namespace

std::vector<ForeignVariable> Mfront::state_of(const ForeignModel& model) {
  const char* force =
      model.finite_strain ? "Cauchy stress at the beginning" : "thermodynamic force in the frame of the polar rotation";
  std::vector<ForeignVariable> all{{"STRESS", Kind::symmetric_tensor, "Pa", force, {}},
                                   {"STORED_ENERGY", Kind::scalar, "J/m^3", "as the behaviour keeps it", {}},
                                   {"DISSIPATED_ENERGY", Kind::scalar, "J/m^3", "as the behaviour keeps it", {}}};
  all.insert(all.end(), model.state.begin(), model.state.end());
  return all;
}

/// Where a behaviour keeps its own state: outputs at the end of a step, inputs at its beginning.
void Mfront::add_own(Arrays& a, const auto& add) {
  a.forces = add("the thermodynamic forces", behaviour_.symmetric);
  a.internal = add("the internal state variables", size_of(behaviour_.internal));
  a.stored = add("the stored energy", 1);
  a.dissipated = add("the dissipated energy", 1);
}

Mfront::Mfront(const ForeignTable& table, const double* properties)
    : table_(table),
      model_(table.model),
      behaviour_(*table.behaviour),
      given_(properties, properties + table.model.properties.size()) {
  const std::string at_end = " at the end", at_beginning = " at the beginning";
  std::size_t next = 0;
  const auto source_of = [&](const std::string& name) {
    const auto at = place_of_varying(model_, name);
    return at ? Source{*at, true} : Source{next++};
  };
  for (const std::string& name : behaviour_.prepended) properties_.push_back(source_of(name));
  for (const MfrontVariable& property : behaviour_.properties) properties_.push_back(source_of(property.name));
  parameters_ = next;
  next += behaviour_.parameters.size();
  if (behaviour_.temperature) externals_.push_back(source_of(mfront_temperature));
  for (const MfrontVariable& variable : behaviour_.external)
    externals_.push_back(mfront_kind(variable) == Kind::scalar ? source_of(variable.name) : Source{});
  add_own(end_, [&](const char* words, std::size_t size) { return arrays_.add(words + at_end, size); });
  operator_ = arrays_.add("K", operator_size);
  scalars_ = arrays_.add("the scalars", scalar_count);
  inputs_.begin(arrays_);
  add_inputs(begin_, at_beginning);
  add_inputs(end_, at_end);
  add_own(begin_, [&](const char* words, std::size_t size) {
    return inputs_.add_array(arrays_, words + at_beginning, size, written_beginning);
  });
}

/// What a behaviour is given at both ends of the step.
void Mfront::add_inputs(Arrays& a, const std::string& when) {
  const auto input = [&](WrittenInput name, const char* words, std::size_t size) {
    return inputs_.add_array(arrays_, words + when, size, name);
  };
  a.gradients =
      input(written_gradients, "the gradients", model_.finite_strain ? behaviour_.tensor : behaviour_.symmetric);
  a.density = input(written_others, "the mass density", 1);
  a.properties = input(written_properties, "the material properties", properties_of(behaviour_));
  a.external = input(written_others, "the external state variables",
                     size_of(behaviour_.external) + (behaviour_.temperature ? 1 : 0));
}

MfrontState Mfront::pointers(const Arrays& a) {
  return {arrays_[a.gradients], arrays_[a.forces], arrays_[a.density],    arrays_[a.properties],
          arrays_[a.internal],  arrays_[a.stored], arrays_[a.dissipated], arrays_[a.external]};
}

/// The library keeps parameters for itself, one set for all instances.
void Mfront::set_parameters() {
  if (behaviour_.parameters.empty() || table_.last_set == given_) return;
  const double* values = given_.data() + parameters_;
  for (std::size_t k = 0; k < behaviour_.parameters.size(); ++k) {
    const auto& parameter = behaviour_.parameters[k];
    if (behaviour_.set_parameter) {
      const int taken =
          reinterpret_cast<MfrontSetParameter>(behaviour_.set_parameter)(parameter.name.c_str(), values[k]);
      if (taken == 0) throw PointFailure("the library does not take its own parameter '" + parameter.name + "'");
    } else if (values[k] != parameter.value) {
      throw PointFailure("the library has no function to set parameter '" + parameter.name + "'");
    }
  }
  table_.last_set = given_;
}

void Mfront::initial_state(const Tensor& cauchy, double* state) {
  std::fill_n(state, own_state, 0.0);
  write_symmetric(cauchy, standard_order, plain_shear, state + own_force);
  write_initial(model_.state, state + own_state);
}

void Mfront::hand_over(const PointStep& step, double request) {
  set_parameters();
  F1_ = step.F1;
  require_served(model_, step.F0, step.F1);
  if (model_.finite_strain) {
    put_gradient(step.F0, arrays_[begin_.gradients]);
    put_gradient(step.F1, arrays_[end_.gradients]);
  } else {
    const StepStrain now = logarithmic_strain_of(step.F1);
    R1_ = now.rotation;
    put_symmetric(logarithmic_strain_of(step.F0).strain, arrays_[begin_.gradients]);
    put_symmetric(now.strain, arrays_[end_.gradients]);
  }
  const double unit = model_.units.stress;
  const Tensor before = read_symmetric(step.state0 + own_force, standard_order, plain_shear) / unit;
  const Arrays ends[] = {begin_, end_};
  for (const Arrays& a : ends) {
    put_symmetric(before, arrays_[a.forces]);
    arrays_[a.density][0] = model_.density;
    const double* varying = &a == &ends[1] ? step.fields1 : step.fields0;
    const auto value = [&](const Source& source) { return (source.varies ? varying : given_.data())[source.place]; };
    for (std::size_t k = 0; k < properties_.size(); ++k) arrays_[a.properties][k] = value(properties_[k]);
    give_internal(step.state0 + own_state, arrays_[a.internal]);
    arrays_[a.stored][0] = step.state0[own_stored] / unit;
    arrays_[a.dissipated][0] = step.state0[own_dissipated] / unit;
    arrays_.fill(a.external, 0);
    double* out = arrays_[a.external];
    auto source = externals_.begin();
    if (behaviour_.temperature) *out++ = value(*source++);
    for (const MfrontVariable& variable : behaviour_.external) {
      if (mfront_kind(variable) == Kind::scalar) *out = value(*source);
      ++source;
      out += size_of({variable});
    }
  }
  arrays_.fill(operator_, 0);
  arrays_[operator_][0] = request;  // K[1] = K[2] = 0: Cauchy's stress, d sigma / d F
  constexpr double longest_proposal = 10;
  arrays_[scalars_][rdt] = longest_proposal;
  arrays_[scalars_][speed_of_sound] = 0;
}

std::int32_t Mfront::call(double dt) {
  char message[ASSAY_MESSAGE_SIZE] = "";
  double* s = arrays_[scalars_];
  MfrontData data{message,          dt / model_.units.time, arrays_[operator_], s + rdt, s + speed_of_sound,
                  pointers(begin_), pointers(end_)};
  inputs_.keep(arrays_);
  fill_unset_memory();
  const int status = reinterpret_cast<MfrontEntry>(table_.entry)(&data);
  message[ASSAY_MESSAGE_SIZE - 1] = '\0';
  const auto broken = inputs_.broken_fence(arrays_);
  if (broken) throw PointFailure(overrun_words + ("the behaviour " + *broken));
  if (status == ASSAY_FAILED) {
    const std::string words = message[0] ? ": " + std::string(message) : "";
    throw PointFailure("the behaviour could not integrate the step" + words, std::clamp(s[rdt], 0.01, 0.99));
  }
  if (status != ASSAY_GOOD && status != ASSAY_DOUBTFUL) {
    throw PointFailure("the behaviour returned " + std::to_string(status) + ", which is none of MFront's -1, 0 and 1");
  }
  return status;
}

Tensor Mfront::force() const { return model_.units.stress * symmetric_at(arrays_[end_.forces]); }

/// The first of the six components are those of the plane.
void Mfront::put_symmetric(const Tensor& A, double* out) const {
  double six[6];
  write_symmetric(A, standard_order, mfront_shear, six);
  std::copy_n(six, behaviour_.symmetric, out);
}

Tensor Mfront::symmetric_at(const double* in) const {
  double six[6] = {};
  std::copy_n(in, behaviour_.symmetric, six);
  return read_symmetric(six, standard_order, mfront_shear);
}

void Mfront::put_gradient(const Tensor& F, double* out) const {
  double nine[9];
  write_tensor(F, mfront_tensor_order, nine);
  std::copy_n(nine, behaviour_.tensor, out);
}

std::size_t Mfront::size_of(const std::vector<MfrontVariable>& variables) const {
  std::size_t size = 0;
  for (const MfrontVariable& variable : variables) {
    const Kind kind = mfront_kind(variable);
    const bool whole = variable.type >= always_tridimensional;
    const std::size_t vector = behaviour_.symmetric == 6 ? 3 : 2;
    size += whole || kind == Kind::scalar    ? static_cast<std::size_t>(components_of(kind))
            : kind == Kind::symmetric_tensor ? behaviour_.symmetric
            : kind == Kind::tensor           ? behaviour_.tensor
                                             : vector;
  }
  return size;
}

void Mfront::give_internal(const double* ours, double* theirs) const {
  std::vector<double> whole(static_cast<std::size_t>(foreign_state_size(model_.state)));
  to_foreign(layout, model_.state, ours, whole.data());
  const double* from = whole.data();
  for (const MfrontVariable& variable : behaviour_.internal) {
    theirs = std::copy_n(from, size_of({variable}), theirs);
    from += components_of(mfront_kind(variable));
  }
}

void Mfront::take_internal(const double* theirs, double* ours) const {
  std::vector<double> whole(static_cast<std::size_t>(foreign_state_size(model_.state)));
  double* to = whole.data();
  for (const MfrontVariable& variable : behaviour_.internal) {
    const std::size_t size = size_of({variable});
    std::copy_n(theirs, size, to);
    theirs += size, to += components_of(mfront_kind(variable));
  }
  from_foreign(layout, model_.state, whole.data(), ours);
}

void Mfront::update(const PointStep& step, PointEnd& end) {
  hand_over(step, stress_alone);
  end.status = call(step.dt);
  if (end.status == ASSAY_DOUBTFUL) end.message = "the behaviour calls its result unreliable";
  const Tensor found = force();
  end.cauchy = model_.finite_strain ? found : Tensor(R1_ * found * R1_.transpose() / step.F1.determinant());
  write_symmetric(found, standard_order, plain_shear, end.state1 + own_force);
  end.state1[own_stored] = model_.units.stress * arrays_[end_.stored][0];
  end.state1[own_dissipated] = model_.units.stress * arrays_[end_.dissipated][0];
  take_internal(arrays_[end_.internal], end.state1 + own_state);
}

void Mfront::tangent(const PointStep& step, double* tangent) {
  hand_over(step, consistent_operator);
  call(step.dt);
  const std::size_t columns = model_.finite_strain ? behaviour_.tensor : behaviour_.symmetric;
  const double* K = arrays_[operator_];
  const Tensor T = force();
  /// K on the rate of the gradient.
  const auto rate_of_force = [&](const double* gradient) {
    double s[6] = {};
    for (std::size_t i = 0; i < behaviour_.symmetric; ++i) {
      for (std::size_t j = 0; j < columns; ++j) s[i] += K[i * columns + j] * gradient[j];
    }
    return Tensor(model_.units.stress * read_symmetric(s, standard_order, mfront_shear));
  };
  for (int column = 0; column < 9; ++column) {
    Tensor E = Tensor::Zero(), d;
    component(E, column) = 1;
    double gradient[9] = {};
    if (model_.finite_strain) {
      write_tensor(E, mfront_tensor_order, gradient);
      d = rate_of_force(gradient);
    } else {
      const StepStrain rate = rate_of_logarithmic_strain(step.F1, E);
      write_symmetric(rate.strain, standard_order, mfront_shear, gradient);
      const Tensor w = rate.rotation * R1_.transpose(), sigma = R1_ * T * R1_.transpose();
      const double volume = (E * step.F1.inverse()).trace();
      d = (R1_ * rate_of_force(gradient) * R1_.transpose() + w * sigma - sigma * w - volume * sigma) /
          step.F1.determinant();
    }
    for (int row = 0; row < 9; ++row) tangent[9 * row + column] = component(d, row);
  }
}

}  // namespace assay::adapters
