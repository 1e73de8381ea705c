// SPDX-License-Identifier: BSD-3-Clause
// The handles of the library, closed with these objects, and scenes for them.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "assay.h"

namespace assay::library_test {

struct Close {
  void operator()(assay_problem* handle) const { assay_close(handle); }
  void operator()(assay_points* handle) const { assay_points_close(handle); }
  void operator()(assay_cells* handle) const { assay_cells_close(handle); }
  void operator()(assay_mesh* handle) const { assay_mesh_close(handle); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Close>;

/// A vortex, of neo_hookean unless another material is given.
inline std::string vortex_text(const std::string& material = "neo_hookean, parameters: {E: 1e3, nu: .3}",
                               const std::string& more = {}) {
  return "motion: {type: vortex, amplitude: {type: sine, peak: 1}}\nmaterial: {adapter: " + material +
         ", density: 1000}\nforce: {tolerance: 1e-6, cache: false}\n" + more;
}

inline Owned<assay_problem> opened(const std::string& text, double end = 0, int wanted = ASSAY_DONE) {
  assay_options options = ASSAY_OPTIONS_INIT;
  options.text = text.c_str();
  options.end = end;
  assay_error error = ASSAY_ERROR_INIT;
  assay_problem* problem = nullptr;
  EXPECT_EQ(assay_open(&options, &problem, &error), wanted) << error.message;
  EXPECT_EQ(error.code, wanted);
  return Owned<assay_problem>(problem);
}

/// X: `components` numbers of each point.
inline Owned<assay_points> points_at(const Owned<assay_problem>& problem, const std::vector<double>& X,
                                     int components) {
  assay_error error = ASSAY_ERROR_INIT;
  const assay_const_field field{X.data(), components, 1};
  assay_points* points = nullptr;
  EXPECT_EQ(assay_points_open(problem.get(), X.size() / static_cast<std::size_t>(components), components, &field,
                              &points, &error),
            ASSAY_DONE)
      << error.message;
  return Owned<assay_points>(points);
}

/// All fields of a point, one after the other.
struct Fields {
  double x[3], v[3], a[3], F[9], P[9], sigma[6], b[3], b_static[3];
};
inline constexpr int numbers_of_fields = sizeof(Fields) / sizeof(double);

inline assay_view view_of(std::vector<Fields>& fields, std::vector<std::int32_t>* status = nullptr) {
  assay_view view = ASSAY_VIEW_INIT;
  Fields& f = fields.front();
  view.status = status ? status->data() : nullptr;
  const auto of = [](double* data) { return assay_field{data, numbers_of_fields, 1}; };
  view.x = of(f.x), view.v = of(f.v), view.a = of(f.a);
  view.F = of(f.F), view.P = of(f.P), view.sigma = of(f.sigma);
  view.b = of(f.b), view.b_static = of(f.b_static);
  return view;
}

inline std::vector<Fields> evaluated(const Owned<assay_points>& points, double t, std::size_t n, int wanted = 0,
                                     std::vector<std::int32_t>* status = nullptr) {
  std::vector<Fields> fields(n);
  assay_error error = ASSAY_ERROR_INIT;
  const assay_view view = view_of(fields, status);
  EXPECT_EQ(assay_eval(points.get(), t, 0, n, &view, &error), wanted) << error.message;
  return fields;
}

/// Uniform numbers, the same in each run.
class Numbers {
 public:
  double between(double lower, double upper) { return std::uniform_real_distribution(lower, upper)(engine_); }
  std::vector<double> between(double lower, double upper, std::size_t n) {
    std::vector<double> all(n);
    for (double& each : all) each = between(lower, upper);
    return all;
  }
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_); }

 private:
  std::mt19937 engine_{20261129};
};

}  // namespace assay::library_test
