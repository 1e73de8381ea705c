// SPDX-License-Identifier: BSD-3-Clause
// What the results of a run follow from beside its files: the code that computes them.
#pragma once

#include <string>

namespace assay::drivers {

/// Of the program, or of the library that this code is in: the build id that its linker wrote, a hash of all it holds;
/// SHA-256 of the file where there is none.
/// Throws InputError where that cannot be read.
const std::string& program_identity();

/// SHA-256 over the identities of the program and of the shared libraries that were loaded at the first call: 64
/// hexadecimal digits. Throws InputError where one of them cannot be read.
const std::string& loaded_identity();

}  // namespace assay::drivers
