// SPDX-License-Identifier: BSD-3-Clause
// The program as a worker of itself: `assay worker`, started by other verbs.
#pragma once

namespace assay::drivers {

/// Whether the command line asks for that.
bool is_worker(int argc, const char* const* argv);

/// The whole life of one. Returns the exit status.
int worker() noexcept;

}  // namespace assay::drivers
