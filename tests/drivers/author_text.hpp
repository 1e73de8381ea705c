// SPDX-License-Identifier: BSD-3-Clause
// Two texts that are the same but for the rounding of their numbers.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

/// Words between blanks and brackets.
inline std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (std::string_view(" ,[]{}\n").find(c) != std::string_view::npos)
      words.emplace_back();
    else
      words.back() += c;
  }
  std::erase(words, "");
  return words;
}

inline void expect_same_text(const std::string& found, const std::string& wanted) {
  constexpr double rounding = 1e-14;  // of two multiplications and two divisions
  const auto a = words_in(found), b = words_in(wanted);
  ASSERT_EQ(a.size(), b.size()) << found << "\n---\n" << wanted;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const auto x = parse_number(a[k]), y = parse_number(b[k]);
    if (x && y)
      EXPECT_LE(std::abs(*x - *y), rounding * std::abs(*y)) << b[k == 0 ? 0 : k - 1] << " " << b[k];
    else
      EXPECT_EQ(a[k], b[k]);
  }
}

}  // namespace assay::drivers
