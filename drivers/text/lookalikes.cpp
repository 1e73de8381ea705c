// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/lookalikes.hpp"

#include <array>
#include <cctype>
#include <cstdint>

#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

struct Lookalike {
  std::uint32_t code;
  const char* meant;
};

constexpr std::array lookalikes{
    Lookalike{0x00AB, "\""}, Lookalike{0x00B7, "."},  Lookalike{0x00BB, "\""}, Lookalike{0x00D7, "*"},
    Lookalike{0x0130, "I"},  Lookalike{0x0131, "i"},  Lookalike{0x0391, "A"},  Lookalike{0x0392, "B"},
    Lookalike{0x0395, "E"},  Lookalike{0x0396, "Z"},  Lookalike{0x0397, "H"},  Lookalike{0x0399, "I"},
    Lookalike{0x039A, "K"},  Lookalike{0x039C, "M"},  Lookalike{0x039D, "N"},  Lookalike{0x039F, "O"},
    Lookalike{0x03A1, "P"},  Lookalike{0x03A4, "T"},  Lookalike{0x03A5, "Y"},  Lookalike{0x03A7, "X"},
    Lookalike{0x03B9, "i"},  Lookalike{0x03BD, "v"},  Lookalike{0x03BF, "o"},  Lookalike{0x03C1, "p"},
    Lookalike{0x0405, "S"},  Lookalike{0x0406, "I"},  Lookalike{0x0408, "J"},  Lookalike{0x0410, "A"},
    Lookalike{0x0412, "B"},  Lookalike{0x0415, "E"},  Lookalike{0x041A, "K"},  Lookalike{0x041C, "M"},
    Lookalike{0x041D, "H"},  Lookalike{0x041E, "O"},  Lookalike{0x0420, "P"},  Lookalike{0x0421, "C"},
    Lookalike{0x0422, "T"},  Lookalike{0x0423, "Y"},  Lookalike{0x0425, "X"},  Lookalike{0x0430, "a"},
    Lookalike{0x0435, "e"},  Lookalike{0x043E, "o"},  Lookalike{0x0440, "p"},  Lookalike{0x0441, "c"},
    Lookalike{0x0443, "y"},  Lookalike{0x0445, "x"},  Lookalike{0x0455, "s"},  Lookalike{0x0456, "i"},
    Lookalike{0x0458, "j"},  Lookalike{0x04BB, "h"},  Lookalike{0x0501, "d"},  Lookalike{0x051B, "q"},
    Lookalike{0x051D, "w"},  Lookalike{0x060C, ","},  Lookalike{0x066B, "."},  Lookalike{0x2010, "-"},
    Lookalike{0x2011, "-"},  Lookalike{0x2012, "-"},  Lookalike{0x2013, "-"},  Lookalike{0x2014, "-"},
    Lookalike{0x2015, "-"},  Lookalike{0x2018, "'"},  Lookalike{0x2019, "'"},  Lookalike{0x201A, "'"},
    Lookalike{0x201C, "\""}, Lookalike{0x201D, "\""}, Lookalike{0x201E, "\""}, Lookalike{0x2026, "..."},
    Lookalike{0x2032, "'"},  Lookalike{0x2033, "\""}, Lookalike{0x2044, "/"},  Lookalike{0x2212, "-"},
    Lookalike{0x2215, "/"},  Lookalike{0x2217, "*"},  Lookalike{0x2236, ":"},  Lookalike{0x223C, "~"},
    Lookalike{0x22C5, "."},  Lookalike{0x3001, ","},  Lookalike{0x3002, "."},  Lookalike{0xA789, ":"},
    Lookalike{0xFE58, "-"},  Lookalike{0xFE63, "-"}};

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
  for (const Lookalike& each : lookalikes) {
    if (each.code == code) return each.meant;
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
