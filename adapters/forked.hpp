// SPDX-License-Identifier: BSD-3-Clause
// A function in a copy of this process, for code that may crash, end the process or hang.
#pragma once

#include <functional>
#include <string>

namespace assay::adapters {

struct Forked {
  enum class End { done, signal, quit, hangs } end = End::done;
  int signal = 0;    ///< that it died of
  std::string text;  ///< what the function returned, or what() of what it threw
};

/// Waits for it, 20 s at most. Throws std::system_error where no process can be made.
Forked in_a_child(const std::function<std::string()>& body);

}  // namespace assay::adapters
