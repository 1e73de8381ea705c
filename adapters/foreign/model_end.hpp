// SPDX-License-Identifier: BSD-3-Clause
// Models end the analysis by routines of their host (XIT). Here such a call ends the call of the model alone: the point
// has failed.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace assay::adapters {

/// Runs `body`; how the model ended the analysis in it, as "called XIT", nothing where it came back.
std::optional<std::string> ended_in(const std::function<void()>& body);

/// What the host's routines call: back to where `ended_in` was called, or, outside of it, to `on_model_end`.
void leave_model(const char* what);

/// What happens where a model ends the analysis outside of a call: must not return. Null: a line on standard error, and
/// the process ends.
inline void (*on_model_end)(const char* what) = nullptr;

}  // namespace assay::adapters
