// SPDX-License-Identifier: BSD-3-Clause
// Sentences on a terminal.
#pragma once

#include <string>

namespace assay::drivers {

/// The words of a text on lines of at most `width` columns: `first` begins the first line, `rest` the others. Ends with
/// a newline. A word that is longer than a line stands alone on one.
std::string wrapped(const std::string& text, const std::string& first, const std::string& rest, std::size_t width = 80);

/// The beginning of a sentence, cut between words: where it is longer than `length`, " ..." follows.
std::string cut_text(const std::string& text, std::size_t length);

}  // namespace assay::drivers
