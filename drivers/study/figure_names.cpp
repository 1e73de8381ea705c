// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/figure_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "drivers/output/numbers.hpp"

namespace assay::drivers {

namespace {

struct Words {
  const char *key, *name, *unit;
};

constexpr std::array words{
    Words{"error.relative", "relative L2 error of the displacement", ""},
    Words{"error.l2_max", "largest L2 error of the displacement", "m"},
    Words{"error.l2_half", "L2 error of the displacement at T/2", "m"},
    Words{"error.l2_end", "L2 error of the displacement at T", "m"},
    Words{"error.linf_max", "largest error of a particle's displacement", "m"},
    Words{"error.rms36_max", "largest rms error of the displacement", "m"},
    Words{"error.rms36_half", "rms error of the displacement at T/2", "m"},
    Words{"error.rms36_end", "rms error of the displacement at T", "m"},
    Words{"error.velocity.l2_max", "largest L2 error of the velocity", "m/s"},
    Words{"error.deformation_gradient.l2_max", "largest L2 error of F", ""},
    Words{"error.jacobian.l2_max", "largest L2 error of J", ""},
    Words{"error.stress.l2_max", "largest L2 error of the Cauchy stress", "Pa"},
    Words{"step_cpu_s", "processor time of the steps", "s"},
    Words{"cpu_s", "processor time of the run", "s"},
    Words{"wall_s", "wall time of the step loop", "s"},
    Words{"work.particle_steps", "particle-steps", ""},
    Words{"work.material_calls", "calls of the material", ""},
    Words{"work.hand_overs", "hand-overs to the workers of a foreign material", ""},
    Words{"work.wake_ups", "times that one side of a hand-over had to be woken", ""},
    Words{"work.bytes", "bytes read and written in particle columns", "B"},
    Words{"peak_rss_bytes", "peak memory", "B"},
};

}  // namespace

std::pair<std::string, std::string> name_and_unit(const std::string& key) {
  for (const Words& each : words) {
    if (key == each.key) return {each.name, each.unit};
  }
  return {key, ""};
}

double rounded_power(int k) { return parse_number("1e" + std::to_string(k)).value_or(k < 0 ? 0.0 : HUGE_VAL); }

}  // namespace assay::drivers
