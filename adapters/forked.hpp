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
  bool leaves = false;    ///< processes, which were ended
  std::string text;       ///< what the function returned, or what() of what it threw
};

/// Waits for it, `patience_ms` at most. The copy runs `body`, then `after`; another process watches it, and ends what
/// it has started. Both stand in a folder of their own (worker/own_folder.hpp). Throws std::system_error where no
/// process can be made.
Forked in_a_child(const std::function<std::string()>& body, const std::function<void()>& after = {},
                  int patience_ms = 20000);

}  // namespace assay::adapters
