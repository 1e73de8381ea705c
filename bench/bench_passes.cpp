// SPDX-License-Identifier: BSD-3-Clause
// Steps of the paper's vortex by the methods that people choose between, in particles a second, and in each the
// nanoseconds a particle of its passes.
#include <benchmark/benchmark.h>

#include "bench/machine.hpp"
#include "bench/method_cases.hpp"
#include "mpm/simulation.hpp"

namespace {

using namespace assay;
using namespace assay::mpm;
using bench::Case;

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

/// items_per_second: multiplications and additions.
void arithmetic(benchmark::State& state, double (*work)(std::size_t)) {
  constexpr std::size_t rounds = 100000;
  for (auto _ : state) benchmark::DoNotOptimize(work(rounds));
  state.SetItemsProcessed(static_cast<std::int64_t>(bench::operations_a_round * rounds) * state.iterations());
  state.SetBytesProcessed(0);
  for (const char* pass : passes) state.counters[pass] = 0;
}

void step(benchmark::State& state, const Method& method, int across, int threads, Instructions instructions) {
  Setup<2> setup = bench::vortex(method, across, threads);
  setup.instructions = instructions;
  Simulation<2> simulation(std::move(setup));
  simulation.step(bench::step_begin, bench::step_length);
  const auto before = simulation.times();
  for (auto _ : state) simulation.step(bench::step_begin, bench::step_length);
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
  // not fused, as in the kernels; and fused
  benchmark::RegisterBenchmark("machine/arithmetic/1", arithmetic, bench::multiply_add);
  benchmark::RegisterBenchmark("machine/fused/1", arithmetic, bench::fused_multiply_add);
  for (const Case& c : bench::method_cases()) {
    for (const Instructions instructions : usable_instructions()) add(c, 20, 1, instructions);
    for (const int threads : {1, 2}) add(c, 45, threads, best_instructions());
  }
  return 0;
}();

}  // namespace
