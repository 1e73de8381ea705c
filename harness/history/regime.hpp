// SPDX-License-Identifier: BSD-3-Clause
// Which branch of its response a step of a material took: elastic, plastic, damaging ...
#pragma once

#include <cstdint>
#include <vector>

#include "harness/assay_material.h"

namespace assay {

/// What coarse marches through a path have seen of the variables of a material's state, in declared order.
struct StateSigns {
  StateSigns() = default;
  explicit StateSigns(std::size_t variables) : changes(variables, 0), always(variables, 1), ever(variables, 0) {}
  std::vector<char> changes;  ///< in some step of a march
  std::vector<char> always;   ///< in every very short step from a reversal of the path, as a clock does
  std::vector<char> ever;     ///< in some of these, as the components of a tensor that turns
  bool any_start = false;     ///< whether there was such a step
};

/// A number that differs between branches. A scalar state variable whose unit is "regime" names the branch by its value
/// after the step. Without one, a branch is the set of scalar state variables that the step has changed: an elastic
/// step leaves an equivalent plastic strain as it was, bit for bit. Beside such a one, scalars that an elastic step
/// changes are not asked: they may be the components of a tensor that nobody has declared. Where no scalar tells, a
/// tensor may: an elastic step turns a back stress at most, and leaves its invariants.
class RegimeReader {
 public:
  RegimeReader() = default;
  explicit RegimeReader(const assay_material& table);

  /// Leaves out what changes in any step, or in an elastic one where others do not, and takes tensors in where no
  /// scalar changes.
  void settle(const assay_material& table, const StateSigns& signs);

  /// Whether the state has anything that could tell.
  bool tells() const { return !scalars_.empty() || !tensors_.empty(); }

  /// Whether a variable of unit "regime" does.
  bool named() const { return named_; }

  /// Of one point's step, components of the state in declared order.
  std::uint64_t of(const double* state0, const double* state1) const;

  friend void fields(auto& archive, RegimeReader& reader) {
    archive(reader.named_, reader.scalars_, reader.tensors_, reader.kinds_);
  }

 private:
  bool named_ = false;                ///< by variables of unit "regime"
  std::vector<std::size_t> scalars_;  ///< components of the state
  std::vector<std::size_t> tensors_;  ///< first components of other variables
  std::vector<std::int32_t> kinds_;   ///< of these
};

/// Whether a scalar changes in some step of a march and in none of the very short ones.
bool any_scalar_tells(const assay_material& table, const StateSigns& signs);

/// Whether a step has changed a variable of that kind: a tensor by more than its axes.
bool variable_changes(std::int32_t kind, const double* before, const double* after);

}  // namespace assay
