// SPDX-License-Identifier: BSD-3-Clause
// How the instances of models go.
#pragma once

#include <atomic>

namespace assay {

/// Whoever takes instances over in place of their destruction, each with the model's function that destroys it; null:
/// nobody.
inline std::atomic<void (*)(void (*destroy)(void*), void* self)> takes_instances_over{nullptr};

}  // namespace assay
