// SPDX-License-Identifier: BSD-3-Clause
// The command line: from arguments to a verb, and from whatever happens to an exit status.
#pragma once

namespace assay::drivers {

/// Runs the verb. 0 all that was expected holds, 1 a finding contradicts, 2 bad input or usage, 3 the system. Errors
/// are one line on standard error. Throws nothing.
int command_line(int argc, const char* const* argv) noexcept;

/// The program as a worker of itself: `assay worker`, started by other verbs.
bool is_worker(int argc, const char* const* argv);

/// The whole life of one. Returns the exit status.
int worker(const char* build_of_host) noexcept;

}  // namespace assay::drivers
