// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/tool_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "adapters/worker/worker_process.hpp"
#include "drivers/result/result.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// That of this process, in English, with its own folder for temporary files.
std::vector<std::string> environment_for(const ToolCall& call) {
  std::vector<std::string> all{"LC_ALL=C"};
  if (!call.temporary.empty()) all.push_back("TMPDIR=" + call.temporary);
  for (char** each = environ; each && *each; ++each) {
    const std::string text = *each;
    const bool replaced = text.starts_with("LC_ALL=") || text.starts_with("LANGUAGE=") ||
                          (!call.temporary.empty() && text.starts_with("TMPDIR="));
    if (!replaced) all.push_back(text);
  }
  return all;
}

/// What the tool begins with.
struct Prepared {
  explicit Prepared(const ToolCall& call) : words{call.program}, environment(environment_for(call)) {
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    word_pointers = adapters::pointers_to(words);
    environment_pointers = adapters::pointers_to(environment);
  }
  std::vector<std::string> words, environment;
  std::vector<char*> word_pointers, environment_pointers;
};

[[noreturn]] void become_tool(const ToolCall& call, const Prepared& prepared, int said) {
  const auto most = static_cast<rlim_t>(call.limit_s) + 1;  // of what outlives this process, too
  const rlimit time{most, most};
  ::setrlimit(RLIMIT_CPU, &time);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGXFSZ, SIGXCPU}) std::signal(signal, SIG_DFL);
  adapters::send_streams_to(said, said);
  ::fcntl(adapters::memory_file, F_SETFD, FD_CLOEXEC);
  if (!call.folder.empty() && ::chdir(call.folder.c_str()) != 0) leave_process(126);
  ::execve(call.program.c_str(), prepared.word_pointers.data(), prepared.environment_pointers.data());
  leave_process(127);
}

/// A task of texts, each behind its length.
std::string task_of(const ToolCall& call) {
  std::string task = std::string(tool_task) + "\n";
  const auto add = [&](const std::string& text) { task += std::to_string(text.size()) + ":" + text; };
  std::error_code gone;  // then it stands in the worker's own folder
  const std::string here = call.folder.empty() ? std::filesystem::current_path(gone).string() : call.folder;
  for (const std::string& text : {call.program, here, call.temporary, number_text(call.limit_s)}) add(text);
  for (const std::string& argument : call.arguments) add(argument);
  return task;
}

ToolCall call_of(const std::string& task) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < task.size();) {
    const std::size_t colon = task.find(':', at), size = std::stoul(task.substr(at, colon - at));
    texts.push_back(task.substr(colon + 1, size));
    at = colon + 1 + size;
  }
  return {.program = texts.at(0),
          .arguments = {texts.begin() + 4, texts.end()},
          .folder = texts.at(1),
          .temporary = texts.at(2),
          .limit_s = std::stod(texts.at(3))};
}

}  // namespace

void serve_tool(const std::string& task) {
  const ToolCall call = call_of(task);
  become_tool(call, Prepared(call), adapters::columns_file);
}

ToolEnd run_tool(const ToolCall& call) try {
  using Clock = std::chrono::steady_clock;
  const InterruptWatch watch;
  const auto start = Clock::now();
  constexpr std::size_t most_said = 1 << 20;
  const adapters::PrintedFile said("assay-tool");
  const adapters::OpenFile heard(adapters::high_copy(said.number()));  // not where the worker's other files go
  ToolEnd end;
  {
    const adapters::WorkerProcess tool({.task = task_of(call),
                                        .build = build_text(),
                                        .limits = {.seconds = 0, .gigabytes = 0},
                                        .columns = heard.number()});
    for (useconds_t pause = 200; !tool.is_over(); pause = std::min<useconds_t>(2 * pause, 20000)) {
      stop_if_interrupted();
      end.stopped = std::chrono::duration<double>(Clock::now() - start).count() > call.limit_s;
      if (end.stopped) break;
      ::usleep(pause);
    }
    stop_if_interrupted();
    if (tool.control().end() == adapters::Death::shortage)
      throw SystemError("'" + call.program + "' cannot be started: " + adapters::words_of_end(tool.control()));
    end.status = end.stopped ? 128 + SIGKILL : tool.control().exit_status();
  }  // where it has not ended, it does now
  end.said = said.first(most_said);
  return end;
} catch (const std::system_error& error) {
  throw SystemError(error.what());
}

std::string tool_in_path(const std::string& name) {
  namespace fs = std::filesystem;
  for (const std::string& folder : split(environment_value("PATH"), ':')) {
    const fs::path file = fs::path(folder) / name;
    std::error_code code;
    if (file.is_absolute() && fs::is_regular_file(file, code) && ::access(file.c_str(), X_OK) == 0)
      return file.string();
  }
  return {};
}

}  // namespace assay::drivers
