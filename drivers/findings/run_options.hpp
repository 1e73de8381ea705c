// SPDX-License-Identifier: BSD-3-Clause
// What `assay run` is asked for.
#pragma once

#include <string>
#include <vector>

#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

struct RunOptions {
  std::string scene;
  std::string out;                ///< folder; never empty: results/SCENE by default
  std::vector<std::string> sets;  ///< "key.path=YAML value", in the order given
  int threads = 1;
  bool json = false;  ///< result.json on standard output
  Verbosity verbosity = Verbosity::normal;
  std::string junit = {};       ///< file; "-": standard output; empty: none
  std::string junit_name = {};  ///< of the suite in that file; empty: the scene's
};

}  // namespace assay::drivers
