// SPDX-License-Identifier: BSD-3-Clause
// `assay study --list`: the cases, for programs that share them out.
#pragma once

#include <string>

#include "drivers/study/case_store.hpp"
#include "drivers/study/plan.hpp"

namespace assay::drivers {

/// One line a case, fields divided by tabulators: number, key, state (finished, missing, torn, crashed, stopped, n/a),
/// particle-steps expected, label.
std::string list_text(const Plan& plan, const CaseStore& store);

/// The same as JSON, with the values on the axes.
std::string list_json(const Plan& plan, const CaseStore& store);

}  // namespace assay::drivers
