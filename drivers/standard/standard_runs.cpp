// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/standard/standard_runs.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <list>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "drivers/study/run/runner.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

struct GridRun {
  const StandardProblem* problem;
  double h;
  fs::path folder;
  std::vector<std::string> words;  ///< of the program
  std::string fault = {};          ///< why it has not reached its end; empty: it has
};

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

/// All of them, one a core at a time. The last ones are the largest and begin first.
void run_all(const std::string& program, std::vector<GridRun>& all, Progress& progress) {
  constexpr int pause_us = 20'000;
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  std::list<std::pair<GridRun*, CaseProcess>> running;
  std::size_t waiting = all.size();
  while (waiting > 0 || !running.empty()) {
    for (; running.size() < cores && waiting > 0; --waiting) {
      GridRun& next = all[waiting - 1];
      running.emplace_back(&next, CaseProcess(program, next.words, 0));
    }
    const GridRun& first = *running.front().first;
    const std::size_t over = all.size() - waiting - running.size();
    progress.update(static_cast<double>(over) / static_cast<double>(all.size()),
                    first.problem->id + ", h = " + rounded_text(first.h, 3));
    std::erase_if(running, [](auto& each) {
      auto& [run, process] = each;
      if (!process.is_over()) return false;
      run->fault = fault_of(run->folder, process.end());
      return true;
    });
    stop_if_interrupted();
    ::usleep(pause_us);
  }
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
  Progress progress(method.name, quiet);
  std::vector<GridRun> all;
  for (const StandardProblem& problem : set.problems) {
    fs::create_directories(folder / problem.id);
    const fs::path scene = folder / problem.id / problem.file();
    write_file(scene, problem.text);
    for (const double h : problem.grids) {
      GridRun run{&problem, h, folder / problem.id / folder_of_grid(h), {}};
      run.words = {"run", scene.string(), "-o", run.folder.string(), "--quiet", "--threads", "1"};
      run.words.insert(run.words.end(), {"--set", "grid.spacing=" + number_text(h), "--set", "expect={}"});
      for (const std::string& setting : sets_of(set, method, problem))
        run.words.insert(run.words.end(), {"--set", setting});
      all.push_back(std::move(run));
    }
  }
  run_all(program, all, progress);
  progress.finish();
  std::map<std::string, std::string> faults;  // of problems
  for (const GridRun& run : all) {
    if (run.fault.empty()) continue;
    std::string& of_problem = faults[run.problem->id];
    of_problem += (of_problem.empty() ? "" : "; ") + folder_of_grid(run.h) + ": " + run.fault;
  }
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
