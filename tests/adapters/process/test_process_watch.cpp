// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/process_watch.hpp"

#include "adapters/foreign/written_inputs.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <string>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "adapters/process/fate.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters::test_process_watch {
namespace {

struct Deed {
  const char* name;
  void (*done)();
  Habits habit;
};

void nothing() {}
void leave() { static_cast<void>(::chdir("/")); }
void close_output() { ::close(STDOUT_FILENO); }
void redirect_errors() { ::dup2(::open("/dev/full", O_WRONLY), STDERR_FILENO); }
void take_signal() {
  std::signal(SIGFPE, [](int) {});
}
void ignore_hangup() { std::signal(SIGHUP, SIG_IGN); }
void take_user_signal() {
  std::signal(SIGUSR1, [](int) {});
}
void change_flags_alone() {
  struct sigaction action = {};
  ::sigaction(SIGCHLD, nullptr, &action);
  action.sa_flags |= SA_NOCLDWAIT;
  ::sigaction(SIGCHLD, &action, nullptr);
}
void run_a_command() { static_cast<void>(std::system("true")); }  // which ignores two signals meanwhile
void take_and_restore_signal() {
  const auto before = std::signal(SIGUSR2, SIG_IGN);
  std::signal(SIGUSR2, before);
}
void take_and_restore_action() {
  struct sigaction own = {}, before = {};
  own.sa_handler = [](int) {};
  ::sigaction(SIGTERM, &own, &before);
  ::sigaction(SIGTERM, &before, nullptr);
}
void block(std::initializer_list<int> signals) {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : signals) sigaddset(&set, signal);
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
}
void block_termination() { block({SIGTERM}); }
void block_several() { block({SIGINT, SIGALRM, SIGCHLD}); }
void block_and_unblock() {
  block({SIGTERM});
  sigset_t none;
  sigemptyset(&none);
  ::pthread_sigmask(SIG_SETMASK, &none, nullptr);
}
#if defined(__x86_64__)
void flush() {
  _mm_setcsr(_mm_getcsr() | 0x8000);
  put_arithmetic_right();
}
void take_denormals_for_zero() {
  _mm_setcsr(_mm_getcsr() | 0x0040);
  put_arithmetic_right();
}
void compute_long_doubles_as_doubles() {
  const std::uint16_t word = 0x027f;
  __asm__ volatile("fldcw %0" : : "m"(word));
  put_arithmetic_right();
}
void leave_a_long_double() { __asm__ volatile("fld1"); }
void use_mmx() { __asm__ volatile("movd %%eax, %%mm0" : : : "mm0"); }
void use_mmx_and_empty() { __asm__ volatile("movd %%eax, %%mm0\n\temms" : : : "mm0"); }
#endif
void ignore_a_signal_of_real_time() { std::signal(SIGRTMIN + 3, SIG_IGN); }
void fork_one() {
  if (::fork() == 0) ::_exit(0);
}
void forbid_files() { ::umask(0777); }
void set_timer() { ::alarm(1000); }
void set_profiling_timer() {
  itimerval later = {};
  later.it_value.tv_sec = 1000;
  ::setitimer(ITIMER_PROF, &later, nullptr);
}
void limit_files() {
  rlimit size{1 << 20, RLIM_INFINITY};
  ::getrlimit(RLIMIT_FSIZE, &size);
  size.rlim_cur = 1 << 20;
  ::setrlimit(RLIMIT_FSIZE, &size);
}
void set_variable() { ::setenv("OMP_NUM_THREADS_OF_A_TEST", "1", 1); }
void stay_on_one_core() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(::sched_getcpu(), &cores);
  ::sched_setaffinity(0, sizeof cores, &cores);
}
void be_nice() { static_cast<void>(::nice(5)); }
void run_in_the_background() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_BATCH, &none);
}
void leave_group() { ::setpgid(0, 0); }
void begin_session() { ::setsid(); }
void open_files(int count) {
  for (int k = 0; k < count; ++k) static_cast<void>(::open("/dev/null", O_RDONLY));
}
void open_a_few() { open_files(4); }
void open_many() { open_files(40); }
void take_all_files() {
  while (::open("/dev/null", O_RDONLY) >= 0) continue;
}
void leave_and_come_back() {
  char before[4096];
  if (::getcwd(before, sizeof before) && ::chdir("/") == 0) static_cast<void>(::chdir(before));
}

const Deed deeds[] = {{"nothing", nothing, no_habit},
                      {"changes_the_folder", leave, folder_changed},
                      {"comes_back", leave_and_come_back, no_habit},
                      {"closes_output", close_output, output_closed},
                      {"redirects_errors", redirect_errors, output_closed},
                      {"takes_a_signal", take_signal, signals_taken},
                      {"ignores_hangup", ignore_hangup, signals_taken},
                      {"takes_a_user_s_signal", take_user_signal, signals_taken},
                      {"runs_a_command", run_a_command, no_habit},
                      {"takes_a_signal_and_restores_it", take_and_restore_signal, no_habit},
                      {"takes_a_signal_and_restores_its_action", take_and_restore_action, no_habit},
                      {"changes_the_flags_of_a_signal", change_flags_alone, signals_taken},
                      {"ignores_a_signal_of_real_time", ignore_a_signal_of_real_time, signals_taken},
                      {"blocks_termination", block_termination, signals_blocked},
                      {"blocks_several", block_several, signals_blocked},
                      {"unblocks_again", block_and_unblock, no_habit},
#if defined(__x86_64__)
                      {"flushes_to_zero", flush, denormals_left_flushed},
                      {"takes_denormals_for_zero", take_denormals_for_zero, denormals_left_flushed},
                      {"changes_the_precision", compute_long_doubles_as_doubles, precision_left},
                      {"leaves_a_long_double", leave_a_long_double, x87_left},
                      {"uses_mmx_without_emms", use_mmx, x87_left},
                      {"uses_mmx_and_emms", use_mmx_and_empty, no_habit},
#endif
                      {"forbids_files", forbid_files, files_forbidden},
                      {"sets_a_timer", set_timer, timer_left},
                      {"sets_a_profiling_timer", set_profiling_timer, timer_left},
                      {"limits_files", limit_files, limits_changed},
                      {"sets_a_variable", set_variable, environment_changed},
                      {"stays_on_one_core", stay_on_one_core, scheduling_changed},
                      {"is_nice", be_nice, scheduling_changed},
                      {"runs_in_the_background", run_in_the_background, scheduling_changed},
                      {"leaves_its_group", leave_group, group_left},
                      {"begins_a_session", begin_session, group_left},
                      {"opens_a_few_files", open_a_few, no_habit},
                      {"opens_many_files", open_many, files_left},
                      {"takes_all_files", take_all_files, files_left},
                      {"leaves_a_process", fork_one, processes_left}};

class ProcessWatchDeed : public testing::TestWithParam<Deed> {};

/// Its keeper blocks all signals, as that of a check does.
TEST(ProcessWatch, SeesSignalsToAWatcherThatBlocksThem) {
  for (const int signal : {0, SIGTERM, SIGUSR1, SIGALRM}) {
    const pid_t keeper = ::fork();
    ASSERT_GE(keeper, 0);
    if (keeper == 0) {
      sigset_t all;
      ::sigfillset(&all);
      ::sigprocmask(SIG_SETMASK, &all, nullptr);
      const pid_t child = ::fork();
      if (child == 0) {
        const ProcessWatch watch;
        if (signal != 0) ::kill(::getppid(), signal);
        ::_exit(watch.habits() == (signal == 0 ? no_habit : watcher_signalled) ? 0 : 1);
      }
      int status = 0;
      ::waitpid(child, &status, 0);
      ::_exit(WEXITSTATUS(status));
    }
    int status = 0;
    ASSERT_EQ(::waitpid(keeper, &status, 0), keeper);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << signal;
  }
}

TEST_P(ProcessWatchDeed, IsSeenAndNoOther) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const ProcessWatch watch;
    GetParam().done();
    ::_exit(watch.habits() == GetParam().habit ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << habit_words(GetParam().habit);
  EXPECT_EQ(habit_words(GetParam().habit).empty(), GetParam().habit == no_habit);
}

INSTANTIATE_TEST_SUITE_P(All, ProcessWatchDeed, testing::ValuesIn(deeds),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ProcessWatch, SeesEverySignalInAFewLooks) {
  constexpr int looks = 16;
  for (const int signal : {SIGHUP, SIGPIPE, SIGUSR2, SIGRTMIN + 30}) {
    ProcessWatch watch;
    struct sigaction before = {};
    ::sigaction(signal, nullptr, &before);
    std::signal(signal, SIG_IGN);
    Habits found = no_habit;
    for (int k = 0; k < looks; ++k) found |= watch.habits_so_far();
    ::sigaction(signal, &before, nullptr);
    EXPECT_EQ(found, signals_taken) << signal;
  }
}

TEST(ProcessWatch, WordsOfSeveralHabitsAreAList) {
  EXPECT_EQ(habit_words(folder_changed | processes_left), "changes the folder of the process, leaves processes behind");
  EXPECT_EQ(habit_words(Habits{signals_taken} | written_stran | written_props),
            "takes over signals of the process, writes to its inputs (STRAN, PROPS)");
}

TEST(KeptOutput, KeepsBothEndsAndSaysHowMuchIsLeftOut) {
  const auto output = std::make_unique<KeptOutput>();
  EXPECT_EQ(output->text(), "");
  output->add("one\ntwo\n", 8);
  EXPECT_EQ(output->text(), "one\ntwo\n");
  EXPECT_EQ(last_line(output->text()), "two");
  const std::string flood(1000, '#');
  for (int k = 0; k < 1000; ++k) output->add(flood.data(), flood.size());
  output->add("the end\n", 8);
  const std::string text = output->text();
  EXPECT_LT(text.size(), 2 * KeptOutput::size + 100);
  EXPECT_TRUE(text.starts_with("one\ntwo\n###"));
  EXPECT_TRUE(text.ends_with("###the end\n"));
  const std::size_t left_out = 1000016 - 2 * KeptOutput::size;
  EXPECT_NE(text.find("\n[" + std::to_string(left_out) + " bytes are left out]\n"), std::string::npos);
}

}  // namespace
}  // namespace assay::adapters::test_process_watch
