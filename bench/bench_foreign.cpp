// SPDX-License-Identifier: BSD-3-Clause
// A call of a UMAT, J2 with kinematic hardening that flows, through its bridge: ns.
#include <benchmark/benchmark.h>

#include <vector>

#include "adapters/foreign/foreign_table.hpp"
#include "drivers/material/material_description.hpp"
#include "harness/material/material.hpp"

namespace {

using namespace assay;

drivers::MaterialDescription description() {
  return drivers::read_description(
      "library: " ASSAY_BINARY_DIR
      "/tests/foreign/umat_j2.so\ninterface: umat\n"
      "properties: [1.0e3, 0.3, 5, 0, 50]\nstate: {back_stress: symmetric_tensor, p: scalar}\n"
      "flags: [non_smooth]\ndensity: 1000\n",
      "bench.yaml");
}

/// Shear from rest to far beyond yield, step by step.
void update_through_the_bridge(benchmark::State& state) {
  const Material material(adapters::foreign_table(*description().foreign), {});
  std::vector<double> before = material.initial_state(1), after(before.size());
  double F0[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, F1[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, cauchy[9];
  constexpr double increment = 1e-4;
  constexpr int turn_back = 1000;
  int k = 0;
  for (auto _ : state) {
    F1[1] = F0[1] + (k++ / turn_back % 2 == 0 ? increment : -increment);
    material.update(0, 1e-3, 1, F0, F1, before.data(), after.data(), cauchy);
    before.swap(after);
    F0[1] = F1[1];
    benchmark::DoNotOptimize(cauchy);
  }
}
BENCHMARK(update_through_the_bridge);

}  // namespace
