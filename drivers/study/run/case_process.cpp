// SPDX-License-Identifier: BSD-3-Clause
// One case of a study, in a process of its own.
#include "drivers/study/run/runner.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace {

std::string last_line_in(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t begin = text.rfind('\n');
  return one_line(begin == text.npos ? text : text.substr(begin + 1), 400);
}

[[noreturn]] void become(const std::string& program, const std::vector<char*>& words, int errors) {
  adapters::send_streams_to(::open("/dev/null", O_WRONLY | O_CLOEXEC), errors);
  keep_these_streams();
  ::execv(program.c_str(), words.data());
  leave_process(3);
}

}  // namespace

/// In the terminal's group: what stops a study there stops its cases.
CaseProcess::CaseProcess(const std::string& program, const std::vector<std::string>& arguments, double limit_s) try
    : errors_(std::make_unique<adapters::PrintedFile>("assay-case")),
      limit_s_(limit_s),
      start_(Clock::now()),
      busy_at_start_(machine_busy_s()) {
  std::vector<std::string> words{"assay"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> pointers = adapters::pointers_to(words);
  const adapters::Kept kept{.work = [&](adapters::Fate&) { become(program, pointers, errors_->number()); },
                            .folders = nullptr,
                            .hears = false,
                            .own_group = false,
                            .defers_signals = true};
  process_ = std::make_unique<adapters::KeptProcess>(kept, adapters::WorkerLimits{.seconds = 0, .gigabytes = 0});
} catch (const std::system_error& error) {
  fail("case", "cannot be started", error.code());
}

CaseProcess::~CaseProcess() {
  constexpr int patience_ms = 5000;
  if (process_) process_->ask_to_end();
  for (int waited = 0; !is_over() && waited < patience_ms; ++waited) ::usleep(1000);
}

bool CaseProcess::is_over() {
  constexpr std::size_t most_kept = 1 << 14;
  if (!process_) return true;
  if (limit_s_ > 0 && !end_.stopped && std::chrono::duration<double>(Clock::now() - start_).count() > limit_s_) {
    end_.stopped = true;
    process_->end();
  }
  if (!process_->is_over()) return false;
  end_.status = process_->fate().exit_status();
  end_.wall_s = std::chrono::duration<double>(Clock::now() - start_).count();
  end_.cpu_s = process_->fate().processor_s;
  const double others_s = machine_busy_s() - busy_at_start_ - end_.cpu_s;
  end_.others = end_.wall_s > 0 ? std::max(0.0, others_s / end_.wall_s) : 0;
  end_.last_line = last_line_in(errors_->last(most_kept));
  process_.reset();
  return true;
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
