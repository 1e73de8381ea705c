// SPDX-License-Identifier: BSD-3-Clause
// The program itself, for what a test cannot do in its own process.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers {

/// Starts `assay WORDS...`, called as if found in PATH, with standard output and error in this file; `before` acts in
/// the child.
inline pid_t start_assay(const std::vector<std::string>& words, const std::string& said,
                         const std::function<void()>& before = {}) {
  const std::string program = built("assay");
  std::string name = "assay";
  std::vector<char*> argv{name.data()};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int file = ::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  if (before) before();
  ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

struct Ending {
  int status = -1;   ///< exit status, 128 + signal
  std::string said;  ///< on standard output and error
};

inline Ending assay(const std::vector<std::string>& words, const std::function<void()>& before = {}) {
  const ScratchFolder scratch;
  int status = 0;
  ::waitpid(start_assay(words, scratch / "said", before), &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), bytes_of(scratch / "said")};
}

}  // namespace assay::drivers
