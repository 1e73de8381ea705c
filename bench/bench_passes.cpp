// SPDX-License-Identifier: BSD-3-Clause
// Each pass of a step of the paper's vortex, in particles a second.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "mpm/lattice.hpp"
#include "mpm/simulation.hpp"

extern "C" const assay_material* assay_builtin_neo_hookean(std::uint32_t host_major, std::uint32_t index);

namespace {

using namespace assay;
using namespace assay::mpm;

/// The free ring with 2x2 particles a cell, so many cells across: 5,032 particles at 10.
Setup<2> vortex(Basis basis, int across) {
  Setup<2> setup;
  const Vortex motion;
  const double h = (motion.outer - motion.inner) / across;
  const std::array<double, 2> lower{-motion.outer, -motion.outer}, upper{motion.outer, motion.outer};
  setup.method.basis = basis;
  setup.grid = grid_around(lower, upper, h, 4);
  setup.seeds = cartesian_lattice(lower, upper, h, {2, 2}, [&](const auto& X) {
    return motion.moves({X[0], X[1], 0}) ? Fate::stepped : Fate::absent;
  });
  setup.density = 1000;
  setup.material = std::make_shared<const Material>(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0),
                                                    std::map<std::string, double>{{"E", 1e3}, {"nu", 0.3}});
  setup.motion = motion;
  setup.body_force = setup.accounts = true;
  setup.response = std::make_shared<const Response>(Sheet(*setup.material, motion.baseline(), {}));
  return setup;
}

/// One pass again and again on the state that some steps of the whole list have left; a length of step so small that
/// a thousand repetitions move nothing.
void pass_of_step(benchmark::State& state, Basis basis, int across, std::size_t which) {
  Simulation<2> simulation(vortex(basis, across));
  const double dt = 1.0 / (200 * across);
  for (int k = 0; k < 10; ++k) simulation.step(k * dt, dt);
  const Kernel kernel = compose(simulation.state().setup)[which].bind(simulation.state());
  const Instant now{10 * dt, 1e-12 * dt};
  for (auto _ : state) kernel(now);
  if (simulation.state().finding) state.SkipWithError(simulation.state().finding->reason.c_str());
  state.SetItemsProcessed(static_cast<std::int64_t>(simulation.state().particles) * state.iterations());
}

void whole_step(benchmark::State& state, Basis basis, int across) {
  Simulation<2> simulation(vortex(basis, across));
  const double dt = 1.0 / (200 * across);
  std::int64_t k = 0;
  for (auto _ : state) {
    simulation.step(static_cast<double>(k % 20) * dt, 1e-3 * dt);
    ++k;
  }
  if (simulation.state().finding) state.SkipWithError(simulation.state().finding->reason.c_str());
  state.SetItemsProcessed(static_cast<std::int64_t>(simulation.state().particles) * state.iterations());
}

/// One benchmark a pass: the list of passes is data.
const int registered = [] {
  for (const auto& [basis, name] : {std::pair{Basis::cpdi, "cpdi"}, std::pair{Basis::ugimp, "ugimp"}}) {
    for (const int across : {10, 40}) {
      const Setup<2> setup = vortex(basis, 10);
      const auto passes = compose(setup);
      const std::string prefix = std::string(name) + "/" + std::to_string(across) + "/";
      for (std::size_t k = 0; k < passes.size(); ++k) {
        benchmark::RegisterBenchmark((prefix + passes[k].name).c_str(), [=, b = basis](benchmark::State& state) {
          pass_of_step(state, b, across, k);
        })->Unit(benchmark::kMicrosecond);
      }
      benchmark::RegisterBenchmark((prefix + "step").c_str(), [=, b = basis](benchmark::State& state) {
        whole_step(state, b, across);
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return 0;
}();

}  // namespace
