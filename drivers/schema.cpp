// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/schema.hpp"

#include "drivers/output/terminal.hpp"
#include "drivers/study/study_schema.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

int schema(const SchemaOptions& options) {
  print(options.study ? study_schema_json() : schema_json());
  return 0;
}

}  // namespace assay::drivers
