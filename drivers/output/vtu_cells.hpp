// SPDX-License-Identifier: BSD-3-Clause
// Particles for ParaView as the space that they take: a VTK XML unstructured grid of hexahedra.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

/// Values of particles, made a part at a time. make(first, count, out) puts down those of the particles from `first`
/// on, components of a particle side by side. Tensors have 9 components, row-major.
template <typename Value>
struct MadeArray {
  std::string name;
  int components = 1;
  std::function<void(std::size_t first, std::size_t count, Value* out)> make = {};
};

/// Writes one .vtu file: appended little-endian data, compressed by zlib, with UInt64 headers. Each particle is a
/// VTK_HEXAHEDRON with eight corners of its own, and its values are those of the cell: its number `id`, then the
/// arrays. corners: 24 components, x,y,z of each corner in VTK's order [m]. `t` becomes TimeValue [s], and VelocityTime
/// is that of velocities where it is another one. Some 1 MB is held at a time, however many particles there are. Equal
/// input gives equal bytes with the same version of zlib.
void write_cells(const PutBytes& put, std::size_t particles, const std::vector<MadeArray<double>>& arrays,
                 const MadeArray<double>& corners, double t, const std::optional<double>& velocity_t = {});

}  // namespace assay::drivers
