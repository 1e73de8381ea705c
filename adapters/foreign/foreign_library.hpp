// SPDX-License-Identifier: BSD-3-Clause
// A foreign library in this process, with what it expects of its host.
#pragma once

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

/// The companion library with the host's utility routines: beside the program, or in ../lib/assay/abaqus of it. Empty
/// where it is not found.
std::string utilities_library();

}  // namespace assay::adapters
