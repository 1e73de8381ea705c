// SPDX-License-Identifier: BSD-3-Clause
// Values as YAML that readers of YAML 1.2 and of YAML 1.1 (PyYAML among them) take for the same.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

/// The shortest text that reads back to the same double. Where it has an exponent it has a point and the exponent has a
/// sign, "1.0e+22", "1.5e-8": YAML 1.1 takes 1e22 and 1.5e8 for text. ".inf", "-.inf", ".nan" for what is not finite.
std::string yaml_number(double value);

/// `text` as a YAML scalar that reads back to it: plain where every reader takes it for text, else double-quoted.
std::string yaml_scalar(const std::string& text);

/// "[a, b]".
std::string yaml_list(const std::vector<std::string>& texts);

}  // namespace assay::drivers
