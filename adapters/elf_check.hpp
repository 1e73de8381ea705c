// SPDX-License-Identifier: BSD-3-Clause
// A look at a file before the dynamic loader maps it.
#pragma once

#include <string>

namespace assay::adapters {

/// Throws LibraryError where the file is missing, a folder, unreadable, no ELF file, or shorter than its headers say
/// (the loader would map what is not there and die of SIGBUS).
void check_shared_library(const std::string& path);

}  // namespace assay::adapters
