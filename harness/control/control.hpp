// SPDX-License-Identifier: BSD-3-Clause
// What is prescribed of a material point: components of its deformation and of its stress as functions of time.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/numeric/tensor.hpp"

namespace assay {

/// What the nine components q of a controlled deformation are.
enum class Deformation {
  gradient,            ///< F [1]; I at rest
  logarithmic_strain,  ///< ln U, and F = U: no rotation [1]
  velocity_gradient,   ///< the integral over time of l = Fdot F^-1 [1]
};

/// What the nine components s of a controlled stress are [Pa].
enum class StressMeasure {
  cauchy,                ///< sigma
  kirchhoff,             ///< J sigma
  first_piola_kirchhoff  ///< P = J sigma F^-T; first index spatial
};

/// A quantity of a point: deformation : q + stress : s + ln_J ln J + J J, with J = det F, products over all nine
/// components.
struct ControlQuantity {
  Tensor deformation = Tensor::Zero();
  Tensor stress = Tensor::Zero();
  double ln_J = 0, J = 0;

  /// Whether it is linear in q: then it prescribes a part of q, to the bit.
  bool is_linear_in_q() const { return stress.isZero(0) && ln_J == 0 && J == 0; }
  bool has_stress() const { return !stress.isZero(0); }
};

/// One equation: the quantity is value(t).
struct ControlRow : ControlQuantity {
  /// after: where it jumps at t, its value behind the jump, else that before.
  std::function<double(double t, bool after)> value;
};

/// Where a history ends before its time.
struct ControlStop {
  enum class When { above, below, peak, loss_of_ellipticity };
  When when = When::above;
  ControlQuantity quantity;  ///< not of loss_of_ellipticity
  double bound = 0;          ///< of above and below
  std::string name;          ///< in sentences: "e11 above 0.1"
};

/// A point on its way. q at rest is I for a gradient, else zero.
struct ControlledPoint {
  double t = 0;                    ///< [s]
  Tensor q = Tensor::Zero();       ///< the controlled deformation
  Tensor F = Tensor::Identity();   ///< [1]
  Tensor s = Tensor::Zero();       ///< the controlled stress [Pa]
  std::vector<double> state = {};  ///< of the material
  double work = 0;                 ///< of the stress since rest, per reference volume [J/m^3]
};

struct Control {
  Deformation deformation = Deformation::gradient;
  StressMeasure stress = StressMeasure::cauchy;
  std::vector<ControlRow> rows;
  std::vector<double> knots;               ///< ascending, begin to end: no step goes over one [s]
  Tensor initial_cauchy = Tensor::Zero();  ///< at rest [Pa]
  std::vector<ControlStop> stops = {};
  std::optional<ControlledPoint> start = {};  ///< where it begins, in place of the rest

  double begin() const { return knots.front(); }
  double end() const { return knots.back(); }
  double length() const { return end() - begin(); }
  /// Components of q that may differ: 6 of a logarithmic strain, else 9.
  int unknowns() const { return deformation == Deformation::logarithmic_strain ? 6 : 9; }
};

Tensor deformation_at_rest(Deformation deformation);

/// F at the end of a step over which the controlled deformation goes from q0 to q1.
Tensor gradient_of(Deformation deformation, const Tensor& F0, const Tensor& q0, const Tensor& q1);

Tensor stress_in(StressMeasure measure, const Tensor& cauchy, const Tensor& F);
Tensor cauchy_of(StressMeasure measure, const Tensor& s, const Tensor& F);

double value_of(const ControlQuantity& quantity, const ControlledPoint& point);

/// The deformation that the rows linear in q leave free: q = particular(t) + free z.
class FreeDeformation {
 public:
  /// Throws ControlError where these rows contradict or repeat each other.
  explicit FreeDeformation(const Control& control);

  int count() const { return static_cast<int>(free_.size()); }
  /// From the values of the prescribing rows, in their order among all rows.
  Tensor particular(const std::vector<double>& values) const;
  Tensor direction(int k) const { return directions_[static_cast<std::size_t>(k)]; }
  /// z of a q: its components that are free themselves.
  double coordinate(const Tensor& q, int k) const { return component(q, free_[static_cast<std::size_t>(k)]); }

 private:
  std::vector<int> free_;           ///< components of q, 0 .. 8
  std::vector<Tensor> directions_;  ///< of q by each
  std::vector<Tensor> by_value_;    ///< of q by the value of each prescribing row
};

/// Rows that cannot be met together, or too many or too few of them. row: which one; -1: their number.
struct ControlError : std::runtime_error {
  ControlError(const std::string& what, int at_row) : std::runtime_error(what), row(at_row) {}
  int row;
};

}  // namespace assay
