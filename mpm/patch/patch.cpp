// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/patch/patch.hpp"

#include <algorithm>

#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::mpm {

bool MethodReport::passes() const {
  return std::none_of(tests.begin(), tests.end(),
                      [](const auto& test) { return test.verdict == check::Verdict::fail; });
}

MethodReport run_patch_tests(const Method& method, const Bench& bench) {
  MethodReport report{method, {}};
  for (const auto group : {completeness, translation, rotation, constant_stress, surface, momentum}) {
    for (check::TestResult& result : group(method, bench)) report.tests.push_back(std::move(result));
  }
  return report;
}

Bench bench_of(std::shared_ptr<const Material> material, bool quick) {
  Bench bench{.material = std::move(material), .quick = quick};
  bench.wave_speed = fastest_wave_on_path(*bench.material, Homogeneous{}.baseline(), bench.density, 0);
  return bench;
}

}  // namespace assay::mpm
