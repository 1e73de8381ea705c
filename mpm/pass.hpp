// SPDX-License-Identifier: BSD-3-Clause
// A step is a list of passes; a pass is data until it is bound to a state.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mpm/columns.hpp"
#include "mpm/instant.hpp"
#include "mpm/state.hpp"

namespace assay::mpm {

/// What is known of a pass without running it.
struct PassInfo {
  std::string name;
  std::string doc;            ///< one line
  std::string called_for_by;  ///< scene key
  std::vector<Column> reads, writes;
  std::vector<std::string> grid_fields;  ///< that it touches
  bool once = false;                     ///< before the first step alone
};

using Kernel = std::function<void(const Instant&)>;

template <int Dim>
struct Pass : PassInfo {
  std::function<Kernel(State<Dim>&)> bind;
};

}  // namespace assay::mpm
