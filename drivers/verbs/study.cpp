// SPDX-License-Identifier: BSD-3-Clause
// `assay study`: what accuracy costs, over the cases of a study.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <thread>

#include "drivers/command_line/verb.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/study/analysis/findings.hpp"
#include "drivers/study/analysis/study_json.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "drivers/study/plan/study_reader.hpp"
#include "drivers/study/run/case_store.hpp"
#include "drivers/study/run/runner.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct StudyOptions {
  std::string study;
  std::string out;                     ///< folder of the results
  std::string jobs_text, shard_text;   ///< as they stand on the command line
  int jobs = 1;                        ///< threads of cases that run side by side
  Shard shard = {};                    ///< the cases of this call
  bool resume = false;                 ///< finished cases stay
  bool merge = false;                  ///< nothing is run: what is there is put together
  std::vector<std::string> from = {};  ///< folders whose finished cases are taken over before
  bool list = false;                   ///< the cases, and nothing else
  bool json = false;                   ///< study.json on standard output
  Verbosity verbosity = Verbosity::normal;

  bool is_quiet() const { return verbosity == Verbosity::quiet; }
  /// On standard error.
  template <class... Values>
  void say(fmt::format_string<Values...> text, Values&&... values) const {
    if (!is_quiet()) std::fputs(fmt::format(text, std::forward<Values>(values)...).c_str(), stderr);
  }
};

StudyFindings findings_of(const Plan& plan, const CaseStore& store) {
  return analysed(plan, mapped(plan.cases, [&](const PlannedCase& one) { return store.read(one); }));
}

/// A line for every case that has ended, and the progress between them.
class Teller {
 public:
  Teller(const Plan& plan, const CaseStore& store, const StudyOptions& options)
      : plan_(plan),
        store_(store),
        speaks_(!options.is_quiet() && !options.json),
        progress_("study", options.is_quiet()) {}

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
  if (options.resume || options.is_quiet()) return;
  std::size_t finished = 0;
  std::set<std::string> keys;  // a case that is planned twice is run once, by the shard that it is in first
  for (const PlannedCase& one : plan.cases) {
    const bool first = keys.insert(one.key).second;
    finished += first && options.shard.holds(one.number) && store.state_of(one.key) == CaseState::finished ? 1 : 0;
  }
  if (finished > 0) {
    options.say("warning: {} finished {} run again; --resume keeps {}\n", finished,
                finished == 1 ? "case is" : "cases are", finished == 1 ? "it" : "them");
  }
}

Plan planned(const StudyOptions& options) {
  Study study = read_study(options.study);
  watch_interrupts();
  Progress progress("reading the scenes", options.is_quiet());
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
  if (strangers == 0 || options.is_quiet()) return;  // without reading what has finished
  const auto is_missing = [&](const PlannedCase& one) {
    return one.invalid.empty() && stores.front().state_of(one.key) == CaseState::missing;
  };
  if (std::ranges::none_of(plan.cases, is_missing)) return;
  options.say(
      "warning: cases are missing, and {} finished {} to another key: another program, library, scene or number of "
      "threads\n",
      strangers, strangers == 1 ? "one belongs" : "ones belong");
}

/// What other folders have of the cases that are not finished here.
void gather(const Plan& plan, const CaseStore& store, const StudyOptions& options) {
  std::vector<CaseStore> stores{store};  // this one and the others
  for (const std::string& from : options.from) {
    std::error_code code;
    if (!std::filesystem::is_directory(from, code))
      throw InputError({}, "assay study", "--from: no such folder: '" + one_line(from, 200) + "'");
    stores.emplace_back(from);
  }
  std::size_t torn = 0;
  for (const PlannedCase& one : plan.cases) {
    stop_if_interrupted();
    if (!one.invalid.empty()) continue;
    const bool has_ended = std::ranges::any_of(
        std::array{CaseState::finished, CaseState::crashed, CaseState::stopped}, [&](CaseState wanted) {
          return store.state_of(one.key) == wanted ||
                 std::any_of(stores.begin() + 1, stores.end(),
                             [&](const auto& from) { return store.take(one, from, wanted); });
        });
    const auto is_torn = [&](const CaseStore& where) { return where.state_of(one.key) == CaseState::torn; };
    if (!has_ended && std::ranges::any_of(stores, is_torn)) ++torn;
  }
  if (torn > 0)
    options.say("warning: {} torn {} not trusted; run the study again with --resume\n", torn,
                torn == 1 ? "case is" : "cases are");
  warn_of_strangers(plan, stores, options);
}

int conclude(const Plan& plan, const CaseStore& store, const StudyOptions& options) {
  const StudyFindings findings = findings_of(plan, store);
  stop_if_interrupted();
  write_study(findings, store, options.out);
  if (options.json) {
    print_json(study_json(findings));
  } else if (!options.is_quiet()) {
    print(study_text(findings, options.out));
  } else if (!findings.holds()) {
    print(contradiction_text(findings));
  }
  return findings.holds() ? 0 : 1;
}

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
  } else {
    options.say("another study runs in this folder ({} began): they share its cases\n", session.begun_by());
  }
  if (session.resumes()) warn_of_strangers(plan, {store}, options);
  Teller teller(plan, store, options);
  RunnerOptions how;
  how.jobs = options.jobs, how.resume = session.resumes(), how.session = &session, how.shard = options.shard;
  const RunnerSummary summary = run_cases(plan, store, how, [&](const RunnerReport& report) { teller(report); });
  if (summary.kept > 0) options.say("{} finished cases were kept\n", summary.kept);
  if (summary.torn > 0)
    options.say("warning: {} torn {} run again\n", summary.torn, summary.torn == 1 ? "case was" : "cases were");
  if (options.shard.count == 1) return conclude(plan, store, options);
  if (!options.is_quiet()) {
    print(fmt::format("shard {}/{}: {} cases; when all shards are done: assay study {} -o {} --merge\n",
                      options.shard.index, options.shard.count, summary.run + summary.kept, one_line(options.study),
                      one_line(options.out)));
  }
  return 0;
}

Shard shard_of(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const std::string after = slash == text.npos ? "" : text.substr(slash + 1);
  const std::int64_t index = parse_integer(text.substr(0, slash)).value_or(0), count = parse_integer(after).value_or(0);
  if (index < 1 || count < index || count > 100000)
    throw InputError({}, "--shard", "must be i/n with i from 1 to n, found '" + one_line(text, 60) + "'");
  return {static_cast<std::size_t>(index), static_cast<std::size_t>(count)};
}

int study_of(StudyOptions& given, Verbosity verbosity) {
  const bool runs = !given.merge && !given.list;
  if (given.merge && given.list) throw InputError("assay study: --merge and --list exclude each other");
  if (!runs && (given.resume || !given.shard_text.empty()))
    throw InputError("assay study: --merge and --list run nothing: they take no --resume and no --shard");
  if (!given.from.empty() && !given.merge) throw InputError("assay study: --from goes with --merge");
  given.out = results_folder(given.out, given.study);
  given.jobs = count_in("--jobs", given.jobs_text, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  given.shard = shard_of(given.shard_text);
  given.verbosity = verbosity;
  return study(given);
}

Act add_study_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<StudyOptions>();
  add_value(verb, "STUDY", given->study, "", "YAML file of the study", "*.yaml *.yml */")->required();
  add_value(verb, "--jobs", given->jobs_text, "N", "untimed cases at the same time (default: all cores)", "1 2 4 8 16");
  verb.app.add_flag("--resume", given->resume, "keep finished cases of an earlier run");
  add_value(verb, "--shard", given->shard_text, "i/n", "run part i of n; --merge writes the report later");
  verb.app.add_flag("--merge", given->merge, "run nothing, report on the finished cases");
  add_repeatable(verb, "--from", given->from, "DIR", "with --merge: cases of this folder too; repeatable");
  verb.app.add_flag("--list", given->list, "list the cases and run nothing");
  add_out(verb, given->out, "DIR", "folder for the results (default: results/STUDY)");
  verb.app.add_flag("--json", given->json, "print JSON instead of text");
  return [given](Verbosity verbosity) { return study_of(*given, verbosity); };
}

}  // namespace

Verb verb_study() {
  return {100, "run a scene over methods and grids: error and cost",
          "assay study configs/studies/quick.yaml -o results/quick\n"
          "  assay study big.yaml --shard 2/8 -o /shared/big\n"
          "  assay study big.yaml --merge -o /shared/big",
          add_study_arguments};
}

}  // namespace assay::drivers
