// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace assay::mpm {

/// Sets of instructions that kernels are compiled for: what every x86-64 has, with AVX2, with AVX-512.
enum class Instructions { baseline, v3, v4 };

/// Those of this build that this processor has, the best one last.
std::vector<Instructions> usable_instructions();
Instructions best_instructions();
std::string_view name(Instructions instructions);

}  // namespace assay::mpm
