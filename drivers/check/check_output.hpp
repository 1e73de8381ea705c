// SPDX-License-Identifier: BSD-3-Clause
// Where the findings of `check` go.
#pragma once

#include <string>

#include "drivers/check/check.hpp"

namespace assay::drivers {

/// Throws InputError where a file of them would replace one that was read.
void refuse_inputs_as_outputs(const CheckOptions& options);

/// What was found first, on standard output: the text, or what --json -, --junit - or --markdown - asks for. Then the
/// files, whatever becomes of them. Throws SystemError.
void tell(const CheckOptions& options, const std::string& text, const std::string& json, const std::string& junit,
          const std::string& markdown = {});

}  // namespace assay::drivers
