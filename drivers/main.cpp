// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cstdlib>

#include "drivers/command_line.hpp"
#include "drivers/exit_guard.hpp"

// These stand before libc's for every library that is loaded: _exit() runs no handler, and a model that calls it must
// not end a run as if it had succeeded.
extern "C" [[gnu::visibility("default")]] void _exit(int status) { assay::drivers::leave_process_guarded(status); }
extern "C" [[gnu::visibility("default")]] void _Exit(int status) noexcept {
  assay::drivers::leave_process_guarded(status);
}

int main(int argc, char** argv) { return assay::drivers::command_line(argc, argv); }
