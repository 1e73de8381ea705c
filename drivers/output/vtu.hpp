// SPDX-License-Identifier: BSD-3-Clause
// Particles for ParaView: VTK XML unstructured grids of vertices and their collection over time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace assay::drivers {

/// Bytes of a block before it is compressed: as many as VTK's own writer takes.
constexpr std::size_t vtu_block_bytes = 32768;

/// Appends an array as VTK's vtkZLibDataCompressor lays it out: the header, little-endian numbers of 8 bytes, and the
/// blocks that zlib has compressed, each by itself. The header holds the number of blocks, vtu_block_bytes, the bytes
/// of the last block where it is shorter (else 0), and the compressed size of each block. An array without bytes has no
/// block. Beside `out` one block is held at a time.
void append_compressed(std::string& out, std::string_view bytes);

/// Values of all particles, components of a particle side by side: [p * components + c]. Tensors have 9 components,
/// row-major.
struct VtuArray {
  std::string name;
  int components = 1;
  std::variant<std::span<const double>, std::span<const std::int64_t>> values;
};

/// One .vtu file: appended little-endian data, compressed by zlib, with UInt64 headers. `positions`
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
