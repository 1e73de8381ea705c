// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/exit_guard.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include "adapters/process/fate.hpp"
#include "adapters/process/shortage.hpp"

namespace assay::drivers {

namespace {

constexpr std::array crashes{SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

/// The guarded process, 0 when there is none.
std::atomic<pid_t> guarded{0};
std::atomic<bool> said{false};
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler may touch nothing else");

std::array<bool, crashes.size()> installed{};

char crash_words[256];  ///< behind the number of the signal

Parting* parting = nullptr;
pid_t parting_process = 0;   ///< whose word it is: a model can write into what is shared
std::atomic<int> whole{-1};  ///< the status that stands, whatever comes

std::string loaded_library;
struct stat as_loaded = {};

bool is_guarded() { return guarded != 0 && guarded == ::getpid(); }

void say(const char* text) { [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, std::strlen(text)); }

/// The first to come says it; other threads that crash meanwhile wait for the end.
[[noreturn]] void say_and_leave(const char* line) {
  if (said.exchange(true)) {
    for (;;) ::pause();
  }
  const int stands = whole;
  if (stands >= 0) say("warning: after all was written, ");
  say(line);
  leave_process(stands >= 0 ? stands : 3);
}

/// Written over where it lies, which takes the pages away from under who uses it.
bool library_was_changed() {
  struct stat found = {};
  return !loaded_library.empty() && ::stat(loaded_library.c_str(), &found) == 0 && found.st_ino == as_loaded.st_ino &&
         (found.st_size != as_loaded.st_size || found.st_mtim.tv_sec != as_loaded.st_mtim.tv_sec ||
          found.st_mtim.tv_nsec != as_loaded.st_mtim.tv_nsec);
}

[[noreturn]] void say_ended() {
  say_and_leave("assay: the process was ended from inside, most likely by the material's library\n");
}

void on_exit() {
  if (is_guarded()) say_ended();
}

/// Puts the parts one behind another, of which the last is a text; async-signal-safe.
template <class... Parts>
void compose(char* text, Parts... parts) {
  const auto append = [&text](auto part) {
    if constexpr (std::is_integral_v<decltype(part)>)
      text = std::to_chars(text, text + 24, part).ptr;
    else
      text = ::stpcpy(text, part);
  };
  (append(parts), ...);
}

void on_crash(int signal, siginfo_t* why, void* /*context*/) {
  if (!is_guarded()) {  // a child that inherited the handler: it dies of the signal
    std::signal(signal, SIG_DFL);
    ::raise(signal);
    return;
  }
  if (library_was_changed()) say_and_leave("assay: crashed: the material's library was changed while it was in use\n");
  char line[sizeof crash_words + 100];
  if (why->si_code <= 0 && why->si_pid != ::getpid())
    compose(line, "assay: ended from outside, by signal ", signal, " of process ", why->si_pid, "\n");
  else
    compose(line, "assay: crashed (signal ", signal, static_cast<const char*>(crash_words));
  say_and_leave(line);
}

/// In time: a signal handler can do little.
void compose_crash_words() {
  const std::string tight = adapters::tight_limits();
  const std::string words = !tight.empty()            ? "), and " + tight + ": that may be why"
                            : !loaded_library.empty() ? "), most likely in the material's library"
                                                      : "): this is a bug of assay";
  std::snprintf(crash_words, sizeof crash_words, "%s\n", words.c_str());
}

/// The first word stands. A watcher that was stopped goes on.
void tell_parting(int status) noexcept {
  if (!parting || parting_process != ::getpid() || parting->is_told) return;
  parting->status = status;
  parting->is_told = true;
  ::kill(::getppid(), SIGCONT);
}

}  // namespace

ExitGuard::ExitGuard() {
  static const int registered = std::atexit(on_exit);
  static_cast<void>(registered);
  compose_crash_words();
  adapters::use_handler_stack();
  struct sigaction action = {};
  action.sa_sigaction = on_crash;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_ONSTACK | SA_SIGINFO;
  for (std::size_t i = 0; i < crashes.size(); ++i) {
    struct sigaction present = {};
    // Sanitizers and debuggers keep theirs.
    installed[i] = sigaction(crashes[i], nullptr, &present) == 0 && (present.sa_flags & SA_SIGINFO) == 0 &&
                   present.sa_handler == SIG_DFL && sigaction(crashes[i], &action, nullptr) == 0;
  }
  said = false;
  guarded = ::getpid();
}

ExitGuard::~ExitGuard() {
  guarded = 0;
  for (std::size_t i = 0; i < crashes.size(); ++i) {
    if (installed[i]) std::signal(crashes[i], SIG_DFL);
    installed[i] = false;
  }
}

const Parting* ExitGuard::share_last_word() {
  void* page = ::mmap(nullptr, sizeof(Parting), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) return nullptr;
  return parting = new (page) Parting{};
}

void ExitGuard::move_to_this_process(const char* library) {
  loaded_library = library;
  if (::stat(library, &as_loaded) != 0) loaded_library.clear();
  parting_process = ::getpid();
  compose_crash_words();
  if (guarded != 0) guarded = ::getpid();
}

void results_are_whole(int status) noexcept {
  whole = status;
  tell_parting(status);
}

void leave_process(int status) noexcept {
  tell_parting(status);
  for (;;) ::syscall(SYS_exit_group, status);
}

void leave_process_guarded(int status) noexcept {
  if (is_guarded()) say_ended();
  leave_process(status);
}

void leave_thread_guarded() noexcept {
  if (::gettid() != ::getpid()) return;
  if (is_guarded())
    say_and_leave("assay: the model ended its thread (pthread_exit, pthread_cancel), which ends the process\n");
  if (adapters::crashes_are_marked()) adapters::end_by_word("ended its thread by pthread_exit() or pthread_cancel()");
}

}  // namespace assay::drivers
