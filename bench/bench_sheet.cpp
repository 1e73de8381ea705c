// SPDX-License-Identifier: BSD-3-Clause
// Sheets of the J2 models on one core: built for the vortex at peak 0.1, two periods of the sine, then asked for 100
// amplitudes at 200 times each. `points` are nodes of the sheet, `update` calls of the material.
#include <benchmark/benchmark.h>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/sheet/sheet.hpp"

extern "C" const assay_material* assay_builtin_j2_jaumann(std::uint32_t host_major, std::uint32_t index);
extern "C" const assay_material* assay_builtin_j2_multiplicative(std::uint32_t host_major, std::uint32_t index);

namespace {

using Entry = const assay_material* (*)(std::uint32_t, std::uint32_t);
constexpr double end = 2;

void sheet(benchmark::State& state, Entry entry, double tolerance, double kinematic_modulus) {
  const assay::Material material(entry(ASSAY_ABI_MAJOR, 0), {{"E", 1e3},
                                                             {"nu", 0.3},
                                                             {"yield_stress", 140},
                                                             {"hardening_modulus", 200},
                                                             {"saturation_stress", 40},
                                                             {"saturation_rate", 10},
                                                             {"kinematic_modulus", kinematic_modulus}});
  const assay::Vortex vortex{0.75, 1.25, 2, {assay::Amplitude::Type::sine, 0.1, 1.0}};
  const assay::Path path = vortex.baseline();
  for (auto _ : state) {
    const assay::Sheet sheet(material, path, {.tolerance = tolerance, .end = end});
    assay::Tensor tau, dtau_dxi;
    for (int j = 1; j <= 200; ++j) {
      const assay::Isochrone isochrone = sheet.isochrone(end * j / 200);
      for (int i = 0; i < 100; ++i) isochrone.at(path.parameter.lower + path.parameter.width() * i / 99, tau, dtau_dxi);
    }
    benchmark::DoNotOptimize(dtau_dxi);
    state.counters["points"] = static_cast<double>(sheet.points());
    state.counters["update"] = static_cast<double>(sheet.material_calls());
    state.counters["error_tau"] = sheet.error_tau();
    state.counters["error_dtau"] = sheet.error_dtau();
  }
}
BENCHMARK_CAPTURE(sheet, j2_jaumann_to_1e_6, assay_builtin_j2_jaumann, 1e-6, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheet, j2_multiplicative_to_1e_6, assay_builtin_j2_multiplicative, 1e-6, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheet, j2_multiplicative_back_stress_to_1e_6, assay_builtin_j2_multiplicative, 1e-6, 50)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheet, j2_jaumann_to_1e_8, assay_builtin_j2_jaumann, 1e-8, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheet, j2_multiplicative_to_1e_8, assay_builtin_j2_multiplicative, 1e-8, 0)
    ->Unit(benchmark::kMillisecond);

}  // namespace
