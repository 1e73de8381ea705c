// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/standard/standard_runs.hpp"

#include <unistd.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "drivers/study/run/runner.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

ProcessEnd waited_for(CaseProcess process, Progress& progress, double share, const std::string& detail) {
  constexpr int pause_us = 20'000;
  while (!process.is_over()) {
    stop_if_interrupted();
    progress.update(share, detail);
    ::usleep(pause_us);
  }
  return process.end();
}

/// What judge takes for the cost of a run: seconds of its steps, in one thread.
void write_cost(const fs::path& run, double seconds) {
  if (!(seconds > 0)) return;
  write_file(run / "cost.yaml", "seconds: " + number_text(seconds) + "\ncores: 1\nmachine: '" + machine_name() + "'\n");
}

/// "the run was unstable: why" of a run that has not reached its end.
std::string fault_of(const fs::path& run, const ProcessEnd& end) {
  std::error_code code;
  if (!fs::is_regular_file(run / "result.json", code)) return end.last_line;
  const auto result = nlohmann::json::parse(read_bytes((run / "result.json").string()), nullptr, false);
  if (result.is_discarded() || !result.contains("outcome")) return "its result.json is damaged";
  std::string outcome = result["outcome"];
  if (outcome == "completed") {
    write_cost(run, result.value("step_cpu_s", 0.0));
    return {};
  }
  return outcome;
}

}  // namespace

std::vector<std::string> sets_of(const StandardSet& set, const StandardMethod& method, const StandardProblem& problem) {
  std::vector<std::string> sets;
  if (!problem.scene().method) sets = set.in_space;
  sets.insert(sets.end(), method.sets.begin(), method.sets.end());
  return sets;
}

CardCode run_by(const StandardSet& set, const StandardMethod& method, const std::string& out, bool quiet,
                const std::string& program) {
  const fs::path folder = fs::path(out) / method.folder;
  std::map<std::string, std::string> faults;  // of problems
  Progress progress(method.name, quiet);
  std::size_t done = 0;
  for (const StandardProblem& problem : set.problems) {
    const double share = static_cast<double>(done++) / static_cast<double>(set.problems.size());
    fs::create_directories(folder / problem.id);
    const fs::path scene = folder / problem.id / problem.file();
    write_file(scene, problem.text);
    const std::vector<std::string> sets = sets_of(set, method, problem);
    for (const double h : problem.grids) {
      const fs::path run = folder / problem.id / folder_of_grid(h);
      std::vector<std::string> words{
          "run",   scene.string(), "-o", run.string(), "--quiet", "--set", "grid.spacing=" + number_text(h),
          "--set", "expect={}"};
      for (const std::string& setting : sets) words.insert(words.end(), {"--set", setting});
      const ProcessEnd end =
          waited_for(CaseProcess(program, words, 0), progress, share, problem.id + ", h = " + rounded_text(h, 3));
      const std::string fault = fault_of(run, end);
      if (!fault.empty())
        faults[problem.id] += (faults[problem.id].empty() ? "" : "; ") + folder_of_grid(h) + ": " + fault;
    }
  }
  progress.finish();
  write_file(folder / "judge.map.yaml", "code: '" + method.name + "'\n");
  CardCode code = judged_code(set, folder.string(), folder.string(), quiet);
  code.name = method.name;
  for (CardRow& row : code.rows) {
    const auto fault = faults.find(row.id);
    if (fault == faults.end()) continue;
    row.good = false;
    row.found = fault->second;
  }
  return code;
}

}  // namespace assay::drivers
