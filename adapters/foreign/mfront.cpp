// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/mfront.hpp"

#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/kinematics.hpp"

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

std::size_t size_of(const std::vector<MfrontVariable>& variables) {
  std::size_t size = 0;
  for (const MfrontVariable& variable : variables)
    size += static_cast<std::size_t>(components_of(mfront_kind(variable)));
  return size;
}

std::size_t properties_of(const MfrontBehaviour& behaviour) {
  return behaviour.prepended.size() + behaviour.properties.size();
}

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
  a.forces = add("the thermodynamic forces", 6);
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
  a.gradients = input(written_gradients, "the gradients", model_.finite_strain ? 9 : 6);
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
  const double* values = given_.data() + properties_of(behaviour_);
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
  if (model_.finite_strain) {
    write_tensor(step.F0, mfront_tensor_order, arrays_[begin_.gradients]);
    write_tensor(step.F1, mfront_tensor_order, arrays_[end_.gradients]);
  } else {
    const StepStrain now = logarithmic_strain_of(step.F1);
    R1_ = now.rotation;
    write_symmetric(logarithmic_strain_of(step.F0).strain, standard_order, mfront_shear, arrays_[begin_.gradients]);
    write_symmetric(now.strain, standard_order, mfront_shear, arrays_[end_.gradients]);
  }
  const double unit = model_.units.stress;
  const Tensor before = read_symmetric(step.state0 + own_force, standard_order, plain_shear) / unit;
  for (const Arrays& a : {begin_, end_}) {
    write_symmetric(before, standard_order, mfront_shear, arrays_[a.forces]);
    arrays_[a.density][0] = model_.density;
    std::copy_n(given_.data(), properties_of(behaviour_), arrays_[a.properties]);
    to_foreign(layout, model_.state, step.state0 + own_state, arrays_[a.internal]);
    arrays_[a.stored][0] = step.state0[own_stored] / unit;
    arrays_[a.dissipated][0] = step.state0[own_dissipated] / unit;
    arrays_.fill(a.external, 0);
    const double* external = given_.data() + properties_of(behaviour_) + behaviour_.parameters.size();
    double* out = arrays_[a.external];
    if (behaviour_.temperature) *out++ = *external++;
    for (const MfrontVariable& variable : behaviour_.external) {
      const bool scalar = mfront_kind(variable) == Kind::scalar;
      if (scalar) *out = *external++;
      out += components_of(mfront_kind(variable));
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

Tensor Mfront::force() const {
  return model_.units.stress * read_symmetric(arrays_[end_.forces], standard_order, mfront_shear);
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
  from_foreign(layout, model_.state, arrays_[end_.internal], end.state1 + own_state);
}

void Mfront::tangent(const PointStep& step, double* tangent) {
  hand_over(step, consistent_operator);
  call(step.dt);
  const std::size_t columns = model_.finite_strain ? 9 : 6;
  const double* K = arrays_[operator_];
  const Tensor T = force();
  /// K on the rate of the gradient.
  const auto rate_of_force = [&](const double* gradient) {
    double s[6] = {};
    for (std::size_t i = 0; i < 6; ++i) {
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
