// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_elsewhere.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/worker/descendants.hpp"
#include "adapters/worker/high_files.hpp"
#include "adapters/worker/own_folder.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/own_files.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

namespace {

using Maker = std::function<check::History()>;

/// Behind the last row, so that rows of a process that has ended too soon are told from all.
constexpr double end_of_rows = -1;

void send_all(const std::vector<double>& all, int out) {
  const char* bytes = reinterpret_cast<const char*>(all.data());
  for (std::size_t at = 0, size = all.size() * sizeof(double); at < size;) {
    const ssize_t written = ::write(out, bytes + at, size - at);
    if (written < 0 && errno != EINTR) leave_process(1);
    if (written > 0) at += static_cast<std::size_t>(written);
  }
}

/// The process itself, then row by row, each after its length.
[[noreturn]] void send(const Maker& make, int out) {
  leave_no_marks();
  own_this_process();
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  keep_these_streams();
  std::signal(SIGSEGV, SIG_DFL);  // its end is nobody's finding
  std::signal(SIGBUS, SIG_DFL);
  send_all({static_cast<double>(::getpid())}, out);
  std::vector<double> all;
  try {
    for (const auto& row : make()) {
      all.push_back(static_cast<double>(row.size()));
      all.insert(all.end(), row.begin(), row.end());
    }
    all.push_back(end_of_rows);
  } catch (const std::exception&) {
    leave_process(1);
  }
  send_all(all, out);
  leave_process(0);
}

/// Nothing where the last of them has not come.
std::optional<check::History> rows_of(const std::vector<double>& all) {
  check::History rows;
  for (std::size_t at = 1; at < all.size();) {
    const double size = all[at++];
    if (size == end_of_rows && at == all.size()) return rows;
    if (!(size >= 0) || size > static_cast<double>(all.size() - at)) return std::nullopt;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(at);
    rows.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(size));
    at += static_cast<std::size_t>(size);
  }
  return std::nullopt;
}

std::vector<double> numbers_in(const std::string& bytes) {
  std::vector<double> all(bytes.size() / sizeof(double));
  std::copy_n(bytes.data(), all.size() * sizeof(double), reinterpret_cast<char*>(all.data()));
  return all;
}

struct Received {
  pid_t sender = -1;
  bool in_time = false;  ///< the rows have come, or can come no more
  std::optional<check::History> rows = {};
};

/// A child that stays to be buried.
bool has_ended(pid_t child) {
  if (child < 0) return false;
  siginfo_t info = {};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
}

/// Returns when the rows are whole, or when the pipe is closed: processes other than the sender may hold it. A model
/// that has killed whoever waits for it has a short time left.
Received received(int in, pid_t waiting, double limit_s) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds look{50}, grace{250};
  auto end = Clock::now() + std::chrono::milliseconds(std::llround(1e3 * limit_s));
  Received found;
  std::string bytes;
  for (char text[1 << 14];;) {
    if (has_ended(waiting)) end = std::min(end, Clock::now() + grace), waiting = -1;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    pollfd file{in, POLLIN, 0};
    if (left.count() <= 0) return found;
    if (::poll(&file, 1, static_cast<int>(std::min(left, look).count())) < 0 && errno != EINTR) return found;
    if (file.revents == 0) continue;
    const ssize_t length = ::read(in, text, sizeof text);
    if (length < 0 && errno != EINTR) return found;
    if (length > 0) bytes.append(text, static_cast<std::size_t>(length));
    const std::vector<double> all = numbers_in(bytes);
    if (!all.empty()) found.sender = static_cast<pid_t>(all.front());
    const bool may_be_whole = !all.empty() && bytes.size() % sizeof(double) == 0 && all.back() == end_of_rows;
    found.rows = may_be_whole ? rows_of(all) : std::nullopt;
    found.in_time = length == 0 || found.rows;
    if (found.in_time) return found;
  }
}

/// Orphans of its children are its own as long as it lives.
struct Adopting {
  Adopting() {
    ::prctl(PR_GET_CHILD_SUBREAPER, &before);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  }
  ~Adopting() { ::prctl(PR_SET_CHILD_SUBREAPER, before); }
  Adopting(const Adopting&) = delete;
  Adopting& operator=(const Adopting&) = delete;
  int before = 0;
};

/// Of both: near where the rows have come, brought about otherwise, of the sender, which the other waits for; waits
/// until no watcher sees either.
void end_group(pid_t process, const Received& what) {
  constexpr int patience_ms = 500;
  if (!what.in_time) ::kill(what.sender > 0 ? what.sender : -process, SIGKILL);
  adapters::await_end(process);
  for (int waited = 0; ::kill(-process, SIGKILL) == 0 && waited < patience_ms; ++waited) {
    if (::waitpid(-process, nullptr, WNOHANG) == 0) ::usleep(1000);
  }
}

}  // namespace

std::optional<check::History> made_elsewhere(const Maker& make, double limit_s) {
  int ends[2];
  if (!adapters::high_pipe(ends)) return std::nullopt;
  const adapters::AwaitedChildren awaited;
  const Adopting adopting;
  const adapters::OwnFolder folder;
  const pid_t process = ::fork();
  if (process == 0) {  // between the two, for models that kill whoever has started them
    ::setpgid(0, 0);
    if (!folder.enter()) leave_process(1);
    const pid_t sender = ::fork();
    if (sender == 0) send(make, ends[1]);
    ::close(ends[1]);
    while (::waitpid(sender, nullptr, WUNTRACED) < 0 && errno == EINTR) {
    }
    ::kill(sender, SIGKILL);  // where it has stopped itself
    leave_process(0);
  }
  ::setpgid(process, process);  // whichever comes first
  ::close(ends[1]);
  const Received all = process > 0 ? received(ends[0], process, limit_s) : Received();
  ::close(ends[0]);
  if (process < 0) return std::nullopt;
  end_group(process, all);
  return all.rows;
}

check::History history_elsewhere(const Material& material, const check::Effort& effort, double limit_s) {
  const auto make = [&] { return check::history(material, check::amplitudes_of_first(effort).back()); };
  return made_elsewhere(make, limit_s).value_or(check::History());
}

namespace {

/// With other parameters, from a library that this process has not loaded.
Material made_of(const ResolvedMaterial& material, const std::string& library) {
  const std::map<std::string, double> parameters = check::other_parameters(material.material);
  if (material.foreign) {
    adapters::ForeignModel model = *material.foreign;
    if (model.folder.empty()) model.folder = std::filesystem::path(model.library).parent_path().string();
    model.library = library;
    return Material(adapters::foreign_table(model), parameters);
  }
  MaterialChoice choice = material.choice;
  choice.adapter = library + ":" + material.material.name();
  choice.parameters = parameters;
  choice.isolation = Isolation::none;
  return resolve_material(choice).material;
}

}  // namespace

check::History history_of_others(const ResolvedMaterial& material, const check::Effort& effort, double limit_s) {
  if (material.library.empty() || (!material.description.empty() && !material.foreign)) return {};
  if (material.foreign && material.foreign->each_its_element) return {};  // where elements are numbered otherwise
  std::error_code code;
  std::string folder = (std::filesystem::temp_directory_path(code) / "assay-XXXXXX").string();
  if (code || ::mkdtemp(folder.data()) == nullptr) return {};
  const std::filesystem::path copy = std::filesystem::path(folder) / "copy.so";
  std::filesystem::copy_file(material.library, copy, code);
  check::History found;
  if (!code) {
    const Maker make = [&] {
      return check::history(made_of(material, copy.string()), check::amplitudes_of_first(effort).back());
    };
    found = made_elsewhere(make, limit_s).value_or(check::History());
  }
  std::filesystem::remove_all(folder, code);
  return found;
}

}  // namespace assay::drivers
