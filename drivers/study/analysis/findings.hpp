// SPDX-License-Identifier: BSD-3-Clause
// What a study found: the content of study.json, which `fields` name (drivers/result/fields.hpp), of the tables and of
// the report.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "drivers/result/fields.hpp"
#include "drivers/study/plan/study.hpp"
#include "drivers/study/run/study_case.hpp"
#include "harness/numeric/convergence.hpp"

namespace assay::drivers {

/// The cases that differ in resolution alone.
struct StudySeries {
  std::string name;
  std::vector<std::size_t> cases;  ///< indices into StudyFindings::cases, the coarsest first
  std::vector<Figure> pairwise;    ///< observed order from the case before; the first is absent
  std::optional<FittedOrder> fit;  ///< over all completed resolutions; absent of fewer than two
  using Range = AsymptoticRange;
  Range asymptotic = Range::unknown;
  std::string sentence;     ///< of that judgement, with the orders
  Figure published = {};    ///< an order that others have found
  std::string source = {};  ///< and where

  ASSAY_FIELDS(name, cases, pairwise, fit, asymptotic, sentence, published, source)
};

/// What one more digit of accuracy costs.
struct StudyDigit {
  double error = 0;                 ///< the level: 0.1, 0.01, ...
  std::optional<std::size_t> best;  ///< the cheapest measured case that meets it; index into cases
  Figure cost;                      ///< of that case
  std::string series;               ///< the cheapest where costs are interpolated between measured resolutions
  Figure interpolated;              ///< its cost at exactly this error
  Figure factor;                    ///< interpolated cost over that of the level before

  ASSAY_FIELDS(error, best, cost, series, interpolated, factor)
};

/// One source of a run's error, found by refining it alone.
struct BudgetLine {
  std::string base;       ///< label of the run
  std::string source;     ///< "space", "time step", "sheet", "transfer"; words of the study
  std::string changed;    ///< "grid.spacing=0.025"
  Figure error, refined;  ///< the study's figure before and after
  Figure share;           ///< largest change of the L2 history over time, over the run's largest error
  std::string outcome;    ///< of the refined run

  ASSAY_FIELDS(base, source, changed, error, refined, share, outcome)
};

struct StudyExpectationOutcome {
  std::string where;  ///< label of the case or series
  ExpectationOutcome outcome;

  static void fields(auto& self, auto& archive) {
    archive("where", self.where);
    ExpectationOutcome::fields(self.outcome, archive);
  }
};

struct StudyFindings {
  std::string title, question;
  bool asks_survival = false;                   ///< which method lives through most, not what accuracy costs
  std::string error_key, cost_key, refine_key;  ///< "error.relative", "step_cpu_s", "grid.spacing" (or empty)
  std::string error_name, error_unit;           ///< "largest L2 error of u over the motion", "" or "m"
  std::string cost_name, cost_unit;             ///< "processor time of the steps", "s"
  std::vector<std::string> axes;
  std::vector<StudyCase> cases;
  std::vector<StudySeries> series;
  std::vector<std::size_t> front;       ///< by cost: indices of the cases that no other beats in error and cost
  std::vector<std::size_t> work_front;  ///< the same by particle-steps
  std::vector<StudyDigit> digits;
  std::vector<BudgetLine> budget;
  std::vector<StudyExpectationOutcome> expect;
  std::vector<std::string> warnings;
  std::vector<std::string> machines;  ///< all that cases were run on
  Provenance provenance;
  std::string study_yaml;  ///< the text of the study's file

  int count(const std::string& outcome) const;
  /// Whether a case has crashed or was stopped and nobody expected that.
  bool ended_badly(const StudyCase& one) const;
  bool holds() const;  ///< all that was expected does, no case is missing and none ended badly

  static void fields(auto& self, auto& archive) {
    ASSAY_MEMBERS(title, question);
    archive("answer", std::string(self.asks_survival ? "survival" : "cost"));
    archive.section("error", [&](auto& error) {
      error("key", self.error_key);
      error("name", self.error_name);
      error("unit", self.error_unit);
    });
    archive.section("cost", [&](auto& cost) {
      cost("key", self.cost_key);
      cost("name", self.cost_name);
      cost("unit", self.cost_unit);
    });
    archive("refine", self.refine_key);
    ASSAY_MEMBERS(axes, cases, series, front, work_front, digits, budget, expect, warnings, machines);
    archive("load", load_of(self));
    archive("provenance", self.provenance);
    archive("study", self.study_yaml);
  }
};

/// Best and worst completed case by error; none of a study without any.
std::optional<std::size_t> best_case(const StudyFindings& findings);
std::optional<std::size_t> worst_case(const StudyFindings& findings);

/// A number of result.json; absent where it is none.
Figure number_of(const StudyCase& one, const std::string& key);

/// A text on its axis; empty where the case does not stand on it.
std::string value_on(const StudyCase& one, const std::string& axis);

bool uses_exact_solution(const StudyCase& one);

/// A case whose relative error is undefined: the exact solution is zero, as of a motion that stands still.
bool is_at_rest(const StudyFindings& findings, const StudyCase& one);

/// ": the exact solution is zero in 3 cases, ..."; empty without one.
std::string rest_words(const StudyFindings& findings);

/// "1 case was", "3 cases were".
std::string cases_text(std::ptrdiff_t count);

inline constexpr const char* work_key = "work.particle_steps";

// From the cases of a study to its answers: orders, fronts, digits, the budget of the error, what was expected.

/// `cases`: of the plan, one each in its order, as they were read. Fills in their error, cost and work, and finds all
/// that follows from them.
StudyFindings analysed(const Plan& plan, std::vector<StudyCase> cases);

/// Indices of the eligible cases that no other beats or equals in both error and cost, by ascending cost. A case
/// without that cost takes no part.
std::vector<std::size_t> pareto_front(const std::vector<StudyCase>& cases, Figure StudyCase::*cost);

/// The cost at exactly that error on the straight line, in logarithms, between two neighbouring resolutions of a
/// series of eligible cases; that of its coarsest where this is better than asked. Absent where none reaches it.
Figure cost_at(const std::vector<StudyCase>& cases, const StudySeries& series, double error);

/// One line for each refined case of the plan; `cases` in the plan's order.
std::vector<BudgetLine> budget_of(const Plan& plan, const std::vector<StudyCase>& cases);

/// The largest difference between two histories (t [s], value) over the times of the first, over the largest value of
/// the first; the second is interpolated. Absent where they share no time.
Figure largest_change(const std::vector<std::array<double, 2>>& base, const std::vector<std::array<double, 2>>& other);

/// Each line for every case of its selection, or for every series that has one there. A selection without cases holds
/// nothing.
std::vector<StudyExpectationOutcome> judged_of(const Study& study, const StudyFindings& findings);

/// "error.l2_max": "largest L2 error of the displacement", "m"; a key that has no words stands for itself.
std::pair<std::string, std::string> name_and_unit(const std::string& key);

/// 10^k, the double nearest to it.
double rounded_power(int k);

}  // namespace assay::drivers
