// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/warnings.hpp"

#include <stdexcept>

#include "drivers/output/number_format.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "harness/check/march.hpp"

namespace assay::drivers {

namespace {

std::string long_step_sentence(const Problem& problem) {
  const double courant = problem.dt * fastest_signal(problem) / problem.scene.grid->spacing;
  if (!problem.scene.time.step || courant <= 1) return "";
  return "time.step = " + rounded_text(problem.dt, 3) + " s is " + rounded_text(courant, 3) +
         " times what the fastest wave takes to cross a cell: the run will hardly be stable";
}

std::string stress_at_rest_sentence(const Problem& problem) {
  constexpr double significant = 1e-6;  // of rho c^2
  if (problem.setup.hold_outside || problem.setup.traction) return "";
  const auto& direction = problem.setup.material_direction;
  const Tensor I = Tensor::Identity();
  double stress = 0;
  try {
    const std::vector<double> state =
        check::state_at_rest(*problem.material, 0, Vector3(direction[0], direction[1], direction[2]));
    stress = check::stepped(*problem.material, 0, problem.dt, I, I, state).cauchy.cwiseAbs().maxCoeff();
  } catch (const std::runtime_error&) {  // the run itself will tell
  }
  if (!(stress > significant * problem.setup.density * problem.wave_speed * problem.wave_speed)) return "";
  return "the material bears " + rounded_text(stress, 3) +
         " Pa at rest, and free faces no traction: the body will not follow the motion there";
}

}  // namespace

std::vector<std::string> warnings_of(const Problem& problem) {
  std::vector<std::string> all{long_step_sentence(problem), stress_at_rest_sentence(problem)};
  std::erase(all, "");
  return all;
}

}  // namespace assay::drivers
