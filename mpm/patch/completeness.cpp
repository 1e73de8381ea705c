// SPDX-License-Identifier: BSD-3-Clause
// A prescribed nodal velocity v_i is read back by the step itself: with dt = 1 a particle moves by sum phi_ip v_i, and
// L = sum v_i (x) grad phi_ip. Constant v_i: sum phi = 1, sum grad phi = 0. v_i = A x_i: sum phi x_i = x_p, L = A.
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double completeness_threshold = 1e-13;  ///< rounding: at most 5e-16 is found
constexpr Mat<2> slope{0.31, -0.17, 0.23, 0.41};

/// Writes v_i = v + A x_i, and no acceleration, over what the grid has found.
Pass<2> prescribed_velocity(const Vec<2>& v, const Mat<2>& A) {
  Pass<2> pass;
  pass.name = "prescribed_velocity";
  pass.bind = [v, A](State<2>& s) -> Kernel {
    return [&s, v, A](const Instant&) {
      const GridGeometry<2>& grid = s.setup.grid;
      for (std::int32_t j = 0; j < grid.count[1]; ++j) {
        for (std::int32_t i = 0; i < grid.count[0]; ++i) {
          const double x = grid.coordinate(0, i), y = grid.coordinate(1, j);
          double* node = s.motion.node(static_cast<std::size_t>(j * grid.count[0] + i));
          node[0] = v[0] + A[0] * x + A[1] * y;
          node[1] = v[1] + A[2] * x + A[3] * y;
          node[2] = node[3] = 0;
        }
      }
    };
  };
  return pass;
}

/// Largest errors over the particles of the shift, over its own size, and of L times h.
struct Readback {
  double value = 0, gradient = 0;
};

Readback read_back(const Method& method, const Bench& bench, const Vec<2>& v, const Mat<2>& A) {
  const Setup<2> setup = patch_setup(method, bench, bench.quick ? 8 : 32);
  auto passes = bench.passes(setup);
  insert_after(passes, {Phase::early_gradient, Phase::gradient, Phase::grid}, prescribed_velocity(v, A));
  Simulation<2> simulation(setup, passes);
  State<2>& s = simulation.state();
  arrange(s, Arrangement::jittered);
  const Column at = method.is_total() ? Column::reference_position : Column::position;
  std::vector<Vec<2>> x, where;
  for (std::size_t p = 0; p < s.particles; ++p) {
    x.push_back(s.at<2>(Column::position, p));
    where.push_back(s.at<2>(at, p));
  }
  Readback worst;
  if (simulation.step(0, 1)) return {INFINITY, INFINITY};
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < 2; ++d) {
      const double exact = v[d] + A[2 * d] * where[p][0] + A[2 * d + 1] * where[p][1];
      const double moved = s.column(Column::position, d)[p] - x[p][d];
      worst.value = larger(worst.value, std::abs(moved - exact));
      for (std::size_t k = 0; k < 2; ++k) {
        const double L = s.column(Column::velocity_gradient, 2 * d + k)[p];
        worst.gradient = larger(worst.gradient, std::abs(L - A[2 * d + k]));
      }
    }
  }
  worst.gradient *= setup.grid.spacing;
  return worst;
}

}  // namespace

std::vector<check::TestResult> completeness(const Method& method, const Bench& bench) {
  const Readback unity = read_back(method, bench, {1, 1}, {}), linear = read_back(method, bench, {}, slope);
  return {judged(method, "weights.unity",
                 {larger(unity.value, unity.gradient), "sum phi - 1 is at most " + digits(unity.value) +
                                                           ", h |sum grad phi| " + digits(unity.gradient) +
                                                           ", on a jittered set"},
                 completeness_threshold, "no partition of unity"),
          judged(method, "weights.linear",
                 {larger(linear.value, linear.gradient), "a linear field is off by at most " + digits(linear.value) +
                                                             ", its gradient by " + digits(linear.gradient) +
                                                             "/h, on a jittered set"},
                 completeness_threshold, "linear fields not reproduced")};
}

}  // namespace assay::mpm
