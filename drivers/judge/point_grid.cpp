// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/point_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace assay::drivers {

PointGrid::PointGrid(const std::vector<Vector3>& points, double size) : points_(points), size_(size > 0 ? size : 1) {
  const std::uint64_t slots = std::bit_ceil(std::max<std::uint64_t>(2 * points.size(), 2));
  mask_ = slots - 1;
  first_.assign(slots + 1, 0);
  in_plane_ = std::ranges::all_of(points, [](const Vector3& x) { return x.z() == 0 || !x.allFinite(); });
  const double across = in_plane_ ? std::sqrt(slots) : std::cbrt(slots);
  row_ = static_cast<std::uint64_t>(across) | 1, layer_ = static_cast<std::uint64_t>(across * across) | 1;
  std::vector<std::uint32_t> slots_of(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (!points[k].allFinite()) continue;
    slots_of[k] = static_cast<std::uint32_t>(slot_of(box_of(points[k])));
    ++first_[slots_of[k] + 1];
  }
  for (std::size_t slot = 0; slot < slots; ++slot) first_[slot + 1] += first_[slot];
  indices_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    if (points[k].allFinite()) indices_[next[slots_of[k]]++] = k;
  }
}

/// Points of other boxes in the same slot are no nearer by mistake: each is a point.
void PointGrid::look(const Box& box, const Vector3& at, double& least, std::optional<std::uint32_t>& found) const {
  const std::uint64_t slot = slot_of(box);
  for (std::uint32_t k = first_[slot]; k < first_[slot + 1]; ++k) {
    const double distance = (points_[indices_[k]] - at).squaredNorm();
    if (distance < least) least = distance, found = indices_[k];
  }
}

std::optional<std::uint32_t> PointGrid::nearest(const Vector3& at) const {
  constexpr double at_it = 1e-6;  // of a box: no other point is nearer
  constexpr int farthest = 2;
  const double beyond = (farthest + 1) * size_;
  std::optional<std::uint32_t> found;
  double least = beyond * beyond * 3;
  const Box middle = box_of(at);
  look(middle, at, least, found);
  if (found && least < at_it * at_it * size_ * size_) return found;
  for (int reach = 1; reach <= farthest && (reach == 1 || !found); ++reach) {
    const int along_z = in_plane_ ? 0 : reach;
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -reach; j <= reach; ++j) {
        for (int k = -along_z; k <= along_z; ++k) look({middle[0] + i, middle[1] + j, middle[2] + k}, at, least, found);
      }
    }
  }
  return found;
}

PointGrid::Box PointGrid::box_of(const Vector3& x) const {
  Box box;
  constexpr double most = 1e15;
  for (std::size_t d = 0; d < 3; ++d)
    box[d] = static_cast<std::int64_t>(std::floor(std::clamp(x[static_cast<int>(d)] / size_, -most, most)));
  return box;
}

/// Neighbours along x are neighbours in memory.
std::uint64_t PointGrid::slot_of(const Box& box) const {
  return (static_cast<std::uint64_t>(box[0]) + row_ * static_cast<std::uint64_t>(box[1]) +
          layer_ * static_cast<std::uint64_t>(box[2])) &
         mask_;
}

}  // namespace assay::drivers
