// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/range.hpp"

#include <cmath>

#include "harness/numeric/number_text.hpp"

namespace assay {

std::string Range::text() const {
  const bool below = std::isfinite(upper), above = std::isfinite(lower);
  const std::string low = number_text(lower), high = number_text(upper);
  if (above && below && !lower_open && !upper_open) return "from " + low + " to " + high;
  std::string text;
  if (above) text = (lower_open ? "greater than " : "at least ") + low;
  if (below) text += (above ? " and " : "") + std::string(upper_open ? "less than " : "at most ") + high;
  return text;
}

bool Range::holds(double value) const {
  return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
}

}  // namespace assay
