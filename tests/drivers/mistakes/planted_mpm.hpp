// SPDX-License-Identifier: BSD-3-Clause
// Our own particle methods with a mistake: passes are planted into their steps.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "drivers/mistakes/perturbed_scene.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "mpm/simulation.hpp"

namespace assay::drivers {

/// The exact force of the solution itself, at any point.
class ForceOfSolution : public ExactForce {
 public:
  explicit ForceOfSolution(ExactSolutionPtr exact) : exact_(std::move(exact)) {}
  ForceParts at(const Vector3& X, double t) const override {
    const ExactPoint point = exact_->at(X, t);
    return {point.state.x, point.state.a, point.stress.static_force};
  }

 private:
  ExactSolutionPtr exact_;
};

/// A scene with a grid and a method, run with a mistake.
inline MeasuredErrors run_of_mpm(const std::string& file, const std::vector<std::string>& sets, const Mistake& mistake,
                                 int outputs = 20) {
  Problem problem = assemble(read_scene(file, sets), 1);
  problem.setup.accounts = false;
  const auto exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  const ForceOfSolution force(exact_solution_of_points(problem.scene, problem.material, problem.scene.time.end));
  problem.setup.exact = exact;
  const double stiffness = mistake.stress(Tensor::Identity(), Tensor::Identity())(0, 0);
  problem.setup.density *= mistake.mass();
  std::vector<mpm::Pass<2>> passes = mpm::compose(problem.setup);
  const auto plant = [&](const char* behind, const char* name, auto act) {
    mpm::Pass<2> pass;
    pass.name = name;
    pass.bind = [act](mpm::State<2>& s) -> mpm::Kernel { return [&s, act](const mpm::Instant& now) { act(s, now); }; };
    for (std::size_t k = 0; k < passes.size(); ++k) {
      if (passes[k].name.rfind(behind, 0) != 0) continue;
      pass.slot = passes[k].slot, pass.stages = passes[k].stages;
      passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(k + 1), pass);
      ++k;
    }
  };
  plant("body_force", "planted_force", [&](mpm::State<2>& s, const mpm::Instant& now) {
    for (std::size_t p = 0; p < s.particles; ++p) {
      const auto of = [&](mpm::Column column) { return Vector3(s.column(column, 0)[p], s.column(column, 1)[p], 0); };
      const double t = std::clamp(mistake.load_time(now.t), 0.0, problem.scene.time.end);
      const Vector3 b = mistake.body_force(force, of(mpm::Column::reference_position), of(mpm::Column::position), t);
      for (int d = 0; d < 2; ++d) s.column(mpm::Column::body_force, d)[p] = b[d];
    }
  });
  plant("stress", "planted_stress", [&](mpm::State<2>& s, const mpm::Instant& now) {
    if (stiffness != 1) {
      for (int c = 0; c < mpm::stress_components<2>; ++c) {
        for (std::size_t p = 0; p < s.particles; ++p) s.column(mpm::Column::stress, c)[p] *= stiffness;
      }
    }
    const double kept = std::exp(-mistake.damping() * now.dt);
    for (int d = 0; d < 2; ++d) {
      for (std::size_t p = 0; p < s.particles; ++p) s.column(mpm::Column::velocity, d)[p] *= kept;
    }
  });
  mpm::Simulation<2> simulation(problem.setup, passes);
  mpm::State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {
    Vector3 v(s.column(mpm::Column::velocity, 0)[p], s.column(mpm::Column::velocity, 1)[p], 0);
    v = mistake.initial_velocity(v);
    for (int d = 0; d < 2; ++d) s.column(mpm::Column::velocity, d)[p] = v[d];
  }
  const auto ring = ring_of(problem.scene.motion);
  MeasuredErrors found{problem.scene.grid->spacing, bins_of(problem.scene)};
  const auto note = [&](double t) {
    found.errors.begin_frame(t);
    for (std::size_t p = 0; p < s.particles; ++p) {
      const auto of = [&](mpm::Column column) { return Vector3(s.column(column, 0)[p], s.column(column, 1)[p], 0); };
      const Vector3 X = of(mpm::Column::reference_position), x = exact->state(X, t).x;
      const Vector3 error = of(mpm::Column::position) - x;
      if (ring && !ring->holds(X.norm()))
        found.errors.add_at_rest(X, error);
      else
        found.errors.add(X, error, x, s.column(mpm::Column::mass, 0)[p]);
    }
  };
  note(0);
  std::int64_t next = 1;
  for (std::int64_t k = 0; k < problem.steps; ++k) {
    const double t = problem.time_of_step(k), later = problem.time_of_step(k + 1);
    if (simulation.step(t, later - t)) break;
    if (later < problem.scene.time.end * static_cast<double>(next) / outputs - 1e-12) continue;
    note(later), ++next;
  }
  found.errors.finish();
  return found;
}

}  // namespace assay::drivers
