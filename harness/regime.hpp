// SPDX-License-Identifier: BSD-3-Clause
// Which branch of its response a step of a material took: elastic, plastic, damaging ...
#pragma once

#include <cstdint>
#include <vector>

#include "harness/assay_material.h"

namespace assay {

/// A number that differs between branches. A scalar state variable whose unit is "regime" names the branch by its value
/// after the step. Without one, a branch is the set of scalar state variables that the step has changed: an elastic
/// step leaves an equivalent plastic strain as it was, bit for bit.
class RegimeReader {
 public:
  explicit RegimeReader(const assay_material& table);

  /// Whether the state has anything that could tell.
  bool tells() const { return !watched_.empty(); }

  /// Whether a variable of unit "regime" does.
  bool named() const { return named_; }

  /// Of one point's step, components of the state in declared order.
  std::uint64_t of(const double* state0, const double* state1) const;

 private:
  bool named_ = false;                ///< by variables of unit "regime"
  std::vector<std::size_t> watched_;  ///< components of the state
};

}  // namespace assay
