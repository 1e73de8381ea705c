// SPDX-License-Identifier: BSD-3-Clause
// An array as VTK's vtkZLibDataCompressor lays it out: blocks that zlib has compressed, each by itself.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace assay::drivers {

/// Bytes of a block before it is compressed: as many as VTK's own writer takes.
constexpr std::size_t vtu_block_bytes = 32768;

/// Appends the header, little-endian numbers of 8 bytes, and the compressed blocks behind it. The header holds the
/// number of blocks, vtu_block_bytes, the bytes of the last block where it is shorter (else 0), and the compressed size
/// of each block. An array without bytes has no block. Beside `out` one block is held at a time.
void append_compressed(std::string& out, std::string_view bytes);

}  // namespace assay::drivers
