// SPDX-License-Identifier: BSD-3-Clause
// A process that runs nothing of a model and stands between the one that does and the program: it ends what the model
// leaves, whatever ends the model, or the program.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace assay::drivers {

struct Keeper {
  using Work = std::function<void(const std::string& folder)>;

  pid_t pid = -1;
  pid_t process = -1;  ///< that is kept
  int lifeline = -1;   ///< closed: the keeper ends all, removes the folder, and itself
  int told = -1;       ///< an int: the status of the process as of waitpid(), when it has ended
  std::string folder;  ///< of the kept process; the keeper makes it, so that nothing is left whenever the program dies
};

/// Two more processes: `work`, which does not come back, and its keeper. files: those that `work` uses; others: that
/// neither is to hold; folders: where the new folder is made, whose name is empty where none could be. Throws
/// SystemError where no process can be made.
Keeper start_kept(const Keeper::Work& work, const std::vector<int>& files, const std::vector<int>& others,
                  const std::string& folders);

/// Whether the kept process has ended; then its status, and whether that is known: not where it took its keeper along.
bool kept_is_over(const Keeper& keeper, int& status, bool& lost);

/// Lets the keeper end everything, and waits for it, if need be not for long.
void dismiss(const Keeper& keeper);

}  // namespace assay::drivers
