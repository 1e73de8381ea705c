// SPDX-License-Identifier: BSD-3-Clause
// Steps of the paper's vortex by the methods that people choose between, in particles a second, and in each the
// nanoseconds a particle of its passes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "bench/machine.hpp"
#include "mpm/lattice.hpp"
#include "mpm/particle_order.hpp"
#include "mpm/simulation.hpp"

extern "C" const assay_material* assay_builtin_neo_hookean(std::uint32_t host_major, std::uint32_t index);

namespace {

using namespace assay;
using namespace assay::mpm;

struct Case {
  const char* name;
  Method method;
};

std::vector<Case> cases() {
  const auto with = [](Basis basis, Formulation formulation, Transfer transfer, int terms) {
    Method method;
    method.basis = basis, method.formulation = formulation, method.transfer = transfer;
    if (terms > 1) method.mass = Mass::series, method.terms = terms;
    return method;
  };
  using enum Basis;
  const auto updated = Formulation::updated, total = Formulation::total;
  return {{"cpdi_flip", with(cpdi, updated, Transfer::flip, 1)},
          {"ugimp_flip", with(ugimp, updated, Transfer::flip, 1)},
          {"bspline2_flip", with(bspline2, updated, Transfer::flip, 1)},
          {"cpdi2_aflip_k2", with(cpdi2, updated, Transfer::aflip, 2)},
          {"total_bspline2_flip", with(bspline2, total, Transfer::flip, 1)},
          {"total_bspline2_aflip_k4", with(bspline2, total, Transfer::aflip, 4)}};
}

/// The free ring with 2x2 particles a cell, so many cells across: 5,032 particles at 10.
Setup<2> vortex(const Method& method, int across, int threads) {
  Setup<2> setup;
  const Vortex motion;
  const double h = (motion.outer - motion.inner) / across;
  const std::array<double, 2> lower{-motion.outer, -motion.outer}, upper{motion.outer, motion.outer};
  setup.method = method;
  setup.grid = grid_around(lower, upper, h, 4);
  setup.seeds = cartesian_lattice(lower, upper, h, {2, 2}, [&](const auto& X) {
    return motion.moves({X[0], X[1], 0}) ? Fate::stepped : Fate::absent;
  });
  order_by_nodes(setup);
  setup.density = 1000;
  setup.material = std::make_shared<const Material>(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0),
                                                    std::map<std::string, double>{{"E", 1e3}, {"nu", 0.3}});
  setup.motion = motion;
  setup.body_force = true;
  setup.evaluation = Evaluation::domain_average;
  setup.response = std::make_shared<const Response>(Sheet(*setup.material, motion.baseline(), {}));
  setup.threads = threads;
  return setup;
}

/// Of all methods: a table has the same columns in each line.
constexpr const char* passes[] = {"body_force", "weights", "particles_to_grid", "grid_update", "grid_to_particles",
                                  "affine",     "stress"};

/// bytes_per_second: of memory.
void memory(benchmark::State& state, int threads) {
  constexpr std::size_t n = std::size_t{1} << 24;  // 384 MiB: no cache holds them
  std::vector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  for (auto _ : state) bench::triad(a.data(), b.data(), c.data(), n, threads);
  state.SetBytesProcessed(static_cast<std::int64_t>(24 * n) * state.iterations());
  state.SetItemsProcessed(0);
  for (const char* pass : passes) state.counters[pass] = 0;
}

/// items_per_second: multiplications and additions that are not fused, as in the kernels.
void arithmetic(benchmark::State& state) {
  constexpr std::size_t rounds = 100000;
  for (auto _ : state) benchmark::DoNotOptimize(bench::multiply_add(rounds));
  state.SetItemsProcessed(static_cast<std::int64_t>(bench::operations_a_round * rounds) * state.iterations());
  state.SetBytesProcessed(0);
  for (const char* pass : passes) state.counters[pass] = 0;
}

/// Steps from t = 0.3 of the period on, so short that nothing moves: the exact state is not that of the particles, and
/// no pass minds.
void step(benchmark::State& state, const Method& method, int across, int threads, Instructions instructions) {
  Setup<2> setup = vortex(method, across, threads);
  setup.instructions = instructions;
  Simulation<2> simulation(std::move(setup));
  const double dt = 1e-9;
  simulation.step(0.3, dt);
  const auto before = simulation.times();
  for (auto _ : state) simulation.step(0.3, dt);
  if (simulation.state().finding) state.SkipWithError(simulation.state().finding->reason.c_str());
  const double steps = static_cast<double>(simulation.state().particles) * static_cast<double>(state.iterations());
  state.SetItemsProcessed(static_cast<std::int64_t>(steps));
  for (const char* pass : passes) state.counters[pass] = 0;
  double bytes = 0;  // that passes read and write of columns; those that run together find some in the cache
  for (std::size_t k = 0; k < before.size(); ++k) {
    bytes += static_cast<double>(simulation.times()[k].bytes_per_particle);
    state.counters[before[k].name] = 1e9 * (simulation.times()[k].seconds - before[k].seconds) / steps;
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes * steps));
}

const int registered = [] {
  const auto add = [](const Case& c, int across, int threads, Instructions instructions) {
    const std::string name = std::string(c.name) + "/" + std::to_string(across) + "/" + std::to_string(threads) + "/" +
                             std::string(assay::mpm::name(instructions));
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) { step(state, c.method, across, threads, instructions); })
        ->Unit(benchmark::kMicrosecond)
        ->UseRealTime();
  };
  for (const int threads : {1, 2}) {
    const std::string name = "machine/memory/" + std::to_string(threads);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { memory(state, threads); })->UseRealTime();
  }
  benchmark::RegisterBenchmark("machine/arithmetic/1", arithmetic);
  for (const Case& c : cases()) {
    for (const Instructions instructions : usable_instructions()) add(c, 20, 1, instructions);
    for (const int threads : {1, 2}) add(c, 45, threads, best_instructions());
  }
  return 0;
}();

}  // namespace
