// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/own_terminal.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>

namespace assay::drivers {

namespace {

bool alike(const termios& a, const termios& b) {
  return a.c_iflag == b.c_iflag && a.c_oflag == b.c_oflag && a.c_cflag == b.c_cflag && a.c_lflag == b.c_lflag &&
         std::equal(std::begin(a.c_cc), std::end(a.c_cc), std::begin(b.c_cc));
}

}  // namespace

OwnTerminal::OwnTerminal()
    : file_(::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)),
      is_known_(file_ >= 0 && ::tcgetpgrp(file_) == ::getpgrp() && ::tcgetattr(file_, &before_) == 0) {}

OwnTerminal::~OwnTerminal() {
  if (file_ >= 0) ::close(file_);
}

bool OwnTerminal::put_right() const {
  termios now = {};
  if (!is_known_ || ::tcgetattr(file_, &now) != 0 || alike(now, before_)) return false;
  sigset_t of_writers, blocked;  // who is no longer in front would be stopped
  ::sigemptyset(&of_writers);
  ::sigaddset(&of_writers, SIGTTOU);
  ::sigprocmask(SIG_BLOCK, &of_writers, &blocked);
  ::tcsetattr(file_, TCSANOW, &before_);
  ::sigprocmask(SIG_SETMASK, &blocked, nullptr);
  return true;
}

}  // namespace assay::drivers
