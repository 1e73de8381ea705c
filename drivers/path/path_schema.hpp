// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace assay::drivers {

/// The JSON Schema (draft 2020-12) of paths, with a newline at the end.
std::string path_schema_json();

}  // namespace assay::drivers
