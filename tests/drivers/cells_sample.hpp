// SPDX-License-Identifier: BSD-3-Clause
// A file of hexahedra, each of them a box at a place of its own.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drivers/output/vtu_cells.hpp"

namespace assay::drivers {

/// Numbers that do not repeat.
inline MadeArray<double> sample_array(const std::string& name, int components) {
  return {name, components, [components](std::size_t first, std::size_t count, double* out) {
            const auto width = static_cast<std::size_t>(components);
            for (std::size_t k = 0; k < count * width; ++k)
              out[k] = std::sin(0.37 * static_cast<double>(first * width + k) + components);
          }};
}

/// Boxes of 0.1 x 0.2 x 0.3 m in a row. `swapped`: two corners of each, so that it is turned inside out.
inline MadeArray<double> sample_corners(bool swapped = false) {
  return {"", 24, [swapped](std::size_t first, std::size_t count, double* out) {
            for (std::size_t p = first; p < first + count; ++p) {
              for (std::size_t k = 0; k < 8; ++k) {
                const std::size_t around = swapped ? 3 - k % 4 : k % 4;
                *out++ = static_cast<double>(p) + (around == 1 || around == 2 ? 0.1 : 0);
                *out++ = around >= 2 ? 0.2 : 0;
                *out++ = k >= 4 ? 0.3 : 0;
              }
            }
          }};
}

inline void put_cells(const PutBytes& put, std::size_t particles, const std::optional<double>& velocity_t = {},
                      bool swapped = false) {
  write_cells(put, particles, {sample_array("stress", 9), sample_array("shear", 1)}, sample_corners(swapped), 0.25,
              velocity_t);
}

inline std::string cells_text(std::size_t particles, const std::optional<double>& velocity_t = {},
                              bool swapped = false) {
  std::string text;
  put_cells(
      [&](std::uint64_t at, std::string_view bytes) {
        if (text.size() < at + bytes.size()) text.resize(at + bytes.size());
        text.replace(at, bytes.size(), bytes);
      },
      particles, velocity_t, swapped);
  return text;
}

inline std::vector<double> values_of(const MadeArray<double>& array, std::size_t particles) {
  std::vector<double> values(particles * static_cast<std::size_t>(array.components));
  array.make(0, particles, values.data());
  return values;
}

}  // namespace assay::drivers
