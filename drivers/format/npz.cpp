// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/npz.hpp"

#include <bit>
#include <string_view>

#include "drivers/format/npy.hpp"
#include "drivers/format/zip.hpp"

namespace assay::drivers {

std::string npz_bytes(const std::vector<NpzArray>& arrays) {
  static_assert(std::endian::native == std::endian::little);
  ZipLayout layout;
  std::vector<std::string> heads;
  for (const NpzArray& array : arrays) {
    heads.push_back(npy_header(array.shape));
    layout.add(array.name + ".npy", heads.back().size() + array.values.size_bytes());
  }
  std::string bytes;
  const auto put = [&](std::uint64_t at, std::string_view piece) {
    if (bytes.size() < at + piece.size()) bytes.resize(at + piece.size());
    bytes.replace(at, piece.size(), piece);
  };
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    const std::string_view numbers(reinterpret_cast<const char*>(arrays[k].values.data()),
                                   arrays[k].values.size_bytes());
    layout.count(k, heads[k]);
    layout.count(k, numbers);
    put(layout.begin(k), heads[k]);
    put(layout.begin(k) + heads[k].size(), numbers);
  }
  for (const ZipLayout::Piece& piece : layout.pieces()) put(piece.at, piece.bytes);
  return bytes;
}

}  // namespace assay::drivers
