// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_control.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/point_drivers/mtest_components.hpp"
#include "drivers/point_drivers/mtest_fields.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::drivers {

namespace {

using Quantity = MtestImposed::Quantity;

const double root2 = std::sqrt(2.0);

/// Places of MTest's components: "XX", "RR" are 11; "YY", and "ZZ" of a ring, are 22.
struct Place {
  int i = 0, j = 0;
};
std::optional<Place> place_of(const std::string& ends, const std::string& hypothesis) {
  const bool ring = hypothesis.starts_with("Axisymmetrical");
  const std::string axes = ring ? "RZT" : "XYZ";
  if (ends.size() != 2) return std::nullopt;
  const std::size_t i = axes.find(ends[0]), j = axes.find(ends[1]);
  if (i == axes.npos || j == axes.npos) return std::nullopt;
  return Place{static_cast<int>(i), static_cast<int>(j)};
}

[[noreturn]] void cannot(const MtestFile& file, const std::string& keyword, const std::string& what) {
  throw InputError({file.file, 0, 0}, keyword, what);
}

void refuse_what_is_not_served(const MtestFile& file) {
  if (!file.constraints.empty()) throw InputError(file.constraints[0].where, "@NonLinearConstraint", "is not served");
  if (file.behaviour.is_model) cannot(file, "@Model", "has no stress: it is not served");
  if (!file.behaviour.wrapper.empty())
    cannot(file, "@Behaviour", "the wrapper " + file.behaviour.wrapper + " is not served");
  if (file.kinematics == MtestKinematics::other)
    cannot(file, "@ImposedGradient", "only strains and deformation gradients are served");
  for (const MtestProperty& property : file.properties) {
    if (property.computed_by)
      throw InputError(property.where, "@MaterialProperty", "a property that a library computes is not served");
  }
  for (const MtestImposed& imposed : file.imposed) {
    if (imposed.quantity == Quantity::gradient || imposed.quantity == Quantity::force)
      throw InputError(imposed.where, imposed.component, "only components of strain, F and stress are served");
  }
}

/// The material's directions are its columns.
Tensor rotation_of(const MtestFile& file) {
  Tensor R = Tensor::Identity();
  for (int c = 0; file.is_rotated && c < 9; ++c) component(R, c) = file.rotation[static_cast<std::size_t>(c)];
  return R;
}

/// The behaviour works in its own axes, in which its internal variables stay.
Tensor in_material(const Tensor& R, const Tensor& A) { return R.transpose() * A * R; }

/// Rows of what is imposed, zero stress where nothing is. Lower components of F that nobody imposes are held: a
/// symmetric stress cannot find them.
void add_rows(const MtestFile& file, Control& control) {
  const bool finite = control.deformation == Deformation::gradient;
  Tensor imposed_deformation = Tensor::Zero(), imposed_stress = Tensor::Zero();
  for (const MtestImposed& imposed : file.imposed) {
    const auto place = place_of(imposed.component.substr(1), file.hypothesis);
    if (!place) throw InputError(imposed.where, imposed.component, "is no component of strain, F or stress");
    const bool stress = imposed.quantity == Quantity::stress;
    const bool gradient = imposed.quantity == Quantity::deformation_gradient;
    const int i = gradient ? place->i : std::min(place->i, place->j),
              j = gradient ? place->j : std::max(place->i, place->j);
    (stress ? imposed_stress : imposed_deformation)(i, j) = 1;
    ControlRow row;
    (stress ? row.stress : row.deformation)(i, j) = 1;
    const double factor = gradient || i == j ? 1 : 1 / root2;
    row.value = [f = imposed.value, factor](double t, bool) { return factor * f(t); };
    control.rows.push_back(std::move(row));
  }
  const bool plane = file.hypothesis != "Tridimensional",
             line = file.hypothesis.starts_with("AxisymmetricalGeneralised");
  const auto add = [&](int i, int j, bool stress, double value) {
    ControlRow row;
    (stress ? row.stress : row.deformation)(i, j) = 1;
    row.value = [value](double, bool) { return value; };
    control.rows.push_back(std::move(row));
  };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!finite && j < i) continue;
      const int low = std::min(i, j), high = std::max(i, j);
      if (imposed_deformation(i, j) != 0 || (i <= j && imposed_stress(low, high) != 0)) continue;
      const bool absent = i != j && (line || (plane && high == 2));
      const bool fixed = file.hypothesis == "PlaneStrain" && i == 2 && j == 2;
      if (absent || fixed || j < i) {
        add(i, j, false, finite && i == j ? 1 : 0);
      } else {
        add(i, j, true, 0);
      }
    }
  }
}

/// Whether the host of a foreign model keeps its stress, first in the state. The initial values of internal variables
/// then tell the model of it, and not its first step.
bool keeps_stress(const Material& material) {
  const auto places = state_of(material.table());
  return !places.empty() && std::string(places[0].name) == "STRESS" && places[0].kind == ASSAY_SYMMETRIC_TENSOR;
}

void set_stress(const Tensor& stress, ControlledPoint& start) {
  Variable(ASSAY_SYMMETRIC_TENSOR, start.state.data()).with(stress).write(start.state.data());
}

/// Values of internal variables at the beginning.
void set_initial_state(const MtestFile& file, const Material& material, ControlledPoint& start) {
  for (const MtestInitialValue& initial : file.initial_state) {
    bool found = file.hypothesis == "PlaneStress" && initial.name == "AxialStrain";  // which the point has as a strain
    if (found) start.q(2, 2) = initial.values.at(0);
    for (const StatePlace& place : state_of(material.table())) {
      if (initial.name != place.name) continue;
      found = true;
      for (std::size_t c = 0; c < place.size; ++c) {
        const double value =
            initial.in_braces ? (c < initial.values.size() ? initial.values[c] : 0) : initial.values[0];
        start.state[place.first + c] = place.size == 6 && c >= 3 ? value / root2 : value;
      }
    }
    if (!found)
      throw InputError(initial.where, "@InternalStateVariable", "the model has no variable '" + initial.name + "'");
  }
}

}  // namespace

Control mtest_control(const MtestFile& file, const Material& material) {
  refuse_what_is_not_served(file);
  Control control;
  const bool finite = file.kinematics == MtestKinematics::finite_strain;
  control.deformation = finite ? Deformation::gradient : Deformation::logarithmic_strain;
  control.stress = finite ? StressMeasure::cauchy : StressMeasure::kirchhoff;
  control.knots = file.times;
  add_rows(file, control);
  const Tensor R = rotation_of(file);
  for (ControlRow& row : control.rows) {
    row.deformation = in_material(R, row.deformation);
    row.stress = in_material(R, row.stress);
    if (thermal_strain(file, file.times.front()) && row.is_linear_in_q()) {
      row.value = [&file, total = row.value, along = row.deformation](double t, bool after) {
        return total(t, after) - along.cwiseProduct(*thermal_strain(file, t)).sum();
      };
    }
  }
  const MtestHypothesis& hypothesis = *find_hypothesis(file.hypothesis);
  const auto at_begin = [&](const std::vector<double>& values) {
    Tensor A = Tensor::Zero();
    for (std::size_t k = 0; k < values.size() && k < hypothesis.symmetric.size(); ++k) {
      const auto place = place_of(hypothesis.symmetric[k], file.hypothesis);
      A(place->i, place->j) = A(place->j, place->i) = place->i == place->j ? values[k] : values[k] / root2;
    }
    return in_material(R, A);
  };
  const Tensor force = at_begin(file.initial_force);
  if (!keeps_stress(material)) control.initial_cauchy = force;
  ControlledPoint start = point_at_rest(material, control);
  start.s = force;
  if (keeps_stress(material)) set_stress(force, start);
  const Tensor rest = start.q;
  if (!finite) start.q = at_begin(file.initial_gradient) - thermal_strain(file, start.t).value_or(Tensor::Zero());
  set_initial_state(file, material, start);
  if (!finite) start.F = gradient_of(control.deformation, start.F, rest, start.q);
  control.start = std::move(start);
  return control;
}

std::optional<double> mtest_value(const MtestFile& file, const Material& material, const std::string& name,
                                  const ControlledRow& row) {
  if (name.size() == 3 && (name[0] == 'E' || name[0] == 'F' || name[0] == 'S')) {
    if (const auto place = place_of(name.substr(1), file.hypothesis)) {
      const double factor = place->i == place->j || name[0] == 'F' ? 1 : root2;
      // the behaviour itself finds the strain of a component without stress, which MTest leaves alone
      const bool own = file.hypothesis == "PlaneStress" && place->i == 2 && place->j == 2;
      if (own && name[0] != 'S') return name[0] == 'F' ? 1 : 0;
      const Tensor R = rotation_of(file);
      Tensor value = name[0] == 'S' ? row.s : row.q;
      if (name[0] == 'E') value += thermal_strain(file, row.t).value_or(Tensor::Zero());
      return factor * (R * value * R.transpose())(place->i, place->j);
    }
  }
  constexpr int symmetric[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (const StatePlace& place : state_of(material.table())) {
    if (!name.starts_with(place.name)) continue;
    if (name == place.name && place.size == 1) return row.state[place.first];
    const auto at = place_of(name.substr(std::string(place.name).size()), file.hypothesis);
    if (!at || place.size != 6) continue;
    for (std::size_t c = 0; c < 6; ++c) {
      if (symmetric[c][0] == std::min(at->i, at->j) && symmetric[c][1] == std::max(at->i, at->j))
        return row.state[place.first + c] * (c < 3 ? 1 : root2);
    }
  }
  if (file.hypothesis == "PlaneStress" && name == "AxialStrain") return row.q(2, 2);
  for (const MtestVariable& variable : file.external) {
    if (variable.name == name) return variable.value(row.t);
  }
  return std::nullopt;
}

}  // namespace assay::drivers
