// SPDX-License-Identifier: BSD-3-Clause
// The picture that answers a study's question: error against cost, both logarithmic.
#pragma once

#include "drivers/picture/drawing.hpp"
#include "drivers/study/work_precision.hpp"

namespace assay::drivers {

/// The front as a broad band; series on it in colours, named at their curves; the others thin and grey, named where a
/// pointer rests on them; cases that did not complete as crosses above, at the cost that they reached (at the left
/// end without one); guides at whole digits of accuracy with what each costs.
Drawing work_precision_plot(const StudyFindings& findings, CostAxis axis = CostAxis::cost);

}  // namespace assay::drivers
