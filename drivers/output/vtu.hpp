// SPDX-License-Identifier: BSD-3-Clause
// Particles for ParaView: VTK XML unstructured grids of vertices and their collection over time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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
/// holds x,y,z of each particle [m], `t` becomes TimeValue [s], and VelocityTime is that of velocities where it is
/// another one. Equal input gives equal bytes with the same version of zlib. Throws std::invalid_argument where a
/// length does not fit.
std::string vtu_text(std::span<const double> positions, const std::vector<VtuArray>& arrays, double t,
                     const std::optional<double>& velocity_t = {});

/// The same file without compression, so that each number has its place before any of them is known: particles may
/// come in any order and number at a time.
class VtuLayout {
 public:
  struct Part {
    std::string name;
    int components = 1;
  };
  VtuLayout(std::uint64_t particles, const std::vector<Part>& parts, double t);

  /// Where the numbers of a part begin, one particle behind the other; behind the last part: the positions.
  std::uint64_t begin(std::size_t part) const { return begins_[part]; }

  /// Calls write(place, bytes) for all else: the text before and behind, and the cells.
  void write_rest(const std::function<void(std::uint64_t, std::string_view)>& write) const;

 private:
  std::uint64_t particles_;
  double t_;
  std::string head_;
  std::vector<std::uint64_t> begins_;
  std::uint64_t time_ = 0, cells_ = 0;                            ///< where these begin
  std::vector<std::pair<std::uint64_t, std::uint64_t>> lengths_;  ///< of each array [bytes], and where it is written
};

struct PvdEntry {
  double t = 0;      ///< [s]
  std::string file;  ///< relative to the .pvd file
};

/// The .pvd collection.
std::string pvd_text(const std::vector<PvdEntry>& entries);

/// "particles_0007.vtu".
std::string particles_name(int index);

}  // namespace assay::drivers
