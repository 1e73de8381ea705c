// SPDX-License-Identifier: BSD-3-Clause
// The program: what must be put right before any verb, then the command line.
#include <malloc.h>
#include <pthread.h>
#include <unistd.h>

#include <cstdlib>

#include "adapters/library.hpp"
#include "adapters/process/shortage.hpp"
#include "drivers/command_line/command_line.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/supervisor.hpp"
#include "harness/material/thrown.hpp"

// These stand before libc's for every library that is loaded: _exit() runs no handler, and a model that calls it must
// not end a run as if it had succeeded.
extern "C" [[gnu::visibility("default")]] void _exit(int status) { assay::drivers::leave_process_guarded(status); }
extern "C" [[gnu::visibility("default")]] void _Exit(int status) noexcept {
  assay::drivers::leave_process_guarded(status);
}

// A model that ends the thread which calls it would be taken for an exception of nobody's.
extern "C" [[gnu::visibility("default")]] void pthread_exit(void* value) {
  assay::drivers::leave_thread_guarded();
  using Exit = void (*)(void*);
  reinterpret_cast<Exit>(assay::adapters::next_function("pthread_exit"))(value);
  ::abort();  // it does not come back
}

namespace {

/// A run takes and gives back the same blocks at each step. Where libc returns them to the system each time, fresh
/// pages cost more than the work on them.
void keep_freed_memory() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that it takes
  ::mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  assay::on_end_of_thread = assay::drivers::leave_thread_guarded;
  assay::drivers::keep_standard_streams();  // the caller may have closed them
  assay::drivers::settle_library_path(argv);
  keep_freed_memory();
  assay::adapters::enlarge_stack(std::size_t{1} << 23);
  assay::adapters::leave_time_for_words();
  assay::drivers::allow_supervision();
  const int status = assay::drivers::command_line(argc, argv);
  assay::drivers::results_are_whole(status);
  assay::drivers::release_instances();
  return status;  // by exit(): run-time libraries of Fortran, MPI and OpenMP close what they have open
}
