// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/worker_process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "adapters/worker/descendants.hpp"
#include "adapters/worker/futex.hpp"
#include "adapters/worker/high_files.hpp"
#include "adapters/worker/missing_file.hpp"
#include "adapters/worker/shortage.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

namespace {

constexpr int look_ms = 200;  ///< how often a host looks whether anybody is there

class Spawn {
 public:
  Spawn() {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setpgroup(&attributes_, 0);  // not ended by the terminal's Ctrl-C
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~Spawn() {
    for (const int file : files_) ::close(file);
    ::posix_spawnattr_destroy(&attributes_);
    ::posix_spawn_file_actions_destroy(&actions_);
  }
  Spawn(const Spawn&) = delete;
  Spawn& operator=(const Spawn&) = delete;

  void hand(int file, int as) {
    if (file < 0) return;
    const int copy = high_copy(file);
    if (copy < 0) throw std::system_error(errno, std::generic_category(), "fcntl");
    files_.push_back(copy);
    ::posix_spawn_file_actions_adddup2(&actions_, copy, as);
  }

  pid_t start(const std::string& program) {
    char name[] = "assay", verb[] = "worker";
    char* words[] = {name, verb, nullptr};
    pid_t child = -1;
    const int failed = ::posix_spawn(&child, program.c_str(), &actions_, &attributes_, words, environ);
    if (failed) throw std::system_error(failed, std::generic_category(), "'" + program + "' cannot be started");
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
  std::vector<int> files_;
};

}  // namespace

std::string worker_program() {
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  if (code || self.filename() == "assay") return "/proc/self/exe";
  return (self.parent_path() / "assay").string();
}

WorkerProcess::WorkerProcess(const WorkerStart& start)
    : memory_(shared_size), time_limit_(start.limits.seconds), memory_limit_(start.limits.gigabytes) {
  Control& c = control();
  c.time_limit = start.limits.seconds;
  c.memory_limit = static_cast<std::uint64_t>(start.limits.gigabytes * 1e9);
  if (start.task.size() >= task_size) throw std::system_error(E2BIG, std::generic_category(), "the task");
  std::memcpy(static_cast<char*>(memory_.data()) + task_offset, start.task.c_str(), start.task.size() + 1);
  int ends[2];
  if (!high_pipe(ends)) throw std::system_error(errno, std::generic_category(), "pipe");
  try {
    Spawn spawn;
    spawn.hand(memory_.file(), memory_file);
    spawn.hand(ends[0], lifeline_file);
    spawn.hand(start.records, records_file);
    spawn.hand(start.columns, columns_file);
    warden_ = spawn.start(worker_program());
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[0]);
  lifeline_ = ends[1];
}

WorkerProcess::~WorkerProcess() {
  ::close(lifeline_);  // the warden ends what there is
  await_end(warden_);
  remove_folder();
}

/// Left by a warden that was killed. What the model may have written over its name is no folder of a worker.
void WorkerProcess::remove_folder() const {
  namespace fs = std::filesystem;
  const char* text = control().folder;
  const fs::path folder(std::string(text, strnlen(text, words_size)));
  std::error_code ignored;
  if (folder.is_absolute() && folder.filename().string().starts_with(worker_folder) &&
      fs::is_directory(folder, ignored)) {
    fs::remove_all(folder, ignored);
  }
}

/// A call has taken so long that the warden should have ended it.
bool WorkerProcess::warden_is_stuck() const {
  constexpr double grace_s = 5;
  const std::int64_t since = control().busy_since.load();
  return since != 0 && 1e-9 * static_cast<double>(now_ns() - since) > time_limit_ + grace_s;
}

bool WorkerProcess::killed() const {
  const auto death = static_cast<Death>(control().death.load());
  return death == Death::lost || (death == Death::signal && control().death_number == SIGKILL);
}

bool WorkerProcess::warden_is_gone() const {
  siginfo_t ended = {};
  return ::waitid(P_PID, static_cast<id_t>(warden_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == warden_;
}

void WorkerProcess::post(std::uint32_t operation) {
  Control& c = control();
  c.operation.store(operation);
  c.spin_us.store(habit_.look());
  c.request.store(++posted_);
  if (wake_sleeper(c.request, c.worker_sleeps)) c.wake_ups.fetch_add(1);
}

/// Where the system was short of something, that is noted.
bool WorkerProcess::is_dead() {
  const auto death = static_cast<Death>(control().death.load());
  if (death == Death::shortage) note_shortage("a worker could not be started: " + death_words());
  const bool unexplained =
      death == Death::signal || death == Death::exit || death == Death::stack || death == Death::null;
  const std::string tight = unexplained ? tight_limits() : "";
  if (!tight.empty()) note_shortage("a worker " + how_it_ended() + ", and " + tight + ": that may be why");
  if (death == Death::signal && control().death_number == SIGXCPU && !processor_limit().empty())
    note_shortage("a worker " + how_it_ended() + ": " + processor_limit());
  return death != Death::none;
}

bool WorkerProcess::wait() {
  Control& c = control();
  const std::uint32_t wanted = posted_, look = c.spin_us.load();
  if (look > 0) habit_.note(changes_within(c.reply, wanted - 1, look));
  for (;;) {
    const std::uint32_t seen = c.reply.load();
    if (is_dead()) return false;
    if (seen == wanted) return true;
    wait_while(c.reply, seen, c.host_sleeps, look_ms);
    std::uint32_t none = 0;
    if (c.reply.load() == seen) ::kill(warden_, SIGCONT);
    if (c.reply.load() == seen && warden_is_stuck()) ::kill(warden_, SIGKILL);
    if (c.reply.load() == seen && warden_is_gone()) {
      c.death.compare_exchange_strong(none, static_cast<std::uint32_t>(Death::lost));
    }
    if (give_up_waiting && give_up_waiting()) {
      c.death.compare_exchange_strong(none, static_cast<std::uint32_t>(Death::given_up));
    }
  }
}

std::string WorkerProcess::death_words() const {
  return {control().death_words, strnlen(control().death_words, words_size)};
}

std::string WorkerProcess::output() const { return control().output.text(); }

std::string WorkerProcess::how_it_ended() const {
  const Control& c = control();
  const auto limit = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return std::string(text);
  };
  const int number = c.death_number;
  const std::string said = last_line(output()), words = death_words();
  const std::string heard = phase_words(static_cast<CallPhase>(c.phase.load())) +
                            (said.empty() ? "" : "; its last output: " + said) + missing_file_words(output());
  switch (static_cast<Death>(c.death.load())) {
    case Death::none:
      return "did not answer";
    case Death::signal:
      return "was ended by signal " + std::to_string(number) + " (" + strsignal(number) + ")" + heard;
    case Death::exit:
      return "ended the process with status " + std::to_string(number) + ", without a result" + heard;
    case Death::time_limit:
      return "did not return within " + limit(time_limit_) + " s" + heard;
    case Death::memory:
      return "took more than " + limit(memory_limit_) + " GB of memory" + heard;
    case Death::stack:
      return "was ended by signal " + std::to_string(number) + ": the stack overflowed" + heard;
    case Death::null:
      return "was ended by signal " + std::to_string(number) + ": it used a null pointer" + heard;
    case Death::unaligned:
      return "was ended by signal " + std::to_string(number) + ": it used an address that is not aligned" + heard;
    case Death::ended:
      return words + heard;
    case Death::given_up:
      return "was not waited for";
    case Death::lost:
      return "was lost with the process that watched it";
    case Death::shortage:
      return "could not be started: " + words;
  }
  return "ended";
}

}  // namespace assay::adapters
