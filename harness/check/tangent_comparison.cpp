// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/tangent_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/check/judge.hpp"
#include "harness/check/share_along.hpp"

namespace assay::check {

namespace {

/// The part that a change of shape brings, of the deviator: beside a large bulk modulus it is hardly seen in the whole.
Tangent of_shape(const Tangent& A, const Tensor& F) {
  constexpr int diagonal[] = {0, 4, 8};
  Tangent a = spatial_moduli(A, F);
  for (int c = 0; c < 9; ++c) {
    const double mean = (a(0, c) + a(4, c) + a(8, c)) / 3;
    for (const int d : diagonal) a(d, c) -= mean;
  }
  for (int r = 0; r < 9; ++r) {
    const double mean = (a(r, 0) + a(r, 4) + a(r, 8)) / 3;
    for (const int d : diagonal) a(r, d) -= mean;
  }
  return a;
}

/// d sigma / d F of a law whose Jaumann rate of sigma, or of J sigma, is C : d.
Tangent hypoelastic_tangent(const Specimen& specimen, const Sample& s, const Stiffness& C, bool of_kirchhoff) {
  Tangent A;
  for (int column = 0; column < 9; ++column) {
    Tensor E = Tensor::Zero();
    component(E, column) = 1;
    const Tensor l = E * s.F1.inverse(), w = 0.5 * (l - l.transpose()), &sigma = s.end.cauchy;
    Tensor d = stress_of(C, l) + w * sigma - sigma * w;
    if (of_kirchhoff) d -= l.trace() * sigma;
    for (int row = 0; row < 9; ++row) A(row, column) = component(d, row);
  }
  return within(specimen.space, A);
}

}  // namespace

Tangent within(const Space& space, const Tangent& A) {
  Tangent result = A;
  for (int column = 0; column < 9; ++column) {
    if (!space.has(column)) result.col(column).setZero();
  }
  return result;
}

double apart(const Tangent& a, const Tangent& b) {
  if (!a.allFinite() || !b.allFinite()) return INFINITY;
  const double d = (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
  return std::isfinite(d) ? d : INFINITY;
}

double apart_in_shape(const Space& space, const Tangent& a, const Tangent& b, const Tensor& F) {
  constexpr double none = 1e-6;    // of the whole: less is rounding of the differences
  if (space.is_plane()) return 0;  // whose moduli have no columns for what leaves it
  if (!a.allFinite() || !b.allFinite()) return INFINITY;
  const Tangent wanted = of_shape(b, F);
  const double size = wanted.cwiseAbs().maxCoeff();
  if (!(size > none * b.cwiseAbs().maxCoeff())) return 0;
  return (of_shape(a, F) - wanted).cwiseAbs().maxCoeff() / size;
}

double apart_in_whole_and_shape(const Space& space, const Tangent& a, const Tangent& b, const Tensor& F) {
  return std::max(apart(a, b), apart_in_shape(space, a, b, F));
}

std::string farthest_component(const Tangent& given, const Tangent& right, const Tensor& F) {
  const Tangent is = spatial_moduli(given, F), wanted = spatial_moduli(right, F);
  int row = 0, column = 0;
  if (!(is - wanted).allFinite()) return {};
  (is - wanted).cwiseAbs().maxCoeff(&row, &column);
  const auto name = [](int component) {
    const int i = component / 3 + 1, j = component % 3 + 1;
    return std::to_string(std::min(i, j)) + std::to_string(std::max(i, j));
  };
  const double found = is(row, column), expected = wanted(row, column);
  int digits = 2;
  while (digits < 17 && rounded(found, digits) == rounded(expected, digits)) ++digits;
  return "farthest off: what the strain " + name(column) + " adds to the stress " + name(row) + ", which is " +
         rounded(found, digits) + " in place of " + rounded(expected, digits);
}

FromElasticity from_elasticity(const Specimen& specimen, const Sample& s, const Tangent& given) {
  FromElasticity found;
  for (const bool of_kirchhoff : {false, true}) {
    const Tangent turned = hypoelastic_tangent(specimen, s, Stiffness::Zero(), of_kirchhoff);
    const Tangent whole = hypoelastic_tangent(specimen, s, specimen.stiffness, of_kirchhoff);
    const Tangent elastic = whole - turned;
    const double share = share_along(given - turned, elastic);
    const Tangent nearest = turned + share * elastic;
    const double miss = apart_in_whole_and_shape(specimen.space, given, nearest, s.F1);
    found.whole = std::min(found.whole, apart(given, whole));
    if (miss < found.fitted) found.fitted = miss, found.share = share;
  }
  return found;
}

FromRight from_right(const Specimen& specimen, const Sample& s, const Tangent& given, const Tangent& right) {
  FromRight found;
  std::vector<Tangent> turning{Tangent::Zero()};
  for (const bool of_kirchhoff : {false, true})
    turning.push_back(hypoelastic_tangent(specimen, s, Stiffness::Zero(), of_kirchhoff));
  for (const Tangent& turned : turning) {
    const double factor = share_along(given - turned, right - turned);
    const Tangent multiple = turned + factor * (right - turned);
    const double miss = apart_in_whole_and_shape(specimen.space, given, multiple, s.F1);
    if (miss < found.miss) found.miss = miss, found.factor = factor;
    if (specimen.space.is_plane()) continue;  // whose moduli have no columns for what leaves it
    const Tangent wanted = spatial_moduli(right - turned, s.F1), moduli = spatial_moduli(given - turned, s.F1);
    found.transposed = std::min(found.transposed, apart(moduli, wanted.transpose()));
    found.straight = std::min(found.straight, apart(moduli, wanted));
  }
  return found;
}

}  // namespace assay::check
