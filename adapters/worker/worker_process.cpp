// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/worker_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "adapters/library.hpp"
#include "adapters/process/shortage.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay::adapters {

namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& file) {
  std::error_code code;
  return fs::is_regular_file(file, code) && ::access(file.c_str(), X_OK) == 0;
}

/// Throws std::system_error.
std::string program_of_library(const fs::path& library) {
  constexpr const char* name = "assay";
  if (const char* said = std::getenv("ASSAY_PROGRAM"); said && *said) return said;
  std::error_code code;
  const fs::path file = fs::canonical(library, code);
  fs::path above = file.parent_path();
  if (is_program(above / name)) return (above / name).string();
  constexpr int most = 3;  // PREFIX/lib/x86_64-linux-gnu
  for (int k = 0; k < most && above.has_relative_path(); ++k) {
    above = above.parent_path();
    if (is_program(above / "bin" / name)) return (above / "bin" / name).string();
  }
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (folder.starts_with('/') && is_program(fs::path(folder) / name)) return (fs::path(folder) / name).string();
  }
  throw std::system_error(ENOENT, std::generic_category(),
                          "the program assay is neither beside " + file.string() +
                              " nor in bin of its installation, nor is it $ASSAY_PROGRAM or in $PATH");
}

/// What was started serves no worker of this build.
class WrongProgram : public std::system_error {
 public:
  explicit WrongProgram(const std::string& words)
      : std::system_error(std::make_error_code(std::errc::wrong_protocol_type)), words_(words) {}
  const char* what() const noexcept override { return words_.c_str(); }

 private:
  std::string words_;
};

}  // namespace

std::string worker_program() {
  if (!own_library().empty()) return program_of_library(own_library());
  std::error_code code;
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  if (code || self.filename() == "assay") return "/proc/self/exe";
  return (self.parent_path() / "assay").string();
}

namespace {

/// With a group of its own, which the terminal's Ctrl-C does not end. The numbers of our files are high, so that none
/// lies where another goes.
pid_t started(const WorkerStart& start, const SharedMemory& memory, int lifeline) {
  if (start.task.size() >= task_size) throw std::system_error(E2BIG, std::generic_category(), "the task");
  std::memcpy(static_cast<char*>(memory.data()) + task_offset, start.task.c_str(), start.task.size() + 1);
  const std::string program = worker_program();
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_adddup2(&files, memory.file(), memory_file);
  ::posix_spawn_file_actions_adddup2(&files, lifeline, lifeline_file);
  if (!own_library().empty()) {  // a host has words of its own
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  }
  if (start.columns >= 0) ::posix_spawn_file_actions_adddup2(&files, start.columns, columns_file);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  char name[] = "assay", verb[] = "worker";
  std::string build = start.build;
  char* words[] = {name, verb, build.empty() ? nullptr : build.data(), nullptr};
  pid_t child = -1;
  const int failed = ::posix_spawn(&child, program.c_str(), &files, &attributes, words, environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  if (failed) throw std::system_error(failed, std::generic_category(), "'" + program + "' cannot be started");
  return child;
}

}  // namespace

WorkerProcess::WorkerProcess(const WorkerStart& start)
    : limits_(start.limits),
      build_(start.build),
      kept_(shared_size, start.limits,
            [&](const SharedMemory& memory, int lifeline) { return started(start, memory, lifeline); }) {}

/// Where the system was short of something, that is noted.
bool WorkerProcess::is_dead() const {
  const Control& c = control();
  const Death death = c.end();
  if (death == Death::shortage) note_shortage("a worker could not be started: " + words_of_end(c));
  const bool unexplained =
      death == Death::signal || death == Death::exit || death == Death::stack || death == Death::null;
  const std::string tight = unexplained ? tight_limits() : "";
  if (!tight.empty()) note_shortage("a worker " + how_it_ended() + ", and " + tight + ": that may be why");
  if (death == Death::signal && c.death_number == SIGXCPU && !processor_limit().empty())
    note_shortage("a worker " + how_it_ended() + ": " + processor_limit());
  return death != Death::none;
}

void WorkerProcess::refuse_other_build() const {
  const char* words = static_cast<const char*>(kept_.memory().data()) + kept_.memory().size() - refusal_size;
  const std::string other(words, strnlen(words, refusal_size));
  if (control().end() != Death::lost || build_.empty()) return;
  const char* named = own_library().empty() ? nullptr : std::getenv("ASSAY_PROGRAM");
  const std::string program = "'" + worker_program() + "'" + (named && *named ? ", which ASSAY_PROGRAM names," : "");
  if (!other.empty())
    throw WrongProgram(program + " is assay " + other.substr(0, 200) + ", and the library is " + build_);
  if (control().process.load() == 0 && !own_library().empty())  // a library may start what is no assay
    throw WrongProgram(program + " ended before it could serve: it must be the program assay " + build_);
}

bool WorkerProcess::is_over() const {
  const bool over = kept_.is_over();
  if (over) refuse_other_build();
  return over;
}

bool WorkerProcess::call(std::uint32_t operation) {
  Control& c = control();
  c.operation.store(operation);
  c.spin_us.store(habit_.look());
  c.request.store(++posted_);
  wake_sleeper(c, c.request, c.worker_sleeps);
  return wait();
}

bool WorkerProcess::wait() {
  constexpr int look_ms = 200;  // how often a host looks whether anybody is there
  Control& c = control();
  const std::uint32_t wanted = posted_, look = c.spin_us.load();
  if (look > 0) habit_.note(changes_within(c.reply, wanted - 1, look));
  for (;;) {
    const std::uint32_t seen = c.reply.load();
    if (is_dead()) {
      refuse_other_build();
      return false;
    }
    if (seen == wanted) return true;
    sleep_while(c.reply, seen, c.host_sleeps, look_ms);
    if (c.reply.load() == seen) kept_.is_over();
    std::uint32_t none = 0;
    if (give_up_waiting && give_up_waiting())
      c.death.compare_exchange_strong(none, static_cast<std::uint32_t>(Death::given_up));
  }
}

std::string WorkerProcess::how_it_ended() const {
  const Control& c = control();
  const std::string said = last_line(output()), words = words_of_end(c);
  const std::string heard = phase_words(static_cast<CallPhase>(c.phase.load())) +
                            (said.empty() ? "" : "; its last output: " + said) + missing_file_words(output());
  switch (c.end()) {
    case Death::none:
      return "did not answer";
    case Death::exit:
      return words + ", without a result" + heard;
    case Death::time_limit:
      return "did not return within " + rounded_text(limits_.seconds, 6) + " s" + heard;
    case Death::memory:
      return "took more than " + rounded_text(limits_.gigabytes, 6) + " GB of memory" + heard;
    case Death::given_up:
      return "was not waited for";
    case Death::lost:
      return "was lost with the process that watched it";
    case Death::shortage:
      return "could not be started: " + words;
    default:
      return words + heard;
  }
}

}  // namespace assay::adapters
