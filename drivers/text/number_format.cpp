// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/number_format.hpp"

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

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
