// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/colormap.hpp"

#include <algorithm>
#include <cmath>

namespace assay::drivers {

namespace {

// viridis of Nathaniel Smith and Stefan van der Walt (CC0) at s = 0, 1/9, .. 1.
constexpr std::array<std::uint32_t, 10> viridis{0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                                0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
// Linear in the lightness of Oklab on both sides, hues 255 and 28 degrees.
constexpr std::array<std::uint32_t, 17> diverging{0x003e81, 0x08529f, 0x1b68be, 0x327ed9, 0x5496e9, 0x79aef2,
                                                  0xa0c6f7, 0xc9ddf7, 0xf3f3f3, 0xf5d1cc, 0xf3b0a6, 0xeb8f83,
                                                  0xde6f62, 0xcb5146, 0xb03b32, 0x922a23, 0x751814};
constexpr std::array<std::uint32_t, 7> palette{0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9, 0x555555};
constexpr std::array<std::uint32_t, 7> dark{0x0066a0, 0xb14e00, 0x00734f, 0xa04a7c, 0x8a5f00, 0x1a759f, 0x444444};

template <std::size_t N>
Color between(const std::array<std::uint32_t, N>& anchors, double s) {
  const double at = std::clamp(s, 0.0, 1.0) * (N - 1);
  const auto below = std::min(static_cast<std::size_t>(at), N - 2);
  return mix(rgb(anchors[below]), rgb(anchors[below + 1]), at - static_cast<double>(below));
}

}  // namespace

Color map_color(ColorMap map, double s) {
  if (std::isnan(s)) return no_value;
  return map == ColorMap::viridis ? between(viridis, s) : between(diverging, s);
}

Color series_color(std::size_t index) { return rgb(palette[index % palette.size()]); }

double luminance(Color color) {
  const auto linear = [](std::uint8_t part) {
    const double s = part / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

Color readable_on(Color background) {
  constexpr double as_far_from_both = 0.179;
  return luminance(background) > as_far_from_both ? rgb(0x000000) : rgb(0xffffff);
}

Color series_text_color(std::size_t index) { return rgb(dark[index % dark.size()]); }

}  // namespace assay::drivers
