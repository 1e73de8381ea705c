// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/number_format.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/output/numbers.hpp"

namespace assay::drivers {

std::string rounded_text(double value, int significant) {
  if (std::isnan(value)) return "nan";
  if (value == 0) return "0";  // without the sign
  std::array<char, 64> buffer;
  const auto done = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general,
                                  std::clamp(significant, 1, 17));
  return {buffer.data(), done.ptr};
}

std::string shortened(const std::string& text, int significant) {
  const auto number = parse_number(text);
  return number ? rounded_text(*number, significant) : text;
}

std::string grouped_text(std::int64_t value) {
  std::string text = std::to_string(value);
  const std::size_t first = value < 0 ? 1 : 0;
  for (std::size_t at = text.size(); at > first + 3;) text.insert(at -= 3, 1, ',');
  return text;
}

}  // namespace assay::drivers
