// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/natural_order.hpp"

#include <algorithm>

namespace assay::drivers {

bool in_natural_order(const std::string& a, const std::string& b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[k])) {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i, ++k;
      continue;
    }
    const auto number = [&](const std::string& text, std::size_t& at) {
      const std::size_t begin = at;
      while (at < text.size() && is_digit(text[at])) ++at;
      const std::size_t zeros = std::min(text.find_first_not_of('0', begin), at);
      return text.substr(zeros, at - zeros);
    };
    const std::string n = number(a, i), m = number(b, k);
    if (n != m) return n.size() != m.size() ? n.size() < m.size() : n < m;
  }
  return a.size() - i < b.size() - k;
}

}  // namespace assay::drivers
