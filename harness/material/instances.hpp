// SPDX-License-Identifier: BSD-3-Clause
// How the instances of models go.
#pragma once

#include <atomic>

#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay {

/// Whoever takes instances over in place of their destruction, each with the model's function that destroys it; null:
/// nobody.
inline std::atomic<void (*)(void (*destroy)(void*), void* self)> takes_instances_over{nullptr};

inline void destroy_marked(void (*destroy)(void*), void* self) {
  const CallMark call;
  const PhaseMark phase(CallPhase::destroying);
  destroy(self);
  end_a_copy();
  put_arithmetic_right();
}

}  // namespace assay
