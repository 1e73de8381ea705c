// SPDX-License-Identifier: BSD-3-Clause
// Whether a file of a result is whole and holds no number that is not finite.
#pragma once

#include <string>

namespace assay::fuzz {

/// What is wrong with it, by its name: a table, JSON, VTU, PNG, a page, a scene; empty where nothing is. A name that no
/// result has is wrong, too.
std::string file_fault(const std::string& file);

}  // namespace assay::fuzz
