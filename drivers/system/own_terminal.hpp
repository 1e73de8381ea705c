// SPDX-License-Identifier: BSD-3-Clause
// The settings of the user's terminal, which outlive the program.
#pragma once

#include <termios.h>

namespace assay::drivers {

/// How it was when this was made. Where this process is not the one in front, or has no terminal, nothing is done.
class OwnTerminal {
 public:
  OwnTerminal();
  OwnTerminal(const OwnTerminal&) = delete;
  OwnTerminal& operator=(const OwnTerminal&) = delete;
  ~OwnTerminal();

  /// Puts it right; whether something was changed.
  bool put_right() const;

 private:
  int file_;
  termios before_ = {};  ///< above what fills it in
  bool is_known_;
};

}  // namespace assay::drivers
