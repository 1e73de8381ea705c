// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace assay {

std::string number_text(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

std::string rounded_text(double value, int significant) {
  if (std::isnan(value)) return "nan";
  if (value == 0) return "0";  // without the sign
  std::array<char, 64> buffer;
  const auto done = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general,
                                  std::clamp(significant, 1, 17));
  return {buffer.data(), done.ptr};
}

}  // namespace assay
