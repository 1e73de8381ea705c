// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/units_hint.hpp"

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

std::string units_hint(const PosedScene& problem) {
  constexpr double lightest = 1e-10, heaviest = 1e-7;  // solids in t/mm^3: foams to osmium
  constexpr double slow = 1e5, fast = 1e8;             // of waves [mm/s]: in soft gels, and well above those in diamond
  const double density = problem.scene.material.density;
  const bool is_one =
      density >= lightest && density <= heaviest && problem.wave_speed > slow && problem.wave_speed < fast;
  if (!problem.scene.units.is_si() || !is_one) return {};
  return "a density of " + rounded_text(density, 3) + " with waves of " + rounded_text(problem.wave_speed, 3) +
         " m/s is that of a scene in mm, MPa and s (t/mm^3): if it is one, begin it with `units: {length: mm, stress: "
         "MPa, time: s}`";
}

std::string units_hint_for_many_steps(const PosedScene& problem) {
  constexpr std::int64_t many = 200'000;
  const std::string hint = problem.steps > many ? units_hint(problem) : "";
  return hint.empty() ? hint : grouped_text(problem.steps) + " steps: " + hint;
}

}  // namespace assay::drivers
