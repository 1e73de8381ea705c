// SPDX-License-Identifier: BSD-3-Clause
// Of models that do not turn with the body: which tensor does not, and how it turns instead.
#pragma once

#include "harness/check/diagnosis.hpp"
#include "harness/check/verdicts.hpp"

namespace assay::check {

/// The one defect that explains what the tests of rotation have found; nothing where they have found none.
std::optional<Diagnosis> diagnose_rotation(const Verdicts& verdicts, const Evidence& evidence);

}  // namespace assay::check
