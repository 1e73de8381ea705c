// SPDX-License-Identifier: BSD-3-Clause
// The Python of this machine that has a module: Debian's has Debian's packages, whatever else is called python3.
#pragma once

#include <cstdlib>
#include <string>

namespace assay {

/// Empty where none has it.
inline std::string python_with(const std::string& module) {
  for (const std::string one : {"/usr/bin/python3", "python3"}) {
    if (std::system((one + " -c 'import " + module + "' > /dev/null 2>&1").c_str()) == 0) return one;
  }
  return {};
}

}  // namespace assay
