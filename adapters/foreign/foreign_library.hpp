// SPDX-License-Identifier: BSD-3-Clause
// A foreign library in this process, with what it expects of its host: routines that nobody provides, and routines that
// end the analysis (XIT). Here the latter ends the call of the model alone: the point has failed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace assay::adapters {

struct LoadedLibrary {
  void* handle = nullptr;
  std::vector<std::string> missing;  ///< routines that nobody provides: a call of one ends the call of the model
};

/// Loads it, RTLD_LOCAL; the host's utility routines first (SINV, ROTSIG, XIT, ...), for libraries that ask for them.
/// folder: what GETOUTDIR answers; empty: that of the library. Throws LibraryError.
LoadedLibrary load_foreign_library(const std::string& path, const std::string& folder = {});

/// "calls trust_ and utol_, which nobody provides"; empty where nothing is missing.
std::string missing_words(const std::vector<std::string>& missing);

/// Runs `body`; how the model ended the analysis in it, as "called XIT", nothing where it came back.
std::optional<std::string> ended_in(const std::function<void()>& body);

/// What the host's routines call: back to where `ended_in` was called, or, outside of it, to `on_model_end`.
void leave_model(const char* what);

/// What happens where a model ends the analysis outside of a call: must not return. Null: a line on standard error, and
/// the process ends.
inline void (*on_model_end)(const char* what) = nullptr;

}  // namespace assay::adapters
