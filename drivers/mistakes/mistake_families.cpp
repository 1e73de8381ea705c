// SPDX-License-Identifier: BSD-3-Clause
// The files of drivers/mistakes/kinds.
#include "drivers/mistakes/mistake_family.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

#define ASSAY_MISTAKE(NAME) MistakeFamily mistake_##NAME();
#include "mistakes.inc"
#undef ASSAY_MISTAKE

const std::vector<MistakeFamily>& mistake_families() {
  static const std::vector<MistakeFamily> all{
#define ASSAY_MISTAKE(NAME) mistake_##NAME(),
#include "mistakes.inc"
#undef ASSAY_MISTAKE
  };
  return all;
}

std::string times_words(double factor) { return rounded_text(factor, 3) + " times"; }

}  // namespace assay::drivers
