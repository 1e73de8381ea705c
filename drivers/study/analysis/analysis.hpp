// SPDX-License-Identifier: BSD-3-Clause
// From the cases of a study to its answers: orders, fronts, digits, the budget of the error, what was expected.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "drivers/study/analysis/findings.hpp"
#include "drivers/study/plan/plan.hpp"
#include "drivers/study/plan/study.hpp"

namespace assay::drivers {

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
