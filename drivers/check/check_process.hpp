// SPDX-License-Identifier: BSD-3-Clause
// The battery in processes of its own: a model that crashes, exits or never comes back costs one verdict.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/process/fate.hpp"
#include "drivers/check/check_report.hpp"

namespace assay::drivers {

/// What is told on the way: which material it is, before its first test, the id of every test that begins, and what it
/// has found.
struct CheckReporter {
  std::function<void(const CheckedMaterial&)> material;
  std::function<void(const std::string& id)> begins;
  std::function<void(const check::TestResult& result)> ends;
  std::function<adapters::Habits()> habits;  ///< or-ed adapters::Habit: what the model has done to its process so far
  bool first_calls = false;                  ///< the process is the check's own, and nothing has called the model in it
  std::function<void()> over;                ///< the model has run: its instances are kept until all is told
};

struct CheckTask {
  std::string name;  ///< of the material, for a report that does not come
  std::function<CheckedMaterial(const CheckReporter& reporter)> run;
  adapters::WorkerLimits limits = {};  ///< of one call of a foreign model, and of memory
  bool strain_is_asked = false;        ///< then no advice asks for another one
};

struct CheckProcesses {
  int at_once = 1;
  double limit_s = 600;                                 ///< for each
  std::function<void(std::size_t done)> progress = {};  ///< whenever one has ended
  /// Again and again while one runs: how many of its tests have begun, and the last of them.
  std::function<void(std::size_t begun, const std::string& test)> at_work = {};
};

/// Each task in a process of its own, in the order given. One that ends without a report has failed the test in which
/// it ended. Throws Interrupted, SystemError.
std::vector<CheckedMaterial> check_in_processes(const std::vector<CheckTask>& tasks, const CheckProcesses& how);

}  // namespace assay::drivers
