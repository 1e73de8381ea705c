// SPDX-License-Identifier: BSD-3-Clause
// Which instructions this processor has.
#include "mpm/data/instructions.hpp"

namespace assay::mpm {

std::string_view name(Instructions instructions) {
  return instructions == Instructions::v4 ? "x86-64-v4" : instructions == Instructions::v3 ? "x86-64-v3" : "baseline";
}

std::vector<Instructions> usable_instructions() {
  std::vector<Instructions> usable{Instructions::baseline};
#ifdef ASSAY_DISPATCHES
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                  __builtin_cpu_supports("bmi2");
  if (v3) usable.push_back(Instructions::v3);
  if (v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    usable.push_back(Instructions::v4);
  }
#endif
  return usable;
}

Instructions best_instructions() {
  static const Instructions best = usable_instructions().back();
  return best;
}

}  // namespace assay::mpm
