// SPDX-License-Identifier: BSD-3-Clause
// Routines that a library calls and nobody provides.
#pragma once

#include <string>
#include <vector>

namespace assay::adapters {

/// Of a library that is loaded, lazily bound: symbols that neither it nor anybody it was loaded with defines.
std::vector<std::string> missing_symbols(void* library, const std::string& path);

/// From now on a call of one of them ends the call of the model, as leave_model, with its name; the loader would end
/// the process.
void stand_in_for(const std::vector<std::string>& missing, void* library);

/// "calls trust_ and utol_, which nobody provides"; empty where nothing is missing.
std::string missing_words(const std::vector<std::string>& missing);

}  // namespace assay::adapters
