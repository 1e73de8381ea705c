// SPDX-License-Identifier: BSD-3-Clause
// A tool of the system, such as a compiler, in a process of its own: no shell, bounded in time, gone with this process.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

struct ToolCall {
  std::string program;  ///< absolute
  std::vector<std::string> arguments = {};
  std::string folder = {};     ///< in which it works; empty: that of this process
  std::string temporary = {};  ///< $TMPDIR for it; empty: that of this process
  double limit_s = 300;
};

struct ToolEnd {
  int status = 0;        ///< exit status; 128 + signal where it died of one
  bool stopped = false;  ///< it took longer than its limit
  std::string said;      ///< on standard output and error, at most a megabyte; messages are in English
};

/// What a worker does that becomes a tool: the word of its task, and the rest of it.
inline constexpr const char* tool_task = "tool";
[[noreturn]] void serve_tool(const std::string& task);

/// In a worker. Waits for it. Throws SystemError where it cannot be started, and Interrupted when a signal came: then
/// it has been ended, with all that it has started.
ToolEnd run_tool(const ToolCall& call);

/// The file of that name in a folder of $PATH that this process may execute; empty: there is none.
std::string tool_in_path(const std::string& name);

}  // namespace assay::drivers
