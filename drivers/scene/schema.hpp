// SPDX-License-Identifier: BSD-3-Clause
// `assay schema`: scenes as JSON Schema (draft 2020-12), made from the reader's table of keys.
#pragma once

#include <string>

namespace assay::drivers {

/// Indented JSON with a newline at the end.
std::string schema_json();

}  // namespace assay::drivers
