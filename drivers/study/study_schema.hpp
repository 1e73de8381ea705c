// SPDX-License-Identifier: BSD-3-Clause
// `assay schema --study`: studies as JSON Schema (draft 2020-12), made from what their reader knows.
#pragma once

#include <string>

namespace assay::drivers {

/// Indented JSON with a newline at the end.
std::string study_schema_json();

}  // namespace assay::drivers
