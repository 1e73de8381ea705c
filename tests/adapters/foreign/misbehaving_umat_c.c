/* SPDX-License-Identifier: BSD-3-Clause */
/* Misbehaviours of misbehaving_umat.f90, by number; those marked Fortran are done there. */
#define _GNU_SOURCE
#include <fenv.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

enum {
  nothing = 0, /* Fortran */
  segmentation_fault = 1,
  stop_with_status_0 = 2, /* Fortran */
  endless_loop = 3,
  abort_itself = 4,
  stack_overflow = 5,
  touches_10_gb = 6,
  closes_output = 7,
  changes_folder = 8,
  traps_division = 9,
  rounds_upward = 10,
  overruns_statev = 11,  /* by 20 */
  floods_output = 12,    /* 100 MB */
  asks_for_shorter = 13, /* Fortran */
  calls_xit = 14,        /* Fortran */
  returns_nan = 15,      /* Fortran */
  exits_with_status_0 = 16,
  leaves_grandchild = 17,
  writes_files = 18, /* Fortran: units 6 and 7, scratch.dat */
  kills_itself = 19,
  forgets = 20, /* Fortran: while the time is below 1e-6 */
  keeps_10_gb = 21,
  ignores_signals = 22, /* and sleeps 1000 s */
  closes_everything = 23,
  underruns_stress = 24, /* by 4000 */
  writes_strain = 25,    /* Fortran: to STRAN, which is the host's */
  asserts_numbers = 26,  /* aborts where the stress is no number */
  leaves_daemon = 27,    /* that has left its parents and their group */
  kills_its_watcher = 28,
  takes_its_time = 30, /* 10 ms a call */
  blocks_termination = 31,
  ignores_hangup = 32,
  flushes_to_zero = 33,
  rounds_doubles_to_zero = 34, /* by the SSE unit alone */
  shortens_long_doubles = 35,
  random_digit = 36,
  digit_of_the_clock = 37
};

static const size_t ten_gb = (size_t)10 << 30, page = 4096;
static const double litter = -7.25e11;

static double descend(volatile const double* above) {
  volatile double frame[512];
  frame[0] = *above + 1;
  return frame[0] < 0 ? 0 : descend(frame) + frame[0];
}

static long clock_of_ns(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_nsec >> 7;
}

static void take_time(void) { usleep(10000); }

static void touch_10_gb(void) {
  volatile char* block = malloc(ten_gb); /* unchecked, as is usual */
  for (size_t i = 0; i < ten_gb; i += page) block[i] = 1;
  free((void*)block);
}

static void divide_by_zero(void) {
  volatile double zero = 0, quotient;
  feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
  quotient = 1 / zero;
  (void)quotient;
}

static void flood_output(void) {
  char line[1000];
  memset(line, '#', sizeof line);
  line[sizeof line - 1] = '\n';
  for (int i = 0; i < 100000; ++i) fwrite(line, 1, sizeof line, stdout);
  fflush(stdout);
}

static void sleep_1000_s(void) {
  for (unsigned left = 1000; left > 0;) left = sleep(left);
}

static void leave_grandchild(void) {
  if (fork() != 0) return;
  sleep_1000_s();
  _exit(0);
}

static void leave_daemon(void) {
  const pid_t first = fork();
  if (first != 0) {
    waitpid(first, NULL, 0);
    return;
  }
  setsid();
  if (fork() == 0) sleep_1000_s();
  _exit(0);
}

static void kill_its_watcher(void) {
  kill(getppid(), SIGKILL);
  sleep_1000_s();
}

static void ignore_signals(void) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, NULL);
  for (int s = 1; s < NSIG; ++s) signal(s, SIG_IGN);
}

static void write_to_null(void) {
  static double* volatile nowhere;
  *nowhere = 1;
}

static void loop(void) {
  for (volatile unsigned i = 0;; ++i) continue;
}

static void overflow_stack(void) {
  volatile double top = 0;
  top = descend(&top);
}

static void keep_10_gb(void) {
  static void* volatile kept;
  if (!kept) kept = malloc(ten_gb);
}

static void close_descriptors(int first, int last) {
  for (int fd = first; fd <= last; ++fd) close(fd);
}

static void close_output(void) { close_descriptors(1, 2); }
static void close_everything(void) { close_descriptors(0, 99); }

static void change_folder(void) {
  if (chdir("/") != 0) abort();
}

static void block_termination(void) {
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, SIGTERM);
  sigprocmask(SIG_BLOCK, &one, NULL);
}

static void ignore_hangup(void) { signal(SIGHUP, SIG_IGN); }

#if defined(__x86_64__)
static void flush_to_zero(void) { _mm_setcsr(_mm_getcsr() | 0x8040); }
static void round_doubles_to_zero(void) { _mm_setcsr(_mm_getcsr() | 0x6000); }
static void shorten_long_doubles(void) {
  const unsigned short word = 0x027f;
  __asm__ volatile("fldcw %0" : : "m"(word));
}
#endif

static void round_upward(void) { fesetround(FE_UPWARD); }
static void leave_quietly(void) { _exit(0); }
static void kill_itself(void) { raise(SIGKILL); }

static void ignore_signals_and_sleep(void) {
  ignore_signals();
  sleep_1000_s();
}

/* Repeated, these would bring down more than the process. */
static int once_is_enough(int which) {
  return which == floods_output || which == leaves_grandchild || which == leaves_daemon;
}

__attribute__((visibility("hidden"))) void misbehave(int which, double* stress, double* statev, int nstatv);

void misbehave(int which, double* stress, double* statev, int nstatv) {
  static void (*const deeds[])(void) = {
    [segmentation_fault] = write_to_null,
    [endless_loop] = loop,
    [abort_itself] = abort,
    [stack_overflow] = overflow_stack,
    [touches_10_gb] = touch_10_gb,
    [closes_output] = close_output,
    [changes_folder] = change_folder,
    [traps_division] = divide_by_zero,
    [rounds_upward] = round_upward,
    [floods_output] = flood_output,
    [exits_with_status_0] = leave_quietly,
    [leaves_grandchild] = leave_grandchild,
    [kills_itself] = kill_itself,
    [keeps_10_gb] = keep_10_gb,
    [ignores_signals] = ignore_signals_and_sleep,
    [closes_everything] = close_everything,
    [leaves_daemon] = leave_daemon,
    [kills_its_watcher] = kill_its_watcher,
    [takes_its_time] = take_time,
    [blocks_termination] = block_termination,
    [ignores_hangup] = ignore_hangup,
#if defined(__x86_64__)
    [flushes_to_zero] = flush_to_zero,
    [rounds_doubles_to_zero] = round_doubles_to_zero,
    [shortens_long_doubles] = shorten_long_doubles,
#endif
  };
  const int count = (int)(sizeof deeds / sizeof *deeds);
  static int calls = 0;
  if (which == overruns_statev) {
    for (int i = 0; i < 20; ++i) statev[nstatv + i] = litter;
  } else if (which == underruns_stress) {
    for (int i = 1; i <= 4000; ++i) ((volatile double*)stress)[-i] = litter;
  } else if (which == random_digit) {
    stress[0] *= 1 + 1e-15 * (rand() % 4);
  } else if (which == digit_of_the_clock) {
    stress[0] *= 1 + 1e-15 * (double)(clock_of_ns() % 2);
  } else if (which == asserts_numbers) {
    if (stress[0] != stress[0]) abort();
  } else if (which > 0 && which < count && deeds[which] && !(once_is_enough(which) && calls++ > 0)) {
    deeds[which]();
  }
}
