// SPDX-License-Identifier: BSD-3-Clause
#include "tests/drivers/simulation/first_breakdown.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "mpm/simulation.hpp"

namespace assay::drivers {

namespace {

std::string breakdown_of(const mpm::State<2>& s) {
  using mpm::Column;
  const auto& grid = s.setup.grid;
  const bool boxed = s.method.basis == mpm::Basis::ugimp;  // within half a cell of the edge it has no nodes
  const double largest = mpm::option<mpm::LargestDomain>(s.setup).cells;
  const double longest = largest > 0 ? largest * grid.spacing : INFINITY;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const auto F = [&](int c) { return s.column(Column::deformation_gradient, c)[p]; };
    const double det = F(0) * F(3) - F(1) * F(2);
    if (!std::isfinite(det + s.column(Column::velocity, 0)[p] + s.column(Column::velocity, 1)[p])) return "value";
    if (!(det > 0)) return "det F";
    for (int d = 0; d < 2; ++d) {
      const auto k = static_cast<std::size_t>(d);
      const double x = s.column(s.method.is_total() ? Column::reference_position : Column::position, d)[p];
      double reach = 0.5 * grid.spacing;  // of the domain, along the axis
      if (!boxed) {
        reach = 0;
        for (std::size_t c = 0; c < 2; ++c) {
          const double edge = s.method.is_total() ? (c == k ? 1.0 : 0.0) : std::abs(F(2 * d + static_cast<int>(c)));
          reach += edge * s.setup.seeds.half_size[c];
        }
      }
      reach = std::min(reach, longest);
      if (x < grid.coordinate(d, 0) + reach || x > grid.coordinate(d, grid.count[k] - 1) - reach) return "grid";
    }
  }
  return "";
}

}  // namespace

Breakdown first_breakdown(const std::string& scene, const std::vector<std::string>& sets) {
  std::vector<std::string> all{"expect={}"};
  all.insert(all.end(), sets.begin(), sets.end());
  Problem problem = assemble(read_scene(scene, all), 1);
  if (problem.compared) {
    problem.setup.exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  }
  mpm::Simulation<2> simulation(problem.setup);
  const mpm::State<2>& s = simulation.state();
  for (std::int64_t k = 0; k < problem.steps; ++k) {
    const double next = problem.time_of_step(k + 1);
    const auto finding = simulation.step(problem.time_of_step(k), next - problem.time_of_step(k));
    std::string what = breakdown_of(s);
    if (what.empty() && finding && finding->kind == mpm::Finding::Kind::material_failed) what = "material";
    if (!what.empty()) return {next, problem.scene.time.end, what};
    if (finding) break;  // a domain, say: what ends a run without a breakdown of a particle
  }
  return {std::numeric_limits<double>::infinity(), problem.scene.time.end, ""};
}

}  // namespace assay::drivers
