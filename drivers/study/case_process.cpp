// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/case_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <utility>

#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace {

constexpr int patience_ms = 5000;  ///< for a process that is asked to end

double seconds_of(const rusage& usage) {
  const auto of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

/// What was printed last, of at most the last kilobytes.
std::string last_line_of(int file) {
  constexpr off_t most = 1 << 14;
  const off_t size = ::lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, most)), '\0');
  const ssize_t length = ::pread(file, text.data(), text.size(), std::max<off_t>(0, size - most));
  text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t begin = text.rfind('\n');
  return one_line(begin == text.npos ? text : text.substr(begin + 1), 400);
}

[[noreturn]] void become(const std::string& program, const std::vector<char*>& arguments, int errors, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) leave_process(3);  // which died before that
  const int nowhere = ::open("/dev/null", O_RDWR);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  keep_these_streams();
  ::execv(program.c_str(), arguments.data());
  leave_process(3);
}

}  // namespace

CaseProcess::CaseProcess(const std::string& program, const std::vector<std::string>& arguments, double limit_s)
    : limit_s_(limit_s), start_(Clock::now()), busy_at_start_(machine_busy_s()) {
  std::vector<std::string> texts{"assay"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  errors_ = ::memfd_create("assay-case", MFD_CLOEXEC);
  if (errors_ < 0) fail("case", "cannot be started", errno);
  std::fflush(nullptr);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) become(program, pointers, errors_, parent);
  if (pid_ < 0) {
    ::close(errors_);
    fail("case", "cannot be started", errno);
  }
}

CaseProcess::CaseProcess(CaseProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      errors_(std::exchange(other.errors_, -1)),
      limit_s_(other.limit_s_),
      start_(other.start_),
      busy_at_start_(other.busy_at_start_),
      end_(std::move(other.end_)) {}

CaseProcess::~CaseProcess() {
  if (pid_ > 0) {
    ::kill(pid_, SIGTERM);
    for (int waited = 0; !is_over() && waited < patience_ms; ++waited) ::usleep(1000);
  }
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (errors_ >= 0) ::close(errors_);
}

bool CaseProcess::is_over() {
  if (pid_ < 0) return true;
  if (limit_s_ > 0 && !end_.stopped && std::chrono::duration<double>(Clock::now() - start_).count() > limit_s_) {
    end_.stopped = true;
    ::kill(pid_, SIGKILL);
  }
  int status = 0;
  rusage usage{};
  const pid_t found = ::wait4(pid_, &status, WNOHANG, &usage);
  if (found == 0 || (found < 0 && errno == EINTR)) return false;
  collect(status, seconds_of(usage));
  return true;
}

void CaseProcess::collect(int status, double cpu_s) {
  pid_ = -1;
  end_.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  end_.wall_s = std::chrono::duration<double>(Clock::now() - start_).count();
  end_.cpu_s = cpu_s;
  const double others_s = machine_busy_s() - busy_at_start_ - cpu_s;
  end_.others = end_.wall_s > 0 ? std::max(0.0, others_s / end_.wall_s) : 0;
  end_.last_line = last_line_of(errors_);
}

double machine_busy_s() {
  std::ifstream stat("/proc/stat");
  std::string line;
  if (!std::getline(stat, line) || !line.starts_with("cpu ")) return 0;
  std::istringstream fields(line.substr(4));
  // user nice system idle iowait irq softirq steal; guests are in user and nice
  double busy = 0, value = 0;
  for (int k = 0; k < 8 && fields >> value; ++k) {
    if (k != 3 && k != 4) busy += value;
  }
  return busy / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::string machine_name() {
  std::string name = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t begin = line.find_first_not_of(" \t", line.find(':') + 1);
    if (begin != line.npos) name = one_line(line.substr(begin), 80);
    break;
  }
  const long cores = ::sysconf(_SC_NPROCESSORS_ONLN);
  return name + ", " + std::to_string(cores) + (cores == 1 ? " core" : " cores");
}

}  // namespace assay::drivers
