// SPDX-License-Identifier: BSD-3-Clause
// Characters that a reader cannot see, written out and named; and those that are easily taken for others: of word
// processors, of other scripts, of formulas in a paper.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace assay::drivers {

constexpr std::uint32_t no_character = 0xFFFFFFFFu;  ///< the code of a byte that belongs to no character of UTF-8

/// Bytes of the UTF-8 character that begins the text, which is not empty, and its code point; 0 where it is none.
std::size_t character_size(std::string_view text, std::uint32_t& code);

/// Calls take(code, bytes) for each character.
void for_each_character(std::string_view text, const std::function<void(std::uint32_t, std::string_view)>& take);

/// "U+2212".
std::string number_of(std::uint32_t code);

/// The text with blanks for tabs and line breaks. What steers a terminal (control characters, marks that turn the
/// direction of writing) is written as "<U+001B>"; what is no UTF-8 becomes a question mark.
std::string printable(std::string_view text);

/// The text with question marks for bytes that are no UTF-8.
std::string utf8(std::string_view text);

/// The same, with everything written out that cannot be seen: blanks of other kinds and what has no width, too.
std::string with_unseen_written(std::string_view text);

/// Lines as they are, but for what steers a terminal: its four hexadecimal digits between `open` and `close`.
std::string without_commands(std::string_view lines, const std::string& open, const std::string& close);

/// A user's word as it is quoted in an error: at most `limit` bytes, tabs and line breaks written out as well.
std::string shown(std::string_view text, std::size_t limit);

/// "holds U+200B, zero width space, which cannot be seen: delete it" for what is written out in the text; else empty.
std::string unseen_note(std::string_view written);

/// The text without what cannot be seen.
std::string without_unseen(std::string_view text);

/// The text up to `limit` bytes, cut between characters and marked by "...".
std::string cut(std::string_view text, std::size_t limit);

/// The text with what is meant in the place of each character that is easily taken for another one.
std::string as_meant(std::string_view text);

/// "U+2212 stands where '-' belongs": the first such character; empty without any. `word` is what was meant, where that
/// is known: the '_' of its keys is written as a dash as well.
std::string lookalike(std::string_view text, std::string_view word = {});

/// The same of marks alone, such as brackets, colons and quotes: letters of other scripts are text.
std::string lookalike_mark(std::string_view text);

}  // namespace assay::drivers
