// SPDX-License-Identifier: BSD-3-Clause
// Particles for ParaView: VTK XML unstructured grids of vertices and their collection over time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace assay::drivers {

/// Values of all particles, components of a particle side by side: [p * components + c]. Tensors have 9 components,
/// row-major.
struct VtuArray {
  std::string name;
  int components = 1;
  std::variant<std::span<const double>, std::span<const std::int64_t>> values;
};

/// One .vtu file: appended little-endian data, compressed by zlib (vtu_blocks.hpp), with UInt64 headers. `positions`
/// holds x,y,z of each particle [m], `t` becomes TimeValue [s]. Equal input gives equal bytes with the same version of
/// zlib. Throws std::invalid_argument where a length does not fit.
std::string vtu_text(std::span<const double> positions, const std::vector<VtuArray>& arrays, double t);

struct PvdEntry {
  double t = 0;      ///< [s]
  std::string file;  ///< relative to the .pvd file
};

/// The .pvd collection.
std::string pvd_text(const std::vector<PvdEntry>& entries);

/// "particles_0007.vtu".
std::string particles_name(int index);

}  // namespace assay::drivers
