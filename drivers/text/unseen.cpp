// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/unseen.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <span>

namespace assay::drivers {

namespace {

struct Named {
  std::uint32_t first, last;
  const char* name;
};

constexpr Named blanks[] = {{0x00A0, 0x00A0, "no-break space"},     {0x2000, 0x2001, "quad"},
                            {0x2002, 0x2002, "en space"},           {0x2003, 0x2003, "em space"},
                            {0x2004, 0x2006, "part of em space"},   {0x2007, 0x2007, "figure space"},
                            {0x2008, 0x2008, "punctuation space"},  {0x2009, 0x2009, "thin space"},
                            {0x200A, 0x200A, "hair space"},         {0x202F, 0x202F, "narrow no-break space"},
                            {0x205F, 0x205F, "mathematical space"}, {0x3000, 0x3000, "ideographic space"},
                            {0x1680, 0x1680, "ogham space"},        {0x2800, 0x2800, "blank of braille"}};

constexpr Named without_width[] = {{0x00AD, 0x00AD, "soft hyphen"},
                                   {0x034F, 0x034F, "grapheme joiner"},
                                   {0x115F, 0x1160, "Hangul filler"},
                                   {0x17B4, 0x17B5, "inherent vowel"},
                                   {0x180E, 0x180E, "vowel separator"},
                                   {0x200B, 0x200B, "zero width space"},
                                   {0x200C, 0x200C, "zero width non-joiner"},
                                   {0x200D, 0x200D, "zero width joiner"},
                                   {0x2060, 0x2060, "word joiner"},
                                   {0x2061, 0x2064, "invisible operator"},
                                   {0x3164, 0x3164, "Hangul filler"},
                                   {0xFE00, 0xFE0F, "variation selector"},
                                   {0xFEFF, 0xFEFF, "byte order mark"},
                                   {0xFFA0, 0xFFA0, "Hangul filler"},
                                   {0x1D173, 0x1D17A, "mark of musical notation"},
                                   {0xFFF9, 0xFFFB, "annotation mark"},
                                   {0xE0000, 0xE007F, "tag"}};

/// A terminal obeys them.
constexpr Named steering[] = {{0x09, 0x09, "tab"},
                              {0x0A, 0x0A, "line break"},
                              {0x0D, 0x0D, "carriage return"},
                              {0x1B, 0x1B, "escape"},
                              {0x00, 0x1F, "control character"},
                              {0x7F, 0x9F, "control character"},
                              {0x061C, 0x061C, "Arabic letter mark"},
                              {0x200E, 0x200E, "left-to-right mark"},
                              {0x200F, 0x200F, "right-to-left mark"},
                              {0x2028, 0x2028, "line separator"},
                              {0x2029, 0x2029, "paragraph separator"},
                              {0x202A, 0x202E, "mark of the direction of writing"},
                              {0x2066, 0x2069, "mark of the direction of writing"}};

const char* name_in(std::span<const Named> list, std::uint32_t code) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Named& n) { return n.first <= code && code <= n.last; });
  return found == list.end() ? nullptr : found->name;
}

bool is_unseen(std::uint32_t code) {
  return name_in(steering, code) || name_in(blanks, code) || name_in(without_width, code);
}

/// The text with what `instead` gives in the place of a character, unless that is empty; a question mark for a byte
/// that is no UTF-8.
std::string replaced(std::string_view text, const auto& instead) {
  std::string out;
  for_each_character(text, [&](std::uint32_t code, std::string_view bytes) {
    const std::string other = code == no_character ? "?" : instead(code);
    out += other.empty() ? bytes : other;
  });
  return out;
}

std::string written(std::string_view text, bool breaks, const auto& is_written) {
  return replaced(text, [&](std::uint32_t code) -> std::string {
    if (!breaks && (code == '\t' || code == '\n' || code == '\r')) return " ";
    return is_written(code) ? "<" + number_of(code) + ">" : "";
  });
}

std::string note_of(std::uint32_t code) {
  const char* blank = name_in(blanks, code);
  const char* other = name_in(steering, code);
  if (!other) other = name_in(without_width, code);
  if (!blank && !other) return {};
  return number_of(code) + ", " + (blank ? blank : other) +
         ", which cannot be seen: " + (blank ? "write a blank in its place" : "delete it");
}

/// Marks that are meant, and the characters that are easily taken for them.
struct Lookalikes {
  const char* meant;
  std::u32string_view codes;
};

constexpr Lookalikes lookalikes[] = {{"\"", U"\u00ab\u00bb\u201c\u201d\u201e\u2033"},
                                     {".", U"\u00b7\u066b\u22c5\u3002"},
                                     {"*", U"\u00d7\u2217"},
                                     {",", U"\u060c\u3001"},
                                     {"-", U"\u2010\u2011\u2012\u2013\u2014\u2015\u2212\ufe58\ufe63"},
                                     {"'", U"\u2018\u2019\u201a\u2032"},
                                     {"...", U"\u2026"},
                                     {"/", U"\u2044\u2215"},
                                     {":", U"\u2236\ua789"},
                                     {"~", U"\u223c"}};

/// Letters of other scripts, each before the one that is meant.
constexpr std::u32string_view foreign_letters =
    U"\u0130I\u0399I\u0406I\u0131i\u03b9i\u0456i\u0391A\u0410A\u0392B\u0412B\u0395E\u0415E\u0396Z\u0397H"
    U"\u041dH\u039aK\u041aK\u039cM\u041cM\u039dN\u039fO\u041eO\u03a1P\u0420P\u03a4T\u0422T\u03a5Y\u0423Y"
    U"\u03a7X\u0425X\u03bdv\u03bfo\u043eo\u03c1p\u0440p\u0405S\u0408J\u0421C\u0430a\u0435e\u0441c\u0443y"
    U"\u0445x\u0455s\u0458j\u04bbh\u0501d\u051bq\u051dw";

/// The zeros of other scripts, and of subscripts.
constexpr std::array<std::uint32_t, 19> zeros{0x0660, 0x06F0, 0x07C0, 0x0966, 0x09E6, 0x0A66, 0x0AE6,
                                              0x0B66, 0x0BE6, 0x0C66, 0x0CE6, 0x0D66, 0x0E50, 0x0ED0,
                                              0x0F20, 0x1040, 0x17E0, 0x1810, 0x2080};

/// Characters of formulas: alphabets of capitals and small letters, then rows of digits, each in other letters.
constexpr std::uint32_t first_alphabet = 0x1D400, end_of_alphabets = 0x1D6A4, first_digits = 0x1D7CE,
                        end_of_digits = 0x1D800;

/// As wide as an ideograph.
constexpr std::uint32_t first_wide = 0xFF01, last_wide = 0xFF5E;

/// What is easily meant by a character; empty where nothing else is.
std::string meant_by(std::uint32_t code) {
  const auto after = [](char first, std::uint32_t steps) {
    return std::string(1, static_cast<char>(first + static_cast<char>(steps)));
  };
  for (const auto& [meant, codes] : lookalikes) {
    if (codes.find(code) != codes.npos) return meant;
  }
  for (std::size_t k = 0; k < foreign_letters.size(); k += 2) {
    if (foreign_letters[k] == code) return std::string(1, static_cast<char>(foreign_letters[k + 1]));
  }
  for (const std::uint32_t zero : zeros) {
    if (zero <= code && code < zero + 10) return after('0', code - zero);
  }
  if (first_wide <= code && code <= last_wide) return after('!', code - first_wide);
  if (first_digits <= code && code < end_of_digits) return after('0', (code - first_digits) % 10);
  if (first_alphabet <= code && code < end_of_alphabets) {
    const std::uint32_t letter = (code - first_alphabet) % 52;
    return letter < 26 ? after('A', letter) : after('a', letter - 26);
  }
  return {};
}

std::string words_of(std::uint32_t code, const std::string& meant) {
  return number_of(code) + " stands where " + (meant == "'" ? "\"'\"" : "'" + meant + "'") + " belongs";
}

}  // namespace

std::size_t character_size(std::string_view text, std::uint32_t& code) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : (first & 0xF0u) == 0xE0       ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  code = length == 1 ? first : first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return 0;
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};  // what is longer than it need be is no UTF-8
  return code < least[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000) ? 0 : length;
}

void for_each_character(std::string_view text, const std::function<void(std::uint32_t, std::string_view)>& take) {
  for (std::size_t at = 0; at < text.size();) {
    std::uint32_t code = 0;
    std::size_t length = character_size(text.substr(at), code);
    if ((code & 0xFFFE) == 0xFFFE) length = 0;  // never a character: no XML may hold U+FFFE or U+FFFF
    take(length == 0 ? no_character : code, text.substr(at, std::max<std::size_t>(length, 1)));
    at += std::max<std::size_t>(length, 1);
  }
}

std::string number_of(std::uint32_t code) {
  char text[16];
  std::snprintf(text, sizeof text, "U+%04X", static_cast<unsigned>(code));
  return text;
}

std::string printable(std::string_view text) {
  return written(text, false, [](std::uint32_t code) { return name_in(steering, code) != nullptr; });
}

std::string utf8(std::string_view text) {
  return replaced(text, [](std::uint32_t) { return std::string(); });
}

std::string with_unseen_written(std::string_view text) { return written(text, false, is_unseen); }

std::string without_commands(std::string_view lines, const std::string& open, const std::string& close) {
  return replaced(lines, [&](std::uint32_t code) -> std::string {
    const bool layout = code == '\n' || code == '\t';
    return !layout && name_in(steering, code) ? open + number_of(code).substr(2) + close : "";
  });
}

std::string shown(std::string_view text, std::size_t limit) { return written(cut(text, limit), true, is_unseen); }

std::string unseen_note(std::string_view written) {
  const std::string_view mark = "<U+";
  for (std::size_t at = written.find(mark); at != written.npos; at = written.find(mark, at + 1)) {
    std::uint32_t code = 0;
    const char* const last = written.data() + written.size();
    const auto [end, error] = std::from_chars(written.data() + at + mark.size(), last, code, 16);
    if (error != std::errc() || end == last || *end != '>') continue;
    if (const std::string note = note_of(code); !note.empty()) return "holds " + note;
  }
  return {};
}

std::string without_unseen(std::string_view text) {
  std::string out;
  for_each_character(text, [&](std::uint32_t code, std::string_view bytes) {
    if (!is_unseen(code)) out += bytes;
  });
  return out;
}

std::string cut(std::string_view text, std::size_t limit) {
  std::string line(text.substr(0, limit));
  if (text.size() <= limit) return line;
  while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xC0u) == 0x80u) line.pop_back();
  if (!line.empty() && (static_cast<unsigned char>(line.back()) & 0x80u) != 0) line.pop_back();  // no half character
  return line + "...";
}

std::string as_meant(std::string_view text) {
  std::string meant;
  for_each_character(text, [&](std::uint32_t code, std::string_view bytes) {
    const std::string other = meant_by(code);
    meant += other.empty() ? std::string(bytes) : other;
  });
  return meant;
}

std::string lookalike(std::string_view text, std::string_view word) {
  std::string found, read;
  for_each_character(text, [&](std::uint32_t code, std::string_view bytes) {
    std::string meant = meant_by(code);
    const bool underscore = meant == "-" && read.size() < word.size() && word[read.size()] == '_';
    if (underscore) meant = "_";
    if (found.empty() && !meant.empty()) found = words_of(code, meant);
    read += meant.empty() ? std::string(bytes) : meant;
  });
  return found;
}

std::string lookalike_mark(std::string_view text) {
  std::string found;
  for_each_character(text, [&](std::uint32_t code, std::string_view) {
    const std::string meant = meant_by(code);
    const bool is_mark = !meant.empty() && std::ispunct(static_cast<unsigned char>(meant[0])) != 0;
    if (found.empty() && is_mark) found = words_of(code, meant);
  });
  return found;
}

}  // namespace assay::drivers
