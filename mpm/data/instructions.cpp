// SPDX-License-Identifier: BSD-3-Clause
// Which instructions this processor has.
#include "mpm/data/instructions.hpp"

#include <stdexcept>

namespace assay::mpm {

std::string_view name(Instructions instructions) {
  return instructions == Instructions::v4 ? "x86-64-v4" : instructions == Instructions::v3 ? "x86-64-v3" : "baseline";
}

[[maybe_unused]] static bool has_v3() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
}

[[maybe_unused]] static bool has_v4() {
  return has_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

std::vector<Instructions> usable_instructions() {
  std::vector<Instructions> usable;
#ifdef ASSAY_KERNELS_BASELINE
  usable.push_back(Instructions::baseline);
#endif
#ifdef ASSAY_KERNELS_V3
  if (has_v3()) usable.push_back(Instructions::v3);
#endif
#ifdef ASSAY_KERNELS_V4
  if (has_v4()) usable.push_back(Instructions::v4);
#endif
  return usable;
}

Instructions best_instructions() {
  static const std::vector<Instructions> usable = usable_instructions();
  if (usable.empty()) {
    throw std::runtime_error("this program was built for another processor (ASSAY_KERNELS=native): build it here");
  }
  return usable.back();
}

}  // namespace assay::mpm
