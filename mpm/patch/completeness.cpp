// SPDX-License-Identifier: BSD-3-Clause
// A prescribed nodal velocity v_i is read back by the step itself: with dt = 1 a particle moves by sum phi_ip v_i, and
// L = sum v_i (x) grad phi_ip. Constant v_i: sum phi = 1, sum grad phi = 0. v_i = A x_i: sum phi x_i = x_p, L = A.
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double completeness_threshold = 1e-13;  ///< rounding: at most 5e-16 is found

/// Every component differs.
template <int Dim>
Mat<Dim> slope() {
  if constexpr (Dim == 2) return {0.31, -0.17, 0.23, 0.41};
  if constexpr (Dim == 3) return {0.31, -0.17, 0.11, 0.23, 0.41, -0.29, -0.13, 0.19, 0.37};
}

/// Writes v_i = v + A x_i, and no acceleration, over what the grid has found.
template <int Dim>
Pass<Dim> prescribed_velocity(const Vec<Dim>& v, const Mat<Dim>& A) {
  Pass<Dim> pass;
  pass.name = "prescribed_velocity";
  pass.bind = [v, A](State<Dim>& s) -> Kernel {
    return [&s, v, A](const Instant&) {
      for_every_node(s.setup.grid, [&](std::size_t i, const Vec<Dim>& x) {
        double* node = s.motion.node(i);
        for (std::size_t d = 0; d < Dim; ++d) {
          node[d] = v[d];
          for (std::size_t k = 0; k < Dim; ++k) node[d] += A[d * Dim + k] * x[k];
          node[Dim + d] = 0;
        }
      });
    };
  };
  return pass;
}

/// Largest errors over the particles of the shift, over its own size, and of L times h.
struct Readback {
  double value = 0, gradient = 0;
};

template <int Dim>
Readback read_back(const Method& method, const Bench<Dim>& bench, const Vec<Dim>& v, const Mat<Dim>& A) {
  const Setup<Dim> setup = patch_setup(method, bench, cells_across(bench));
  auto passes = bench.passes(setup);
  insert_after(passes, {Phase::early_gradient, Phase::gradient, Phase::grid}, prescribed_velocity<Dim>(v, A));
  Simulation<Dim> simulation(setup, passes);
  State<Dim>& s = simulation.state();
  arrange(s, Arrangement::jittered);
  const Column at = method.is_total() ? Column::reference_position : Column::position;
  std::vector<Vec<Dim>> x, where;
  for (std::size_t p = 0; p < s.particles; ++p) {
    x.push_back(s.template at<Dim>(Column::position, p));
    where.push_back(s.template at<Dim>(at, p));
  }
  Readback worst;
  if (simulation.step(0, 1)) return {INFINITY, INFINITY};
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < Dim; ++d) {
      double exact = v[d];
      for (std::size_t k = 0; k < Dim; ++k) exact += A[d * Dim + k] * where[p][k];
      const double moved = s.column(Column::position, d)[p] - x[p][d];
      worst.value = larger(worst.value, std::abs(moved - exact));
      for (std::size_t k = 0; k < Dim; ++k) {
        const double L = s.column(Column::velocity_gradient, Dim * d + k)[p];
        worst.gradient = larger(worst.gradient, std::abs(L - A[Dim * d + k]));
      }
    }
  }
  worst.gradient *= setup.grid.spacing;
  return worst;
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> completeness(const Method& method, const Bench<Dim>& bench) {
  Vec<Dim> ones;
  ones.fill(1);
  const Readback unity = read_back<Dim>(method, bench, ones, {}),
                 linear = read_back<Dim>(method, bench, {}, slope<Dim>());
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

template std::vector<check::TestResult> completeness(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
