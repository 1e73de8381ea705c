// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/grid/images.hpp"

#include <algorithm>
#include <cmath>

namespace assay::mpm {

namespace {

/// Of a node along one axis: the node that it is an image of, and the sign of the component along the axis.
struct AxisImage {
  std::int32_t of = 0;
  double sign = 1;
  bool on_plane = false;
};

AxisImage image_along(std::int32_t node, const std::optional<std::int32_t>& lower,
                      const std::optional<std::int32_t>& upper, bool periodic) {
  AxisImage image{node, 1, false};
  if (periodic) {
    const std::int32_t n = *upper - *lower;
    image.of = *lower + ((node - *lower) % n + n) % n;
    return image;
  }
  const auto beyond_lower = [&] { return lower && image.of < *lower; };
  const auto beyond_upper = [&] { return upper && image.of > *upper; };
  while (beyond_lower() || beyond_upper()) {
    image.of = 2 * (beyond_lower() ? *lower : *upper) - image.of;
    image.sign = -image.sign;
  }
  image.on_plane = (lower && image.of == *lower) || (upper && image.of == *upper);
  return image;
}

}  // namespace

template <int Dim>
Images<Dim>::Images(const GridGeometry<Dim>& grid, const std::array<AxisEnds, Dim>& ends) {
  std::array<std::vector<AxisImage>, Dim> along;
  for (std::size_t d = 0; d < Dim; ++d) {
    const auto plane = [&](const std::optional<double>& x) -> std::optional<std::int32_t> {
      if (!x) return std::nullopt;
      return static_cast<std::int32_t>(std::lround(*x / grid.spacing)) - grid.first[d];
    };
    for (std::int32_t i = 0; i < grid.count[d]; ++i) {
      along[d].push_back(image_along(i, plane(ends[d].lower), plane(ends[d].upper), ends[d].periodic));
    }
  }
  share_.assign(grid.nodes(), 1);
  const bool any_periodic = std::any_of(ends.begin(), ends.end(), [](const AxisEnds& axis) { return axis.periodic; });
  if (any_periodic) cell_of_.resize(grid.nodes());
  for (std::size_t node = 0; node < grid.nodes(); ++node) {
    std::size_t rest = node, stride = 1, of = 0, cell = 0;
    Image image;
    for (std::size_t d = 0; d < Dim; ++d) {
      const auto count = static_cast<std::size_t>(grid.count[d]);
      const AxisImage& axis = along[d][rest % count];
      of += stride * static_cast<std::size_t>(axis.of);
      cell += stride * (ends[d].periodic ? static_cast<std::size_t>(axis.of) : rest % count);
      image.sign[d] = axis.sign;
      if (axis.on_plane) {
        share_[node] *= 0.5;
        fixed_.push_back({static_cast<std::uint32_t>(node), static_cast<std::uint8_t>(d)});
      }
      rest /= count, stride *= count;
    }
    image.node = static_cast<std::uint32_t>(node), image.of = static_cast<std::uint32_t>(of);
    if (of != node) images_.push_back(image);
    if (any_periodic) cell_of_[node] = static_cast<std::uint32_t>(cell);
  }
}

template class Images<ASSAY_DIMENSION>;

}  // namespace assay::mpm
