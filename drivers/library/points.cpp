// SPDX-License-Identifier: BSD-3-Clause
// Of assay.h: points, and the fields there.
#include <algorithm>
#include <utility>

#include "drivers/library/exact_problem.hpp"
#include "drivers/library/fields.hpp"
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
    throw RefusedCall("count", std::to_string(count) + " points from number " + std::to_string(first) +
                                   " on are more than the " + std::to_string(n) + " that there are");
}

/// inside(k, exact) of points first + k at which the motion is defined, else outside(k). The code.
int visit_points(const assay_points& points, double t, std::size_t first, std::size_t count, const auto& inside,
                 const auto& outside) {
  const auto slice = points.problem->slice(t);
  bool all_inside = true;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t p = first + k;
    all_inside &= points.inside[p] != 0;
    points.inside[p] ? inside(k, at_point(p, [&] { return slice->at(points.X[p]); })) : outside(k);
  }
  return code_of_points(all_inside);
}

}  // namespace

extern "C" {

ASSAY_API int assay_points_open(const assay_problem* problem, size_t n, int components, const assay_const_field* X,
                                assay_points** points, assay_error* error) {
  if (points) *points = nullptr;
  return call_of_library(error, [&] {
    refuse_call_if(!points, "points", "must not be null");
    const auto& shared = known_handle(problem, HandleMark::problem, "problem").shared;
    refuse_call_if(!X, "points.X", "must not be null");
    check_components(components, shared->dimension());
    auto made = std::make_unique<assay_points>();
    made->problem = shared;
    made->X = vectors_of(n, shared->dimension(), *X, "points.X");
    made->inside.resize(n);
    std::ranges::transform(made->X, made->inside.begin(), [&](const Vector3& at) { return shared->holds(at); });
    *points = made.release();
    return ASSAY_DONE;
  });
}

ASSAY_API void assay_points_close(assay_points* points) { close_handle(points, HandleMark::points); }

ASSAY_API int assay_eval(const assay_points* points, double t, size_t first, size_t count, const assay_view* out,
                         assay_error* error) {
  return call_of_library(error, [&] {
    const assay_points& known = known_handle(points, HandleMark::points, "points");
    const HostViews views(out, known.problem->dimension());
    check_range(known, first, count);
    const auto inside = [&](std::size_t k, const ExactPoint& exact) {
      views.fields.put(k, exact);
      views.tell_inside(k);
    };
    return visit_points(known, t, first, count, inside, [&](std::size_t k) { views.put_outside(k); });
  });
}

ASSAY_API int assay_tractions(const assay_points* points, double t, size_t first, size_t count,
                              const assay_const_field* N, const assay_field* traction, assay_error* error) {
  return call_of_library(error, [&] {
    const assay_points& known = known_handle(points, HandleMark::points, "points");
    check_range(known, first, count);
    refuse_call_if(!N, "N", "must not be null");
    refuse_call_if(!traction || (count > 0 && !traction->data), "traction", "must not be null");
    const int dimension = known.problem->dimension();
    const std::vector<Vector3> normals = vectors_of(count, dimension, *N, "N");
    const auto zero = std::ranges::find(normals, Vector3(Vector3::Zero()));
    if (zero != normals.end())
      throw RefusedCall("N", "must not be zero", ASSAY_BAD_INPUT, static_cast<std::int64_t>(zero - normals.begin()));
    const auto inside = [&](std::size_t k, const ExactPoint& exact) {
      put_vector(*traction, k, exact.stress.first_piola_kirchhoff * unit_along(normals[k]), dimension);
    };
    return visit_points(known, t, first, count, inside,
                        [&](std::size_t k) { put_vector(*traction, k, no_vector(), dimension); });
  });
}

ASSAY_API int assay_at_current(const assay_problem* problem, double t, size_t n, int components,
                               const assay_const_field* x, const assay_field* X, const assay_view* out,
                               assay_error* error) {
  return call_of_library(error, [&] {
    const ExactProblem& known = *known_handle(problem, HandleMark::problem, "problem").shared;
    const HostViews views(out, known.dimension());
    refuse_call_if(!x, "x", "must not be null");
    check_components(components, known.dimension());
    const auto slice = known.slice(t);
    bool all_inside = true;
    const std::vector<Vector3> places = vectors_of(n, known.dimension(), *x, "x");
    for (std::size_t p = 0; p < n; ++p) {
      const std::optional<Vector3> from = known.solution().reference_of(places[p], t);
      const bool inside = from && known.holds(*from);
      all_inside &= inside;
      if (X && X->data) put_vector(*X, p, inside ? *from : no_vector(), known.dimension());
      if (inside) {
        views.fields.put(p, at_point(p, [&] { return slice->at(*from); }));
        views.tell_inside(p);
      } else {
        views.put_outside(p);
      }
    }
    return code_of_points(all_inside);
  });
}

}  // extern "C"

}  // namespace assay::drivers
