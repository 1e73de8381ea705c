// SPDX-License-Identifier: BSD-3-Clause
// What the system did not give a process of ours. No model is to blame for that.
#pragma once

#include <cstddef>
#include <string>

namespace assay::adapters {

/// Lets the stack of this process, and of threads that are made from now on, grow to so many bytes, as far as that is
/// allowed.
void enlarge_stack(std::size_t bytes);

/// Of the limits of this process those that a model's process may not do with: "memory is limited to 8 MiB (ulimit
/// -d)". Empty where there are none.
std::string tight_limits();

/// "processor time is limited to 10 s (ulimit -t)"; empty where it is not. Who uses it up dies of SIGXCPU, or is
/// killed.
std::string processor_limit();

/// Where SIGKILL would come with SIGXCPU, as `ulimit -t` has it: a second earlier, so that a line says what was short.
void leave_time_for_words();

/// From here on shortage() says this; the first word stands. From any thread.
void note_shortage(const std::string& words);

/// Notes that a worker was killed in a call that does not end one when it is made again.
void note_killed_worker();

/// What was noted; empty: nothing.
std::string shortage();

/// The same, which is forgotten: for a process that goes on.
std::string take_shortage();

}  // namespace assay::adapters
