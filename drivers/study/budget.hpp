// SPDX-License-Identifier: BSD-3-Clause
// The error of a run divided into its sources, each found by refining it alone.
#pragma once

#include <vector>

#include "drivers/study/findings.hpp"
#include "drivers/study/plan.hpp"

namespace assay::drivers {

/// One line for each refined case of the plan; `cases` in the plan's order.
std::vector<BudgetLine> budget_of(const Plan& plan, const std::vector<StudyCase>& cases);

/// The largest difference between two histories (t [s], value) over the times of the first, over the largest value of
/// the first; the second is interpolated. Absent where they share no time.
Figure largest_change(const std::vector<std::array<double, 2>>& base, const std::vector<std::array<double, 2>>& other);

}  // namespace assay::drivers
