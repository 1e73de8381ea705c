// SPDX-License-Identifier: BSD-3-Clause
// Which numbers of a state are tensors: those that, turned with the body, make the next step that of the turned body.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "drivers/check/check_foreign.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/march.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignModel;
using Kind = adapters::ForeignVariable::Kind;

constexpr Kind likely_kinds[] = {Kind::symmetric_tensor, Kind::strain, Kind::mandel, Kind::tensor, Kind::vector};

std::size_t size_of(Kind kind) { return static_cast<std::size_t>(adapters::components_of(kind)); }

/// Components of that kind as Q turns them; shears of some are multiples of the tensor's.
void turn(Kind kind, const Tensor& Q, double* components) {
  const int plain = kind == Kind::vector ? ASSAY_VECTOR : kind == Kind::tensor ? ASSAY_TENSOR : ASSAY_SYMMETRIC_TENSOR;
  const double shear = kind == Kind::strain   ? 1 / adapters::engineering_shear
                       : kind == Kind::mandel ? 1 / adapters::mfront_shear
                                              : 1;
  const Variable read(plain, components);
  const Variable turned = read.with(sheared(read.value(), shear)).turned(Q);
  turned.with(sheared(turned.value(), 1 / shear)).write(components);
}

class Search {
 public:
  Search(const Material& material, const ForeignModel& model, double strain, double pressure)
      : material_(material), model_(model), Q_(check::Space(material).turn(check::turning_angle)) {
    constexpr int count = 12;
    at_rest_ = check::state_at_rest(material, pressure);
    own_ = static_cast<std::size_t>(adapters::foreign_state_size(adapters::bridge_state(model)));
    for (const RepeatedStep& step : repeated_steps(material, strain, pressure, count)) {
      if (!step.first && is_good(answer_of(material, step))) steps_.push_back(step);
    }
  }

  StateGuess guess() {
    StateGuess found;
    found.turns = turns();
    if (found.turns) found.blocks = blocks();
    if (!found.turns || !found.blocks.empty()) return found;
    hold_axes();
    if (turns()) found.blocks = blocks();
    return found;
  }

 private:
  bool turns() {
    as_scalars_ = error({});
    return as_scalars_ > check::own_precision;
  }

  std::vector<StateBlock> blocks() const {
    std::vector<StateBlock> found = one_by_one();
    if (!fits(found)) found = axes();
    return fits(found) ? found : two_at_once();
  }

  /// Increments without a rotation: of a tensor that the model turns as another kind no other steps are right.
  void hold_axes() {
    for (RepeatedStep& step : steps_) {
      const Tensor increment = step.F1 * step.F0.inverse();
      step.F1 = Eigen::SelfAdjointEigenSolver<Tensor>(increment.transpose() * increment).operatorSqrt() * step.F0;
    }
  }

  bool fits(const std::vector<StateBlock>& blocks) const {
    return !blocks.empty() && explains(error(blocks), as_scalars_);
  }

  /// Whether what is left of an error is none, or that of an integrator whose steps depend on the frame.
  static bool explains(double left, double error) {
    constexpr double share = 0.05;
    return left <= std::max(check::own_precision, share * error);
  }

  /// Of the stress of a turned body, if these are tensors, over all steps.
  double error(const std::vector<StateBlock>& blocks) const {
    double worst = 0;
    for (const RepeatedStep& step : steps_) worst = std::max(worst, error_of(step, blocks));
    return steps_.empty() ? 0 : worst;
  }

  double error_of(const RepeatedStep& step, const std::vector<StateBlock>& blocks) const {
    RepeatedStep seen = step;
    seen.F0 = Q_ * step.F0;
    seen.F1 = Q_ * step.F1;
    turn_declared(seen.state0);
    for (const StateBlock& block : blocks) turn(block.kind, Q_, &seen.state0[own_ + block.first]);
    const Answer usual = answer_of(material_, step), found = answer_of(material_, seen);
    if (!is_good(usual) || !is_good(found)) return is_good(usual) == is_good(found) ? 0 : INFINITY;
    const Tensor expected = stress_in(usual);
    const double scale = std::max(largest_stress(usual), 1e-300);
    return check::distance(check::rotated(Q_.transpose(), stress_in(found)), expected) / scale;
  }

  static Tensor stress_in(const Answer& answer) { return tensor_of(&answer[stress_of_answer]); }

  /// The bridge's own, and those that are said to be tensors.
  void turn_declared(std::vector<double>& state) const {
    for (const StatePlace& place : assay::state_of(material_.table())) {
      if (place.kind != ASSAY_SCALAR && place.role == ASSAY_ROLE_PLAIN)
        place.in(state).turned(Q_).write(&state[place.first]);
    }
  }

  /// Places where so many numbers follow each other of which nobody has said what they are.
  std::vector<StateBlock> candidates() const {
    std::vector<bool> unknown;
    for (const adapters::ForeignVariable& v : model_.state)
      unknown.insert(unknown.end(), size_of(v.kind), !v.kind_is_said && v.kind == Kind::scalar);
    std::vector<StateBlock> all;
    for (std::size_t first = 0; first < unknown.size(); ++first) {
      for (const Kind kind : likely_kinds) {
        const auto begin = unknown.begin() + static_cast<std::ptrdiff_t>(first);
        if (first + size_of(kind) > unknown.size()) continue;
        const auto end = begin + static_cast<std::ptrdiff_t>(size_of(kind));
        if (std::find(begin, end, false) == end) all.push_back({first, kind});
      }
    }
    return all;
  }

  /// The same step where only these numbers are those of the loaded body: the others are as at rest, where a tensor
  /// is nothing, or the identity.
  RepeatedStep alone(const RepeatedStep& step, const StateBlock& block) const {
    RepeatedStep other = step;
    const auto rest = at_rest_.begin() + static_cast<std::ptrdiff_t>(own_);
    std::copy_n(rest, adapters::foreign_state_size(model_.state),
                other.state0.begin() + static_cast<std::ptrdiff_t>(own_));
    std::copy_n(&step.state0[own_ + block.first], size_of(block.kind), &other.state0[own_ + block.first]);
    return other;
  }

  bool is_tensor_by_itself(const StateBlock& block) const {
    bool matters = false;
    for (const RepeatedStep& step : steps_) {
      const RepeatedStep other = alone(step, block);
      const double as_scalars = error_of(other, {});
      if (!explains(error_of(other, {block}), as_scalars)) return false;
      matters = matters || as_scalars > check::own_precision;
    }
    return matters;
  }

  std::vector<StateBlock> one_by_one() const {
    std::vector<StateBlock> found;
    std::size_t end = 0;
    for (const StateBlock& block : candidates()) {
      if (block.first < end || !is_tensor_by_itself(block)) continue;
      found.push_back(block);
      end = block.first + size_of(block.kind);
    }
    return found;
  }

  /// Three vectors one after the other, as of a matrix whose columns turn: those of a crystal, or of F. One that is
  /// turned alone is no such matrix any more.
  std::vector<StateBlock> axes() const {
    const std::vector<StateBlock> all = candidates();
    for (const StateBlock& first : all) {
      std::vector<StateBlock> three{first, {first.first + 3, first.kind}, {first.first + 6, first.kind}};
      const auto is_candidate = [&](const StateBlock& block) { return std::ranges::count(all, block) > 0; };
      if (first.kind == Kind::vector && std::ranges::all_of(three, is_candidate) && fits(three)) return three;
    }
    return {};
  }

  /// Numbers that mean nothing without others.
  std::vector<StateBlock> two_at_once() const {
    constexpr std::size_t most = 100;
    const std::vector<StateBlock> all = candidates();
    for (const StateBlock& one : all) {
      if (fits({one})) return {one};
    }
    for (const StateBlock& one : all) {
      for (const StateBlock& other : all) {
        if (all.size() > most || other.first < one.first + size_of(one.kind)) continue;
        if (fits({one, other})) return {one, other};
      }
    }
    return {};
  }

  const Material& material_;
  const ForeignModel& model_;
  Tensor Q_;
  std::vector<double> at_rest_;
  std::size_t own_;  ///< components before STATEV
  double as_scalars_ = 0;
  std::vector<RepeatedStep> steps_;
};

}  // namespace

StateGuess guessed_blocks(const ResolvedMaterial& material, const ForeignModel& model, double strain, double pressure) {
  try {
    return Search(material.material, model, strain, pressure).guess();
  } catch (const std::runtime_error&) {
    return {};
  }
}

ForeignModel with_blocks(const ForeignModel& model, const std::vector<StateBlock>& blocks) {
  ForeignModel other = model;
  other.state.clear();
  std::map<std::size_t, Kind> kind_at;
  for (const StateBlock& block : blocks) kind_at[block.first] = block.kind;
  std::size_t at = 0, covered = 0;
  for (const adapters::ForeignVariable& v : model.state) {
    if (const auto block = kind_at.find(at); block != kind_at.end()) {
      const std::size_t end = at + size_of(block->second);
      adapters::ForeignVariable tensor{"STATEV(" + std::to_string(at + 1) + ":" + std::to_string(end) + ")"};
      tensor.kind = block->second;
      other.state.push_back(tensor);
      covered = end;
    }
    if (at < covered) {
      const std::vector<double> first = v.initial.empty() ? std::vector<double>{0} : v.initial;
      other.state.back().initial.push_back(first.front());
    } else {
      other.state.push_back(v);
    }
    at += size_of(v.kind);
  }
  return other;
}

}  // namespace assay::drivers
