// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/runner.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <list>
#include <set>

#include "adapters/process/shortage.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

constexpr useconds_t look_again_us = 3000;
constexpr double steps_of_setup = 3e5;  ///< particle-steps that take as long as the set-up of a run, about

class Runner {
 public:
  Runner(const Plan& plan, const CaseStore& store, const RunnerOptions& options,
         const std::function<void(const RunnerReport&)>& tell)
      : plan_(plan), store_(store), options_(options), tell_(tell) {
    choose();
  }

  RunnerSummary run() {
    run_side_by_side();
    for (const PlannedCase* one : alone_) {
      const auto lock = lock_of(*one);
      if (lock && !kept(*one)) run_alone(*one);
    }
    for (const PlannedCase* one : elsewhere_) wait_for(*one);
    return summary_;
  }

 private:
  struct Running {
    const PlannedCase* one;
    CaseLock lock;  ///< goes after the process
    CaseProcess process;
  };

  /// The cases of the shard that are not finished. A scene that stands twice in the study is run once, by the shard of
  /// the first.
  void choose() {
    std::set<std::string> keys;
    for (const PlannedCase& one : plan_.cases) {
      if (!one.invalid.empty() || !keys.insert(one.key).second || !options_.shard.holds(one.number)) continue;
      ++report_.total;
      stop_if_interrupted();
      const CaseState state = store_.state_of(one.key);
      if (state == CaseState::torn) ++summary_.torn;
      if (options_.resume && need_not_run(one, state)) {
        ++summary_.kept, ++report_.done;
        continue;
      }
      (one.timed ? alone_ : together_).push_back(&one);
      work_ += work_of(one);
    }
    std::ranges::stable_sort(together_, [](const PlannedCase* a, const PlannedCase* b) {
      return a->particle_steps > b->particle_steps;  // the long ones first: none is left over at the end
    });
  }

  /// Finished, and timed where that is asked for; or stopped when it had no less time than now.
  bool need_not_run(const PlannedCase& one, CaseState state) const {
    if (state == CaseState::finished) return !one.timed || store_.is_timed(one.key);
    const double limit = plan_.study.case_seconds;
    return state == CaseState::stopped && limit > 0 && limit <= store_.limit_of(one.key);
  }

  double work_of(const PlannedCase& one) const {
    return (one.particle_steps + steps_of_setup) * (one.timed ? plan_.study.timing.repeat : 1);
  }

  /// The first run of a case leaves its result; a repeat what its clock says.
  CaseProcess started(const PlannedCase& one, const fs::path& scene, const fs::path& folder, bool is_repeat) const {
    std::vector<std::string> arguments{
        "run", scene.string(), "-o", folder.string(), "--threads", std::to_string(one.threads), "--quiet"};
    if (is_repeat) arguments.insert(arguments.end(), {"--set", "output.pictures=false"});
    return CaseProcess(options_.program, arguments, plan_.study.case_seconds);
  }

  /// None where another study runs the case: it is waited for at the end.
  std::optional<CaseLock> lock_of(const PlannedCase& one) {
    auto lock = store_.lock(one);
    if (!lock) elsewhere_.push_back(&one);
    return lock;
  }

  /// Whether another study has finished it since this one began, or since the session did; and with what.
  bool kept(const PlannedCase& one) {
    const CaseState state = store_.state_of(one.key);
    const bool ended =
        state != CaseState::missing && state != CaseState::torn && (!one.timed || store_.is_timed(one.key));
    const bool here = ended && options_.session && options_.session->has_seen(store_.record_of(one.key));
    if (!here && !(options_.resume && need_not_run(one, state))) return false;
    keep(one);
    return true;
  }

  void keep(const PlannedCase& one) {
    ++summary_.kept, ++report_.done;
    done_work_ += work_of(one);
    tell(&one, nullptr);
  }

  /// What another study has finished meanwhile is kept; what it has left is run.
  void wait_for(const PlannedCase& one) {
    report_.waits = true;
    for (;;) {
      const auto lock = store_.lock(one);
      if (lock) {
        report_.waits = false;
        if (need_not_run(one, store_.state_of(one.key))) return keep(one);
        if (!kept(one)) run_alone(one);
        return;
      }
      tell(nullptr, &one);
      stop_if_interrupted();
      ::usleep(10 * look_again_us);
    }
  }

  void tell(const PlannedCase* finished, const PlannedCase* running) {
    report_.fraction = work_ > 0 ? done_work_ / work_ : 1;
    report_.finished = finished, report_.running = running;
    if (tell_) tell_(report_);
  }

  /// Who dies because the processor time of each process is limited tells nothing of its case.
  static void refuse_used_up_time(const fs::path& folder, const ProcessEnd& end) {
    const std::string limit = adapters::processor_limit();
    const bool by_signal = end.status == 128 + SIGXCPU || end.status == 128 + SIGKILL;
    const bool says_so = end.status == 3 && end.last_line.find(limit) != std::string::npos;
    if (!limit.empty() && (by_signal || says_so))
      throw SystemError(folder.string() + ": " + limit + ", which is used up");
  }

  /// What the end of a first run means. Throws SystemError where it could not write its results.
  CaseRecord record_of(const PlannedCase& one, const ProcessEnd& end) const {
    stop_if_interrupted();
    const fs::path folder = store_.folder_of(one.key);
    CaseRecord record;
    record.stopped = end.stopped;
    record.limit_s = end.stopped ? plan_.study.case_seconds : 0;
    if (end.stopped) return record;
    constexpr std::size_t most = 380;  // of a long line the beginning is known
    if (end.status == 3 && end.last_line.starts_with(one_line(folder.string()).substr(0, most)))
      throw SystemError(end.last_line);
    refuse_used_up_time(folder, end);
    std::error_code error;
    if (end.status > 1 || !fs::is_regular_file(folder / "result.json", error)) {
      record.crashed = "the run ended with status " + std::to_string(end.status) +
                       (end.last_line.empty() ? "" : ": " + end.last_line);
    }
    return record;
  }

  static void add_reading(const fs::path& folder, const ProcessEnd& end, ClockReadings& clock) {
    const auto step = figure_of(folder / "result.json", "step_cpu_s"),
               wall = figure_of(folder / "result.json", "wall_s");
    if (!step || !wall) return;
    clock.step_s.push_back(*step);
    clock.wall_s.push_back(*wall);
    clock.cpu_s.push_back(end.cpu_s);
    clock.others.push_back(end.others);
  }

  void finish(const PlannedCase& one, const ProcessEnd& end, CaseRecord record) {
    record.clock.machine = machine_name();
    if (record.clock.step_s.empty()) add_reading(store_.folder_of(one.key), end, record.clock);
    store_.finish(one, record);
    ++summary_.run, ++report_.done;
    done_work_ += work_of(one);
    tell(&one, nullptr);
  }

  void run_side_by_side() {
    std::list<Running> running;
    int threads = 0;
    for (std::size_t next = 0; next < together_.size() || !running.empty();) {
      while (next < together_.size() && (running.empty() || threads + together_[next]->threads <= options_.jobs)) {
        const PlannedCase& one = *together_[next++];
        auto lock = lock_of(one);
        if (!lock || kept(one)) continue;
        const fs::path scene = store_.begin(one);
        running.push_back({&one, std::move(*lock), started(one, scene, scene.parent_path(), false)});
        threads += one.threads;
        tell(nullptr, &one);
      }
      if (running.empty()) continue;
      const auto over = std::ranges::find_if(running, [](Running& each) { return each.process.is_over(); });
      if (over == running.end()) {
        stop_if_interrupted();
        ::usleep(look_again_us);
        continue;
      }
      const PlannedCase& one = *over->one;
      finish(one, over->process.end(), record_of(one, over->process.end()));
      threads -= one.threads;
      running.erase(over);
    }
  }

  ProcessEnd waited_for(CaseProcess process) const {
    while (!process.is_over()) {
      stop_if_interrupted();
      ::usleep(look_again_us);
    }
    return process.end();
  }

  void run_alone(const PlannedCase& one) {
    tell(nullptr, &one);
    const fs::path scene = store_.begin(one), folder = scene.parent_path(), repeat = folder / "repeat";
    const ProcessEnd first = waited_for(started(one, scene, folder, false));
    CaseRecord record = record_of(one, first);
    record.clock.alone = one.timed;
    if (one.timed && record.crashed.empty() && !record.stopped) {
      add_reading(folder, first, record.clock);
      double seconds = first.wall_s;
      for (int k = 1; k < plan_.study.timing.repeat && seconds < plan_.study.timing.seconds; ++k) {
        const ProcessEnd end = waited_for(started(one, scene, repeat, true));
        stop_if_interrupted();
        if (end.stopped || end.status > 1) break;  // and the result there is that of the one before
        add_reading(repeat, end, record.clock);
        seconds += end.wall_s;
      }
      std::error_code error;
      fs::remove_all(repeat, error);
    }
    finish(one, first, std::move(record));
  }

  const Plan& plan_;
  const CaseStore& store_;
  const RunnerOptions& options_;
  const std::function<void(const RunnerReport&)>& tell_;
  std::vector<const PlannedCase*> together_, alone_;
  std::vector<const PlannedCase*> elsewhere_;  ///< another study was running them
  RunnerReport report_;
  RunnerSummary summary_;
  double work_ = 0, done_work_ = 0;
};

}  // namespace

RunnerSummary run_cases(const Plan& plan, const CaseStore& store, const RunnerOptions& options,
                        const std::function<void(const RunnerReport&)>& tell) {
  return Runner(plan, store, options, tell).run();
}

}  // namespace assay::drivers
