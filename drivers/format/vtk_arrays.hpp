// SPDX-License-Identifier: BSD-3-Clause
// The numbers of an array in VTK's XML files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

/// Of a whole file.
struct VtkEncoding {
  bool swapped = false, wide_headers = false, compressed = false;  ///< big-endian, UInt64, by zlib
};

/// The bytes of an array, raw or base64. A header says how many there are; of compressed data it says how many each
/// block has. Nothing where they are cut off or damaged.
std::optional<std::string> vtk_bytes(std::string_view text, bool base64, const VtkEncoding& encoding);

/// type: "Float64", "Int32", ... False where there is no such type.
bool append_vtk_numbers(const std::string& bytes, std::string_view type, bool swapped, std::vector<double>& values);

}  // namespace assay::drivers
