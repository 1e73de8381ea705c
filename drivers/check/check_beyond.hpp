// SPDX-License-Identifier: BSD-3-Clause
// What a UMAT or VUMAT reads or writes beyond the arrays that it is handed: the same steps with other words around
// them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/written_inputs.hpp"
#include "drivers/material/material_choice.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

inline constexpr const char* beyond_test = "calls.beyond";

/// What a look has found: each place once.
struct Beyonds {
  std::vector<adapters::GuardedArrays::Beyond> read, written;
  std::vector<std::ptrdiff_t> left_at_times = {};  ///< of stateNew: written in some steps, and not in others
};

/// For a process that has not called the model yet, which is called in others alone. Nothing for an interface that
/// tells how much it hands over.
struct BeyondFinding {
  check::TestResult test;
  std::vector<check::Diagnosis> causes;  ///< empty where it passes
};
std::optional<BeyondFinding> goes_beyond(const ResolvedMaterial& material, const check::Effort& effort);

/// In the words of descriptions.
BeyondFinding judged_beyond(const Beyonds& found);

/// "1:7", "1:4, 7": indices in order.
std::string ranges_of(const std::vector<std::ptrdiff_t>& indices);

}  // namespace assay::drivers
