// SPDX-License-Identifier: BSD-3-Clause
// `assay study`: what accuracy costs, over the cases of a study.
#include <algorithm>
#include <cstdio>
#include <set>

#include "drivers/input_error.hpp"
#include "drivers/interrupt.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/output/terminal.hpp"
#include "drivers/progress.hpp"
#include "drivers/study/analysis.hpp"
#include "drivers/study/case_list.hpp"
#include "drivers/study/runner.hpp"
#include "drivers/study/study_files.hpp"
#include "drivers/study/study_json.hpp"
#include "drivers/study/study_reader.hpp"
#include "drivers/study/study_session.hpp"
#include "drivers/study/study_text.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

namespace {

StudyFindings findings_of(const Plan& plan, const CaseStore& store) {
  std::vector<StudyCase> cases;
  for (const PlannedCase& one : plan.cases) cases.push_back(store.read(one));
  return analysed(plan, std::move(cases));
}

/// A line for every case that has ended, and the progress between them.
class Teller {
 public:
  Teller(const Plan& plan, const CaseStore& store, const StudyOptions& options)
      : plan_(plan),
        store_(store),
        speaks_(options.verbosity != Verbosity::quiet && !options.json),
        progress_("study", options.verbosity == Verbosity::quiet) {}

  void operator()(const RunnerReport& report) {
    if (report.finished && speaks_) {
      const StudyFindings words = analysed_alone(*report.finished);
      progress_.finish();
      print(case_line(words, words.cases.front(), report.done, report.total));
    }
    progress_.update(report.fraction, std::to_string(report.done) + " of " + std::to_string(report.total) +
                                          (report.running ? ": " + report.running->label : "") +
                                          (report.waits ? ", which another study runs" : ""));
  }

 private:
  StudyFindings analysed_alone(const PlannedCase& one) const {
    Plan alone;
    alone.study = plan_.study;
    alone.study.expect.clear();
    alone.cases = {one};
    alone.cases.front().base.reset();
    return analysed(alone, {store_.read(alone.cases.front())});
  }

  const Plan& plan_;
  const CaseStore& store_;
  bool speaks_;
  Progress progress_;
};

/// What is said before cases are run, on standard error.
void warn_of_earlier(const Plan& plan, const CaseStore& store, const StudyOptions& options) {
  if (options.resume || options.verbosity == Verbosity::quiet) return;
  std::size_t finished = 0;
  std::set<std::string> keys;  // a case that is planned twice is run once, by the shard that it is in first
  for (const PlannedCase& one : plan.cases) {
    const bool first = keys.insert(one.key).second;
    finished += first && options.shard.holds(one.number) && store.state_of(one.key) == CaseState::finished ? 1 : 0;
  }
  if (finished > 0) {
    std::fprintf(stderr, "warning: %zu finished %s run again; --resume keeps %s\n", finished,
                 finished == 1 ? "case is" : "cases are", finished == 1 ? "it" : "them");
  }
}

void say_what_was_kept(const RunnerSummary& summary, const StudyOptions& options) {
  if (options.verbosity == Verbosity::quiet) return;
  if (summary.kept > 0) std::fprintf(stderr, "%zu finished cases were kept\n", summary.kept);
  if (summary.torn > 0)
    std::fprintf(stderr, "warning: %zu torn %s run again\n", summary.torn,
                 summary.torn == 1 ? "case was" : "cases were");
}

Plan planned(const StudyOptions& options) {
  Study study = read_study(options.study);
  watch_interrupts();
  Progress progress("reading the scenes", options.verbosity == Verbosity::quiet);
  return plan_of(std::move(study), [&](double fraction) {
    stop_if_interrupted();
    progress.update(fraction);
  });
}

/// Says why cases may be missing that someone believes to have run.
void warn_of_strangers(const Plan& plan, const std::vector<CaseStore>& stores, const StudyOptions& options) {
  std::set<std::string> keys;
  for (const PlannedCase& one : plan.cases) keys.insert(one.key);
  std::size_t strangers = 0;
  for (const CaseStore& store : stores) strangers += store.finished_besides(keys);
  if (strangers == 0 || options.verbosity == Verbosity::quiet) return;  // without reading what has finished
  const auto is_missing = [&](const PlannedCase& one) {
    return one.invalid.empty() && stores.front().state_of(one.key) == CaseState::missing;
  };
  if (std::none_of(plan.cases.begin(), plan.cases.end(), is_missing)) return;
  std::fprintf(stderr,
               "warning: cases are missing, and %zu finished %s to another key: another program, library, scene or "
               "number of threads\n",
               strangers, strangers == 1 ? "one belongs" : "ones belong");
}

/// What other folders have of the cases that are not finished here.
void gather(const Plan& plan, const CaseStore& store, const StudyOptions& options) {
  std::vector<CaseStore> others;
  for (const std::string& from : options.from) {
    std::error_code code;
    if (!std::filesystem::is_directory(from, code))
      throw InputError({}, "assay study", "--from: no such folder: '" + one_line(from, 200) + "'");
    others.emplace_back(from);
  }
  std::size_t torn = 0;
  for (const PlannedCase& one : plan.cases) {
    const auto state = [&](const CaseStore& where) { return where.state_of(one.key); };
    const auto take = [&](CaseState wanted) {
      return std::any_of(others.begin(), others.end(),
                         [&](const CaseStore& from) { return store.take(one, from, wanted); });
    };
    stop_if_interrupted();
    if (!one.invalid.empty() || state(store) == CaseState::finished || take(CaseState::finished)) continue;
    if (state(store) == CaseState::crashed || take(CaseState::crashed)) continue;
    if (state(store) == CaseState::stopped || take(CaseState::stopped)) continue;
    const bool is_torn = state(store) == CaseState::torn ||
                         std::any_of(others.begin(), others.end(),
                                     [&](const CaseStore& from) { return state(from) == CaseState::torn; });
    torn += is_torn ? 1 : 0;
  }
  if (torn > 0 && options.verbosity != Verbosity::quiet)
    std::fprintf(stderr, "warning: %zu torn %s not trusted; run the study again with --resume\n", torn,
                 torn == 1 ? "case is" : "cases are");
  others.insert(others.begin(), store);
  warn_of_strangers(plan, others, options);
}

int conclude(const Plan& plan, const CaseStore& store, const StudyOptions& options) {
  const StudyFindings findings = findings_of(plan, store);
  stop_if_interrupted();
  write_study(findings, store, options.out);
  if (options.json) {
    print_json(study_json(findings));
  } else if (options.verbosity != Verbosity::quiet) {
    print(study_text(findings, options.out));
  } else if (!findings.holds()) {
    print(contradiction_text(findings));
  }
  return findings.holds() ? 0 : 1;
}

}  // namespace

int study(const StudyOptions& options) {
  const Plan plan = planned(options);
  const CaseStore store(options.out);
  if (options.list) {
    options.json ? print_json(list_json(plan, store)) : print(list_text(plan, store));
    return 0;
  }
  OutputFolder::refuse_another_kind(options.out, study_file_names());  // not after hours of work
  if (options.merge) {
    gather(plan, store, options);
    return conclude(plan, store, options);
  }
  const StudySession session(options.out, plan.study.sha256, options.resume, options.shard.count > 1);
  if (session.begun_by().empty()) {
    warn_of_earlier(plan, store, options);
  } else if (options.verbosity != Verbosity::quiet) {
    std::fprintf(stderr, "another study runs in this folder (%s began): they share its cases\n",
                 session.begun_by().c_str());
  }
  if (session.resumes()) warn_of_strangers(plan, {store}, options);
  Teller teller(plan, store, options);
  RunnerOptions how;
  if (!options.program.empty()) how.program = options.program;
  how.jobs = options.jobs, how.resume = session.resumes(), how.shard = options.shard;
  how.session = &session;
  const RunnerSummary summary = run_cases(plan, store, how, [&](const RunnerReport& report) { teller(report); });
  say_what_was_kept(summary, options);
  if (options.shard.count == 1) return conclude(plan, store, options);
  if (options.verbosity != Verbosity::quiet) {
    print("shard " + std::to_string(options.shard.index) + "/" + std::to_string(options.shard.count) + ": " +
          std::to_string(summary.run + summary.kept) + " cases; when all shards are done: assay study " +
          one_line(options.study) + " -o " + one_line(options.out) + " --merge\n");
  }
  return 0;
}

}  // namespace assay::drivers
