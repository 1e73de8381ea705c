/* SPDX-License-Identifier: BSD-3-Clause */
/* Answers, and hangs up the terminal in its first update: a process of its own does, as a user would. */
#define _POSIX_C_SOURCE 200809L
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common.h"

static void hang_up_from_outside(void) {
  const pid_t child = fork();
  if (child == 0) {
    kill(getppid(), SIGHUP);
    _exit(0);
  }
  waitpid(child, NULL, 0);
}

static void hang_up(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
                    int32_t* status, double* dt_factor, char* message) {
  static int done;
  if (!done) hang_up_from_outside();
  done = 1;
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("interrupts");
  table.update = hang_up;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
