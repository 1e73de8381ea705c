// SPDX-License-Identifier: BSD-3-Clause
// What VTU files are put together of.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace assay::drivers::vtu {

inline constexpr const char* file_tail = "\n</AppendedData>\n</VTKFile>\n";

/// more: further attributes.
std::string file_head(const std::string& type, const std::string& more = {});

/// The element of an array whose numbers are appended. more: further attributes.
std::string array_line(const std::string& name, const char* type, int components, const std::string& more,
                       std::uint64_t offset);

/// Attributes of an array: what ParaView shows instead of 0..8.
std::string component_names(int components);

/// Appends the block, compressed by itself, so that a reader can take any of them alone. Returns its size.
std::uint64_t append_block(std::string& out, std::string_view block);

}  // namespace assay::drivers::vtu
