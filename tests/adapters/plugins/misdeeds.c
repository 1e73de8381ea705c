/* SPDX-License-Identifier: BSD-3-Clause */
/* Does to its process what $ASSAY_TEST_DEED says, "WHEN DEED": when it is loaded, created, first or each time
 * updated, destroyed (each, or the first that was made), unloaded, or when the process exits. Honest otherwise. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <fenv.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <wchar.h>

#include "common.h"

static void sleep_for_long(void) {
  for (unsigned left = 300; left > 0;) left = sleep(left);
}

static void follow_null(void) {
  static double* volatile nowhere;
  *nowhere = 1;
}

static void leave_daemon(void) {
  if (fork() != 0) return;
  setsid();
  sleep_for_long();
  _exit(0);
}

static void leave_far_daemon(void) {
  const pid_t first = fork();
  if (first != 0) {
    waitpid(first, NULL, 0);
    return;
  }
  setsid();
  if (fork() == 0) {
    for (int file = 0; file < 1024; ++file) close(file);
    sleep_for_long();
  }
  _exit(0);
}

static void leave_child(void) {
  if (fork() != 0) return;
  sleep_for_long();
  _exit(0);
}

static void leave_buried(void) {
  if (fork() == 0) _exit(0);
  wait(NULL);
}

static void leave_quietly(void) { _exit(0); }
static void leave_by_exit(void) { exit(7); }
static void leave_quickly(void) { quick_exit(0); }
static void become_another(void) { execl("/bin/true", "true", (char*)NULL); }
static void wait_for_ever(void) {
  for (;;) pause();
}
static void wait_deaf(void) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, NULL);
  wait_for_ever();
}
static void kill_itself(void) { raise(SIGKILL); }
static void stop_itself(void) { raise(SIGSTOP); }
static void end_by_alarm(void) {
  alarm(1);
  pause();
}
static void stop_its_parent(void) { kill(getppid(), SIGSTOP); }
static void mute_terminal(void) {
  struct termios settings;
  const int file = open("/dev/tty", O_RDWR);
  if (file < 0 || tcgetattr(file, &settings) != 0) abort();
  settings.c_lflag &= ~(tcflag_t)ECHO;
  tcsetattr(file, TCSANOW, &settings);
  close(file);
}
static void leave_group(void) {
  setpgid(0, 0);
  usleep(2000);
}
static void terminate_itself(void) { raise(SIGTERM); }
static void interrupt_itself(void) { kill(getpid(), SIGINT); }
static void terminate_its_parent(void) { kill(getppid(), SIGTERM); }
static void hang_up_its_parent(void) { kill(getppid(), SIGHUP); }
static void double_itself(void) { fork(); }
static void end_its_thread(void) { pthread_exit(NULL); }
static void cancel_its_thread(void) {
  pthread_cancel(pthread_self());
  pthread_testcancel();
}
static void hurry_output(void) { fcntl(1, F_SETFL, fcntl(1, F_GETFL) | O_NONBLOCK); }
static void forbid_files(void) { umask(0777); }
static void close_streams(void) {
  for (int file = 0; file < 3; ++file) close(file);
}
static void close_all(void) {
  for (int file = 0; file < 1024; ++file) close(file);
}
static void leak_files(void) {
  while (open("/dev/null", O_RDONLY) >= 0) continue;
}
static void read_input(void) {
  char text[16];
  while (read(STDIN_FILENO, text, sizeof text) > 0) continue;
}

/* The beginning of all memory that it shares with other processes. */
static void zero_shared(void) {
  char line[512];
  FILE* maps = fopen("/proc/self/maps", "r");
  while (maps && fgets(line, sizeof line, maps)) {
    unsigned long begin, end;
    char rights[8];
    if (sscanf(line, "%lx-%lx %7s", &begin, &end, rights) != 3 || strcmp(rights, "rw-s") != 0) continue;
    memset((void*)begin, 0, end - begin < 16384 ? end - begin : 16384);
  }
  if (maps) fclose(maps);
}
static void nap(void) { usleep(1000); }
static void write_late(void) {
  FILE* file = fopen(getenv("ASSAY_TEST_FILE"), "w");
  if (file) fputs("late", file); /* flushed when the process exits */
}

static void litter(void) {
  FILE* file = fopen("data.csv", "w"); /* where it stands */
  if (file) fclose(file);
}
static void litter_and_die(void) {
  litter();
  abort();
}
static void leave_folder(void) {
  if (chdir("/") != 0) abort();
}
static void ignore_children(void) { signal(SIGCHLD, SIG_IGN); }
static void ignore_all(void) {
  for (int number = 1; number < 32; ++number) signal(number, SIG_IGN);
}
static void round_upward(void) { fesetround(FE_UPWARD); }
static void round_downward(void) { fesetround(FE_DOWNWARD); }
static void lower(int resource, rlim_t to, int hard) {
  struct rlimit limit;
  getrlimit(resource, &limit);
  limit.rlim_cur = to;
  if (hard) limit.rlim_max = to;
  setrlimit(resource, &limit);
}
static void allow_few_files(void) { lower(RLIMIT_NOFILE, 3, 0); }
static void allow_small_files(void) { lower(RLIMIT_FSIZE, 100, 0); }
static void allow_small_files_ever(void) { lower(RLIMIT_FSIZE, 400, 1); }
static void allow_little_memory_ever(void) { lower(RLIMIT_AS, 1000000, 1); }
static void steal_output(void) {
  if (!freopen(getenv("ASSAY_TEST_FILE"), "w", stdout)) abort();
}
static void print_wide(void) { wprintf(L"hello\n"); }
static void steal_all_output(void) {
  const int file = open(getenv("ASSAY_TEST_FILE"), O_WRONLY | O_CREAT, 0600);
  dup2(file, 1);
  dup2(file, 2);
  close(file);
}

/* Where that file is this library, the code that comes next is gone. */
static void truncate_library(void) {
  if (truncate(getenv("ASSAY_TEST_FILE"), 0) != 0) abort();
}

static void act(const char* when) {
  static const struct {
    const char* name;
    void (*act)(void);
  } deeds[] = {{"abort", abort},
               {"null", follow_null},
               {"pause", wait_for_ever},
               {"deaf", wait_deaf},
               {"_exit", leave_quietly},
               {"exit", leave_by_exit},
               {"quick_exit", leave_quickly},
               {"exec", become_another},
               {"kill", kill_itself},
               {"stop", stop_itself},
               {"alarm", end_by_alarm},
               {"stop_parent", stop_its_parent},
               {"mute_terminal", mute_terminal},
               {"leave_group", leave_group},
               {"terminate", terminate_itself},
               {"interrupt", interrupt_itself},
               {"terminate_parent", terminate_its_parent},
               {"hang_up_parent", hang_up_its_parent},
               {"fork", double_itself},
               {"daemon", leave_daemon},
               {"far_daemon", leave_far_daemon},
               {"child", leave_child},
               {"buried", leave_buried},
               {"thread_exit", end_its_thread},
               {"thread_cancel", cancel_its_thread},
               {"hurry_output", hurry_output},
               {"umask", forbid_files},
               {"close", close_streams},
               {"close_all", close_all},
               {"leak", leak_files},
               {"read", read_input},
               {"zero", zero_shared},
               {"nap", nap},
               {"write", write_late},
               {"litter", litter},
               {"litter_and_die", litter_and_die},
               {"chdir", leave_folder},
               {"ignore_children", ignore_children},
               {"ignore_all", ignore_all},
               {"round", round_upward},
               {"round_down", round_downward},
               {"few_files", allow_few_files},
               {"small_files", allow_small_files},
               {"small_files_ever", allow_small_files_ever},
               {"little_memory_ever", allow_little_memory_ever},
               {"steal", steal_output},
               {"steal_all", steal_all_output},
               {"wide", print_wide},
               {"truncate", truncate_library}};
  const char* asked = getenv("ASSAY_TEST_DEED");
  const size_t length = strlen(when);
  if (!asked || strncmp(asked, when, length) != 0 || asked[length] != ' ') return;
  for (size_t k = 0; k < sizeof deeds / sizeof *deeds; ++k) {
    if (strcmp(deeds[k].name, asked + length + 1) == 0) deeds[k].act();
  }
}

static void at_exit(void) { act("exit"); }

__attribute__((constructor)) static void load(void) { act("load"); }
__attribute__((destructor)) static void unload(void) { act("unload"); }

static void* create_and_act(const double* p, char* message) {
  static int registered = 0;
  if (!registered) registered = atexit(at_exit) == 0;
  act("create");
  (void)message;
  static int made = 0;
  double* self = malloc(2 * sizeof *self);
  if (self) self[0] = p[0], self[1] = made++ == 0;
  return self;
}

static void destroy_and_act(void* self) {
  act("destroy");
  if (((double*)self)[1] != 0) act("destroy_first");
  free(self);
}

static void update_and_act(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                           double* cauchy, int32_t* status, double* dt_factor, char* message) {
  static int calls = 0;
  if (calls++ == 0) act("update");
  act("each");
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("misdeeds");
  table.create = create_and_act;
  table.destroy = destroy_and_act;
  table.update = update_and_act;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
