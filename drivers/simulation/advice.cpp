// SPDX-License-Identifier: BSD-3-Clause
// What a run that died, or erred, could try.
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "drivers/simulation/time_steps.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/check/march.hpp"
#include "harness/stability/tangent_modulus.hpp"

namespace assay::drivers {

namespace {

constexpr double safe_courant = 0.4;  ///< of the recommended method, in every case of the stability map
/// K/G of nearly incompressible materials, nu = 0.49967: with nu = 0.4999 averaged volumes lower the error 30 times;
/// with nu = 0.499 they serve fine grids alone (docs/hard.md).
constexpr double incompressible = 1500;
constexpr double fine_grid =
    64;  ///< cells across the body; with 48 averaged volumes make it unstable at nu = 0.4999 (measured)
constexpr double least_shear = 1e-8;  ///< of the stiffness: what is less is a fluid's, or rounding of differences

bool is_recommended(const mpm::Method& method) {
  return method.is_total() && method.basis == mpm::Basis::bspline2 && method.transfer == mpm::Transfer::aflip;
}

/// K/G at rest, by the stiffest and the softest direction of waves, K + 4/3 G and G; 0 of a fluid, and where the
/// material does not answer.
template <int Dim>
double bulk_over_shear(const ProblemIn<Dim>& problem) {
  const auto& direction = problem.setup.material_direction;
  const Tensor I = Tensor::Identity();
  try {
    const std::vector<double> state =
        check::state_at_rest(*problem.material, 0, Vector3(direction[0], direction[1], direction[2]));
    const TangentModulus A = probe_tangent_modulus(*problem.material, 0, problem.dt, I, state);
    const double shear = smallest_acoustic_eigenvalue(A).value, stiffest = largest_acoustic_eigenvalue(A).value;
    return shear > least_shear * stiffest ? stiffest / shear - 4.0 / 3 : 0;
  } catch (const std::runtime_error&) {
    return 0;
  }
}

/// Cells along the longer side of the body.
template <int Dim>
double cells_across(const ProblemIn<Dim>& problem) {
  const auto sides = sides_of_body(problem);
  return *std::max_element(sides.begin(), sides.end()) / problem.scene.grid->spacing;
}

/// Empty where few waves cross the body.
template <int Dim>
std::string few_waves_advice(const ProblemIn<Dim>& problem) {
  const auto period = period_of_few_waves(problem);
  if (!period) return {};
  return "motion.period: " + period_text(problem, *period) +
         ", in which a wave crosses the body twice as in the paper's vortex";
}

}  // namespace

template <int Dim>
std::array<double, Dim> sides_of_body(const ProblemIn<Dim>& problem) {
  const mpm::Seeds<Dim>& seeds = problem.setup.seeds;
  std::array<double, Dim> sides{};
  for (std::size_t d = 0; d < Dim && seeds.size() > 0; ++d) {
    const auto [least, most] = std::minmax_element(seeds.X[d].begin(), seeds.X[d].end());
    sides[d] = *most - *least + 2 * seeds.half_size[d];
  }
  return sides;
}

template <int Dim>
std::string advice_after_large_error(const ProblemIn<Dim>& problem, double relative) {
  constexpr double large = 0.3;  ///< where the waves of a stiff model are to blame
  std::string few = few_waves_advice(problem);
  if (!(relative > (few.empty() ? 1 : large))) return {};
  const std::string why =
      ". The error is " + (relative > 1 ? "larger than the motion" : rounded_text(relative, 2) + " of the motion") +
      ". If it stays on a finer grid, the cause is most likely the material: assay check of the model";
  return (few.empty() ? "" : few + "; or ") + "a finer grid" + why;
}

template <int Dim>
std::string advice_after_death(const ProblemIn<Dim>& problem, const std::string& reason) {
  if (!problem.compared && reason.find("left the grid") != reason.npos)
    return "grid.lower and grid.upper: a free body needs room for its whole path";
  if (const auto period = shorter_period(problem)) {
    return "motion.period: " + period_text(problem, *period) +
           ", in which a wave crosses the body some thirty times: errors of very many waves add up";
  }
  const auto& method = *problem.scene.method;
  const mpm::EffectOptions& options = problem.setup.options;
  const std::string courant = "courant: " + rounded_text(safe_courant, 2);
  const double stiffness = bulk_over_shear(problem);
  const bool locks = stiffness > incompressible, averages = options.of<mpm::AntiLocking>() != mpm::AntiLocking::none;
  const bool helps = locks && cells_across(problem) > fine_grid - 0.5;
  std::vector<std::string> keys;
  if (!is_recommended(method)) {
    keys.push_back(
        "method: {basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, integrator: "
        "leapfrog, " +
        courant + "}");
  } else if (method.courant > safe_courant) {
    keys.push_back("method." + courant);
  }
  const double taken = problem.dt * fastest_signal(problem) / problem.scene.grid->spacing;
  const auto fixed = problem.scene.time.fixed_step();
  if (fixed && (!keys.empty() || taken > safe_courant)) keys.push_back(std::string("no ") + fixed->key);
  if (helps && !averages) keys.emplace_back("remedies.anti_locking: cell");
  if (!helps && averages) keys.emplace_back("remedies.anti_locking: none");
  if (options.of<mpm::LargestDomain>().cells > 0) keys.emplace_back("no remedies.largest_domain");
  std::string few = few_waves_advice(problem);
  if (keys.empty()) return few;
  std::string changes;
  for (const std::string& key : keys) changes += (changes.empty() ? "" : "; ") + key;
  const std::string locking = locks ? "; K/G is " + rounded_text(stiffness, 2) +
                                          ": particles lock. remedies.anti_locking: cell helps with at least " +
                                          rounded_text(fine_grid, 2) +
                                          " cells across; on a coarser grid it makes runs unstable"
                                    : "";
  const std::string model = problem.library.empty() ? "" : "assay check of the model, if it has not passed yet; ";
  const std::string measured =
      Dim == 3 ? "most hard cases that were measured in space" : "every hard case that was measured";
  return few + (few.empty() ? "" : "; ") + model + "total B-splines (" + changes + ") complete " + measured + locking;
}

template std::array<double, 2> sides_of_body<2>(const ProblemIn<2>&);
template std::array<double, 3> sides_of_body<3>(const ProblemIn<3>&);
template std::string advice_after_large_error(const ProblemIn<2>&, double);
template std::string advice_after_large_error(const ProblemIn<3>&, double);
template std::string advice_after_death(const ProblemIn<2>&, const std::string&);
template std::string advice_after_death(const ProblemIn<3>&, const std::string&);

}  // namespace assay::drivers
