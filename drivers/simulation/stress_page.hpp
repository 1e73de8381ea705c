// SPDX-License-Identifier: BSD-3-Clause
// What a run and one of its workers hand each other every step, in the memory for the arrays of a call.
#pragma once

#include <cstddef>
#include <cstdint>

#include "harness/assay_material.h"
#include "mpm/material/stress_blocks.hpp"

namespace assay::drivers {

struct StressPage {
  // once: where the columns begin in the shared memory, in doubles
  std::size_t deformation_gradient[4], velocity_gradient[4], stress[5], history[2], volume_scale[2];
  std::uint32_t scales_volume[2];  ///< 0 or 1: whether volume_scale is there
  std::uint32_t rate_of_F;         ///< 0 or 1, likewise once
  // every step
  double t, dt;
  std::size_t begin, end;  ///< particles
  // the answer
  std::size_t block;  ///< begin of the block that is, or was last, worked on
  enum class Found : std::uint32_t { nothing, inverted, refused } found;
  std::size_t particle;
  char message[ASSAY_MESSAGE_SIZE];
  alignas(64) double scratch[mpm::BlockScratch<2>::doubles];  ///< F0, F1 and stress of that block
};

}  // namespace assay::drivers
