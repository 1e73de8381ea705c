// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text, independent of the locale.
#pragma once

#include <string>

namespace assay {

/// The shortest text that reads back to the same double; "inf", "-inf", "nan" for what is not finite.
std::string number_text(double value);

/// At most `significant` (1 to 17) digits, trailing zeros dropped, "1.2e-05" where that is shorter; "nan", "inf".
std::string rounded_text(double value, int significant);

}  // namespace assay
