// SPDX-License-Identifier: BSD-3-Clause
// Of assay.h: points, and the fields there.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drivers/library/exact_problem.hpp"
#include "drivers/library/fields.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/numeric/norms.hpp"

struct assay_points {
  assay::drivers::HandleMark mark = assay::drivers::HandleMark::points;
  std::shared_ptr<const assay::drivers::ExactProblem> problem;
  std::vector<assay::Vector3> X;
  std::vector<char> inside;  ///< whether the motion is defined there
};

namespace assay::drivers {

namespace {

void check_range(const assay_points& points, std::size_t first, std::size_t count) {
  const std::size_t n = points.X.size();
  if (first > n || count > n - first)
    throw RefusedCall("count", "points " + std::to_string(first) + " and " + std::to_string(count) +
                                   " more are beyond the " + std::to_string(n) + " that there are");
}

/// visit(point, exact) of each that the motion knows; otherwise `missing(point)`. Whether it knows all.
template <class Visit, class Missing>
bool each_exact(const ExactSlice& slice, const assay_points& points, std::size_t first, std::size_t count,
                const Visit& visit, const Missing& missing) {
  bool all = true;
  for (std::size_t k = 0; k < count; ++k) {
    if (!points.inside[first + k]) {
      all = false;
      missing(k);
      continue;
    }
    try {
      visit(k, slice.at(points.X[first + k]));
    } catch (const MaterialFailure& failure) {
      throw RefusedCall("points", failure.what(), ASSAY_FINDING, static_cast<std::int64_t>(first + k));
    }
  }
  return all;
}

int outside_code(bool all_inside) { return all_inside ? ASSAY_DONE : ASSAY_OUTSIDE; }

/// The fields of points at a time; what was made for them stays.
int put_fields(const ExactSlice& slice, const assay_points& points, std::size_t first, std::size_t count,
               const assay_view& out) {
  const FieldWriter writer(out, points.problem->dimension());
  return outside_code(each_exact(
      slice, points, first, count, [&](std::size_t k, const ExactPoint& exact) { writer.put(k, exact); },
      [&](std::size_t k) { writer.put_outside(k); }));
}

assay_points points_of(const std::shared_ptr<const ExactProblem>& problem, std::size_t n, int components,
                       const assay_const_field& X, const char* name) {
  refuse_call_if(n > 0 && !X.data, name, "must not be null");
  refuse_call_if(components != 3 && (components != 2 || problem->dimension() == 3), "components",
                 problem->dimension() == 3 ? "must be 3 in three dimensions" : "must be 2 or 3");
  assay_points points;
  points.problem = problem;
  points.X = vectors_of(n, problem->dimension(), X, name);
  points.inside.resize(n);
  std::ranges::transform(points.X, points.inside.begin(), [&](const Vector3& at) { return problem->holds(at); });
  return points;
}

}  // namespace

extern "C" {

int assay_points_open(const assay_problem* problem, size_t n, int components, const assay_const_field* X,
                      assay_points** points, assay_error* error) {
  if (points) *points = nullptr;
  return call_of_library(error, [&] {
    refuse_call_if(!points, "points", "must not be null");
    const auto& shared = known_handle(problem, HandleMark::problem, "problem").shared;
    refuse_call_if(!X, "points.X", "must not be null");
    *points = new assay_points(points_of(shared, n, components, *X, "points.X"));
    return ASSAY_DONE;
  });
}

void assay_points_close(assay_points* points) { close_handle(points, HandleMark::points); }

int assay_eval(const assay_points* points, double t, size_t first, size_t count, const assay_view* out,
               assay_error* error) {
  return call_of_library(error, [&] {
    const assay_points& known = known_handle(points, HandleMark::points, "points");
    const assay_view view = known_part(out, sizeof(assay_view), "out");
    check_view(view);
    check_range(known, first, count);
    const auto slice = known.problem->slice(t);
    return put_fields(*slice, known, first, count, view);
  });
}

int assay_tractions(const assay_points* points, double t, size_t first, size_t count, const assay_const_field* N,
                    const assay_field* traction, assay_error* error) {
  return call_of_library(error, [&] {
    const assay_points& known = known_handle(points, HandleMark::points, "points");
    check_range(known, first, count);
    refuse_call_if(!N || (count > 0 && !N->data), "N", "must not be null");
    refuse_call_if(!traction || (count > 0 && !traction->data), "traction", "must not be null");
    const int dimension = known.problem->dimension();
    const std::vector<Vector3> normals = vectors_of(count, dimension, *N, "N");
    for (std::size_t k = 0; k < count; ++k) {
      if (normals[k] == Vector3::Zero())
        throw RefusedCall("N", "must not be zero", ASSAY_BAD_INPUT, static_cast<std::int64_t>(first + k));
    }
    const auto slice = known.problem->slice(t);
    return outside_code(each_exact(
        *slice, known, first, count,
        [&](std::size_t k, const ExactPoint& exact) {
          put_vector(*traction, k, exact.stress.first_piola_kirchhoff * unit_along(normals[k]), dimension);
        },
        [&](std::size_t k) { put_vector(*traction, k, no_vector(), dimension); }));
  });
}

}  // extern "C"

}  // namespace assay::drivers
