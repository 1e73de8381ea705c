// SPDX-License-Identifier: BSD-3-Clause
// As what a state or a stress must be read for a turned step to be right: the defect follows from that.
#include "harness/check/turned_step.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

constexpr double explained = 1e-3;  ///< of an error that an assumption leaves

/// What components of the state or of the stress are taken for; the first two are no defect. `reordered` is nothing in
/// the plane.
enum class As { tensor, own_frame, reordered, half_shear, double_shear, count };

/// Of each: the defect that it is, and what its shears are multiplied by where it is read.
struct Reading {
  Turned defect;
  double shears;
};
constexpr Reading readings[] = {{Turned::rightly, 1},
                                {Turned::not_at_all, 1},
                                {Turned::in_another_order, 1},
                                {Turned::with_shear_factor, 0.5},
                                {Turned::with_shear_factor, 2}};

const Reading& reading_of(As as) { return readings[static_cast<std::size_t>(as)]; }

Tensor read_as(As as, const ShearOrder& order, const Tensor& A) {
  return as == As::reordered ? in_order(reversed(order), A) : sheared(A, reading_of(as).shears);
}

Tensor written_as(As as, const ShearOrder& order, const Tensor& A) {
  return as == As::reordered ? in_order(order, A) : sheared(A, 1 / reading_of(as).shears);
}

/// One loading step from a state and from the same state turned.
class Assumptions {
 public:
  Assumptions(const Specimen& specimen, const Loaded& from, double s)
      : material_(*specimen.material), space_(specimen.space), from_(from), places_(places_of(material_)) {
    F1_ = further_on(specimen, s);
    expected_ = step(from.F, F1_, from.point.state).cauchy;
    scale_ = specimen.scale(size_of(expected_));
    places_.resize(std::min(places_.size(), most_));
  }

  bool can_be(As as) const { return as != As::reordered || !space_.is_plane(); }

  /// Of the stress, if each variable is what it is assumed to be, and so is the stress.
  double error(const std::vector<As>& variables, As output, const ShearOrder& order) const {
    const Tensor Q = space_.turn(turning_angle);
    std::vector<double> state = from_.point.state;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      if (variables[v] == As::own_frame) continue;
      const Variable stored = places_[v].in(state);
      const Variable meant = stored.is_tensor() ? stored.with(read_as(variables[v], order, stored.value())) : stored;
      const Variable turned = meant.turned(Q);
      (stored.is_tensor() ? turned.with(written_as(variables[v], order, turned.value())) : turned)
          .write(&state[places_[v].first]);
    }
    const Tensor seen = step(Q * from_.F, Q * F1_, state).cauchy;
    return distance(rotated(Q.transpose(), read_as(output, order, seen)), read_as(output, order, expected_)) / scale_;
  }

  const std::vector<StatePlace>& places() const { return places_; }

  /// What the variables are declared to be.
  std::vector<As> declared() const {
    std::vector<As> all;
    for (const StatePlace& place : places_) all.push_back(place.turns_itself() ? As::own_frame : As::tensor);
    return all;
  }

 private:
  static constexpr std::size_t most_ = 4;  ///< variables, each with five assumptions

  Point step(const Tensor& F0, const Tensor& F1, const std::vector<double>& state) const {
    return stepped(material_, 1, from_.length, F0, F1, state);
  }

  const Material& material_;
  Space space_;
  const Loaded& from_;
  std::vector<StatePlace> places_;
  Tensor F1_, expected_;
  double scale_;
};

/// The least unlikely assumptions that explain the error, of those less unlikely than `least_cost`.
void explain(const Assumptions& assumptions, const ShearOrder& order, double& least_cost, TurnedStep& found) {
  const std::vector<As> declared = assumptions.declared();
  const std::size_t count = declared.size();
  const auto kinds = static_cast<std::size_t>(As::count);
  std::size_t all = 1;
  for (std::size_t v = 0; v < count; ++v) all *= kinds;
  for (std::size_t code = 0; code < all; ++code) {
    std::vector<As> variables(count);
    double cost = 0;
    for (std::size_t v = 0, rest = code; v < count; ++v, rest /= kinds) {
      variables[v] = static_cast<As>(rest % kinds);
      const bool likely = variables[v] == As::tensor || variables[v] == As::own_frame;
      const double of_this = variables[v] == declared[v] ? 0 : likely ? 1 : 2;
      cost += assumptions.can_be(variables[v]) ? of_this : INFINITY;
    }
    const bool reorders = std::find(variables.begin(), variables.end(), As::reordered) != variables.end();
    for (const As output : {As::tensor, As::reordered, As::half_shear, As::double_shear}) {
      if (!reorders && output != As::reordered && order != other_orders.front()) continue;  // tried with the first
      const double with_output = cost + (output == As::tensor ? 0 : 1.5);
      if (!assumptions.can_be(output) || with_output >= least_cost ||
          assumptions.error(variables, output, order) > explained * found.error)
        continue;
      least_cost = with_output;
      found.stress = reading_of(output).defect;
      found.order = order;
      found.taken.clear();
      for (std::size_t v = 0; v < count; ++v) {
        found.taken.push_back({.name = assumptions.places()[v].name, .how = reading_of(variables[v]).defect});
      }
    }
  }
}

}  // namespace

std::vector<StatePlace> places_of(const Material& material) {
  std::vector<StatePlace> all = state_of(material.table());
  std::erase_if(all, [](const StatePlace& place) {
    const bool turns = place.kind != ASSAY_SCALAR && place.role == ASSAY_ROLE_PLAIN;
    return !turns && !place.turns_itself();
  });
  return all;
}

Tensor further_on(const Specimen& specimen, double s) {
  constexpr double further = 0.02;
  return specimen.stretch(s + further);
}

void read_back(const Specimen& specimen, const Loaded& from, double s, TurnedStep& found) {
  const Assumptions assumptions(specimen, from, s);
  const std::vector<As> declared = assumptions.declared();
  found.error = assumptions.error(declared, As::tensor, other_orders.front());
  for (std::size_t v = 0; v < declared.size(); ++v) {
    found.taken.push_back({.name = assumptions.places()[v].name, .how = reading_of(declared[v]).defect});
  }
  if (!(found.error > own_precision)) return;
  double least_cost = INFINITY;
  for (const ShearOrder& order : other_orders) explain(assumptions, order, least_cost, found);
}

}  // namespace assay::check
