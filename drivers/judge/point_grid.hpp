// SPDX-License-Identifier: BSD-3-Clause
// Points in boxes, for the nearest one.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "harness/numeric/tensor.hpp"

namespace assay::drivers {

/// Of points that live as long. What is no number is left out.
class PointGrid {
 public:
  /// size: of a box, about the distance of the points [m]; other than positive: 1.
  PointGrid(const std::vector<Vector3>& points, double size);

  /// Of the boxes around a place, or where they are empty of those around them; none where these are empty, too.
  std::optional<std::uint32_t> nearest(const Vector3& at) const;

 private:
  using Box = std::array<std::int64_t, 3>;
  Box box_of(const Vector3& x) const;
  /// Looks for a nearer one in a box.
  void look(const Box& box, const Vector3& at, double& least, std::optional<std::uint32_t>& found) const;
  std::uint64_t slot_of(const Box& box) const;

  const std::vector<Vector3>& points_;
  double size_;
  bool in_plane_ = false;
  std::vector<std::uint32_t> first_;    ///< of each slot, in which some boxes are: where its points begin in these
  std::vector<std::uint32_t> indices_;  ///< of the points, those of one slot side by side
  std::uint64_t mask_ = 0, row_ = 1, layer_ = 1;
};

}  // namespace assay::drivers
