// SPDX-License-Identifier: BSD-3-Clause
// Fixed reference points of an exact solution. What depends on a point alone is found once; what depends on a time
// alone stands in a slice, which is made once for all points.
//
//   ExactSolution --places(X)--> ExactPlaces --+
//                 --slice(t)---> ExactSlice  --+--evaluate--> the fields that are wanted, of points first, first + 1,
//                 ...
//
// A field of a point is a function of X and t alone, to the last bit: it does not depend on the other points, on what
// else is wanted, or on what was asked before. Neither changes, and any number of threads may ask.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"

namespace assay {

/// Component c of point p is data[p * point + c * component]; strides in doubles.
struct FieldView {
  double* data = nullptr;  ///< null: not wanted
  std::ptrdiff_t point = 0, component = 0;

  explicit operator bool() const { return data != nullptr; }
  double& at(std::size_t p, std::size_t c) const {
    return data[static_cast<std::ptrdiff_t>(p) * point + static_cast<std::ptrdiff_t>(c) * component];
  }
  FieldView from(std::size_t p) const {
    return {data ? data + static_cast<std::ptrdiff_t>(p) * point : nullptr, point, component};
  }
};

/// What is wanted of points, and where it is written. F and P have nine components, row-major; sigma has six: 11, 22,
/// 33, 12, 13, 23.
struct FieldViews {
  std::size_t dimension = 3;             ///< components of vectors that are written
  FieldView x = {}, v = {}, a = {};      ///< [m], [m/s], [m/s^2]
  FieldView F = {}, P = {}, sigma = {};  ///< [1], [Pa], [Pa]
  FieldView b = {}, static_force = {};   ///< a - DIV(P)/rho0, and without a [m/s^2]

  bool any_stress() const { return P || sigma || b || static_force; }
  FieldViews from(std::size_t point) const;
  void put(std::size_t point, const ExactPoint& values) const;
};

/// The fields of one point as plain numbers.
struct PointFields {
  std::array<double, 3> x, v, a;
  std::array<double, 9> F, P;
  std::array<double, 6> sigma;
  std::array<double, 3> b, static_force;

  /// The views of an array of them.
  static FieldViews views(PointFields* first);
  /// But for the rate of F.
  ExactPoint point() const;
};

class ExactPlaces {
 public:
  /// X: reference points [m].
  explicit ExactPlaces(std::vector<Vector3> X) : X_(std::move(X)) {}
  virtual ~ExactPlaces() = default;

  std::size_t size() const { return X_.size(); }
  const Vector3& X(std::size_t point) const { return X_[point]; }

  /// Of points first .. first + count - 1; a view's first point is `first`. now: a slice of the solution that made
  /// these places. Throws MaterialFailure.
  virtual void evaluate(const ExactSlice& now, std::size_t first, std::size_t count, const FieldViews& out) const;

  virtual bool moves(const ExactSlice& now, std::size_t point) const { return now.moves(X_[point]); }
  virtual Vector3 displacement(const ExactSlice& now, std::size_t point) const { return now.displacement(X_[point]); }

 private:
  std::vector<Vector3> X_;
};

}  // namespace assay
