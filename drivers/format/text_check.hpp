// SPDX-License-Identifier: BSD-3-Clause
// What is checked of a text before a parser sees it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace assay::drivers {

/// Throws InputError with the place of the first fault: longer than `limit` bytes, bad UTF-8, a control character, a
/// tab in the indentation. `name` stands for the file.
void check_text(std::string_view text, const std::string& name, std::size_t limit);

/// Whether it is text of two bytes a character, with a mark of that or without.
bool is_utf16(std::string_view text);

}  // namespace assay::drivers
