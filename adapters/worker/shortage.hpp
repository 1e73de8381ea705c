// SPDX-License-Identifier: BSD-3-Clause
// What the system did not give a process of ours. No model is to blame for that.
#pragma once

#include <string>

namespace assay::adapters {

/// Of the limits of this process those that a model's process may not do with: "memory is limited to 8 MiB (ulimit
/// -d)". Empty where there are none.
std::string tight_limits();

/// From here on shortage() says this; the first word stands. From any thread.
void note_shortage(const std::string& words);

/// What was noted; empty: nothing.
std::string shortage();

}  // namespace assay::adapters
