// SPDX-License-Identifier: BSD-3-Clause
// Batched update of the built-in neo-Hookean model through the ABI, in points a second.
#include <benchmark/benchmark.h>

#include <vector>

#include "harness/material/material.hpp"

extern "C" const assay_material* assay_builtin_neo_hookean(std::uint32_t host_major, std::uint32_t index);

namespace {

void update_neo_hookean(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const assay::Material material(assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0), {{"E", 1e3}, {"nu", 0.3}});
  std::vector<double> F(9 * n, 0.0), cauchy(9 * n);
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c : {0, 4, 8}) F[c * n + p] = 1;
    F[n + p] = 1e-3 * static_cast<double>(p % 97);  // shear, no two neighbours alike
  }
  for (auto _ : state) {
    material.update(0, 1e-3, n, F.data(), F.data(), nullptr, nullptr, cauchy.data());
    benchmark::DoNotOptimize(cauchy.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(n) * state.iterations());
}
BENCHMARK(update_neo_hookean)->Arg(1)->Arg(64)->Arg(ASSAY_BATCH_MAX);

}  // namespace
