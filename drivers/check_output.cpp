// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_output.hpp"

#include <iostream>

#include "drivers/output/whole_file.hpp"

namespace assay::drivers {

void tell(const CheckOptions& options, const std::string& text, const std::string& json, const std::string& junit) {
  std::cout << (options.json == "-" ? json : options.junit == "-" ? junit : text) << std::flush;
  if (!options.json.empty() && options.json != "-") write_file(options.json, json);
  if (!options.junit.empty() && options.junit != "-") write_file(options.junit, junit);
}

}  // namespace assay::drivers
