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
  std::unique_ptr<const assay::ExactPlaces> places;
  std::vector<char> inside;  ///< whether the motion is defined there
};

namespace assay::drivers {

namespace {

void check_range(const assay_points& points, std::size_t first, std::size_t count) {
  const std::size_t n = points.places->size();
  if (first > n || count > n - first)
    throw RefusedCall("count", std::to_string(count) + " points from number " + std::to_string(first) +
                                   " on are more than the " + std::to_string(n) + " that there are");
}

/// The fields of points, all of which the motion knows; a view's first point is `first`.
void put_fields(const assay_points& points, const ExactSlice& slice, std::size_t first, std::size_t count,
                const FieldViews& out) {
  try {
    points.places->evaluate(slice, first, count, out);
  } catch (const MaterialFailure&) {
    for (std::size_t k = 0; k < count; ++k)
      at_point(first + k, [&] { points.places->evaluate(slice, first + k, 1, out.from(k)); });
  }
}

/// inside(slice, k, n) of runs of n points, from first + k on, at which the motion is defined, else outside(k). The
/// code.
int visit_points(const assay_points& points, double t, std::size_t first, std::size_t count, const auto& inside,
                 const auto& outside) {
  const auto slice = points.problem->slice(t);
  std::optional<std::size_t> first_outside;
  for (std::size_t k = 0; k < count;) {
    const auto here = points.inside.begin() + static_cast<std::ptrdiff_t>(first + k);
    const auto run = std::find(here, here + static_cast<std::ptrdiff_t>(count - k), 0) - here;
    if (run > 0) {
      inside(*slice, k, static_cast<std::size_t>(run));
    } else {
      outside(k);
      if (!first_outside) first_outside = first + k;
    }
    k += static_cast<std::size_t>(std::max<std::ptrdiff_t>(run, 1));
  }
  return code_of_points(first_outside);
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
    std::vector<Vector3> places = vectors_of(n, shared->dimension(), *X, "points.X");
    made->inside.resize(n);
    std::ranges::transform(places, made->inside.begin(), [&](const Vector3& at) { return shared->holds(at); });
    made->places = shared->solution().places(std::move(places));
    *points = made.release();
    return ASSAY_DONE;
  });
}

ASSAY_API void assay_points_close(assay_points* points) { close_handle(points, HandleMark::points); }

ASSAY_API int assay_eval(const assay_points* points, double t, size_t first, size_t count, const assay_view* out,
                         assay_error* error) {
  return call_of_library(error, [&] {
    const assay_points& known = known_handle(points, HandleMark::points, "points");
    const HostViews views(out, count, known.problem->dimension(), known.problem->is_quasi_static());
    check_range(known, first, count);
    const auto inside = [&](const ExactSlice& slice, std::size_t k, std::size_t run) {
      put_fields(known, slice, first + k, run, views.fields.from(k));
      for (std::size_t i = k; i < k + run; ++i) views.finish(i);
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
    check_strides(*traction, count, "traction");
    const int dimension = known.problem->dimension();
    const std::vector<Vector3> normals = vectors_of(count, dimension, *N, "N");
    const auto zero = std::ranges::find(normals, Vector3(Vector3::Zero()));
    if (zero != normals.end())
      throw RefusedCall("N", "must not be zero", ASSAY_BAD_INPUT, static_cast<std::int64_t>(zero - normals.begin()));
    const auto inside = [&](const ExactSlice& slice, std::size_t k, std::size_t run) {
      std::vector<double> P(9 * run);
      put_fields(known, slice, first + k, run, {.P = {P.data(), 9, 1}});
      for (std::size_t i = 0; i < run; ++i)
        put_vector(*traction, k + i, tensor_of(P.data() + 9 * i) * unit_along(normals[k + i]), dimension);
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
    const HostViews views(out, n, known.dimension(), known.is_quasi_static());
    refuse_call_if(!x, "x", "must not be null");
    if (X) check_strides(*X, n, "X");
    check_components(components, known.dimension());
    const auto slice = known.slice(t);
    std::optional<std::size_t> first_outside;
    const std::vector<Vector3> places = vectors_of(n, known.dimension(), *x, "x");
    for (std::size_t p = 0; p < n; ++p) {
      const std::optional<Vector3> from = known.solution().reference_of(places[p], t);
      const bool inside = from && known.holds(*from);
      if (!inside && !first_outside) first_outside = p;
      if (X && X->data) put_vector(*X, p, inside ? *from : no_vector(), known.dimension());
      if (inside) {
        views.fields.put(p, at_point(p, [&] { return slice->at(*from); }));
        views.finish(p);
      } else {
        views.put_outside(p);
      }
    }
    return code_of_points(first_outside);
  });
}

}  // extern "C"

}  // namespace assay::drivers
