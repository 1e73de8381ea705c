// SPDX-License-Identifier: BSD-3-Clause
// Characters that are easily taken for others: of word processors, of other scripts, of formulas in a paper.
#pragma once

#include <string>
#include <string_view>

namespace assay::drivers {

/// The text with what is meant in the place of each character that is easily taken for another one.
std::string as_meant(std::string_view text);

/// "U+2212 stands where '-' belongs": the first such character; empty without any. `word` is what was meant, where that
/// is known: the '_' of its keys is written as a dash as well.
std::string lookalike(std::string_view text, std::string_view word = {});

/// The same of marks alone, such as brackets, colons and quotes: letters of other scripts are text.
std::string lookalike_mark(std::string_view text);

}  // namespace assay::drivers
