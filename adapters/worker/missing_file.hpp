// SPDX-License-Identifier: BSD-3-Clause
// A model that ends because it does not find a file: told from what it printed.
#pragma once

#include <string>

namespace assay::adapters {

/// A clause for a message, "; it looks for 'a.txt' in its process's own folder: ..."; empty where nothing that was
/// printed speaks of a file.
std::string missing_file_words(const std::string& printed);

}  // namespace assay::adapters
