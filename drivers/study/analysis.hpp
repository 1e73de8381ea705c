// SPDX-License-Identifier: BSD-3-Clause
// From the cases of a study to its answers: orders, fronts, digits, the budget of the error, what was expected.
#pragma once

#include "drivers/study/findings.hpp"
#include "drivers/study/plan.hpp"

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

}  // namespace assay::drivers
