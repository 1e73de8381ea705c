// SPDX-License-Identifier: BSD-3-Clause
// A part of a study for one of several machines.
#pragma once

#include <cstddef>

namespace assay::drivers {

/// Cases are dealt out in turn, so that the expensive resolutions are shared.
struct Shard {
  std::size_t index = 1, count = 1;  ///< this one, from 1, of so many
  bool holds(std::size_t case_number) const { return (case_number - 1) % count == index - 1; }
};

}  // namespace assay::drivers
