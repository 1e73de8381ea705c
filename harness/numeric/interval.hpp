// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace assay {

struct Interval {
  double lower = 0, upper = 0;
  double width() const { return upper - lower; }
};

}  // namespace assay
