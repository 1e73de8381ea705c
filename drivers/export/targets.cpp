// SPDX-License-Identifier: BSD-3-Clause
// The codes and formats that export knows: the files of drivers/export/targets.
#include <algorithm>

#include "drivers/export/export.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

#define ASSAY_TARGET(NAME) Target target_##NAME();
#include "targets.inc"
#undef ASSAY_TARGET

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
#define ASSAY_TARGET(NAME) target_##NAME(),
#include "targets.inc"
#undef ASSAY_TARGET
  };
  return all;
}

const Target& target_of(const std::string& name) {
  const auto found = std::ranges::find_if(targets(), [&](const Target& each) { return name == each.name; });
  if (found != targets().end()) return *found;
  std::vector<std::string> names;
  for (const Target& each : targets()) names.emplace_back(each.name);
  throw InputError({}, "--to", unknown("target '" + one_line(name, 60) + "'", name, names), joined(names));
}

}  // namespace assay::drivers
