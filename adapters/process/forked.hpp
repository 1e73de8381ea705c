// SPDX-License-Identifier: BSD-3-Clause
// A function in a copy of this process, for code that may crash, end the process, hang, or start others.
#pragma once

#include <functional>
#include <string>

namespace assay::adapters {

struct Forked {
  enum class End {
    done,
    signal,
    quit,
    hangs,
    lost,  ///< it ended, or stopped, the process that watches it
  } end = End::done;
  int signal = 0;         ///< that it died of
  bool returned = false;  ///< the function had come back; where not done, it is what followed that ended the copy
  std::string text;       ///< what the function returned, or what() of what it threw
};

struct ForkedHow {
  std::function<void()> after = {};  ///< what the copy runs when the function has come back
  double patience_s = 20;            ///< for both
  bool apart = false;                ///< in a group of its own, with a keeper that leaves signals for the end
};

/// Waits for it. The copy is a kept process (kept_process.hpp). Throws std::system_error where no process can be made.
Forked in_a_child(const std::function<std::string()>& body, const ForkedHow& how = {});

}  // namespace assay::adapters
