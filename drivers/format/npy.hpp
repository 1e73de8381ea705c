// SPDX-License-Identifier: BSD-3-Clause
// The headers of NumPy's arrays (.npy, versions 1 to 3): what lies behind them are numbers in the order of memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// One number of an element: of a plain array the only one, without a name.
struct NpyField {
  std::string name = {};
  char kind = 'f';  ///< f, i or u; V: bytes between the others that mean nothing
  int bytes = 8;
  bool big_endian = false;
};

struct NpyHeader {
  std::vector<NpyField> fields = {};      ///< of an element, one behind the other
  std::vector<std::uint64_t> shape = {};  ///< empty: one element
  bool by_columns = false;                ///< the first index is the fastest
  std::size_t size = 0;                   ///< of the header: where the numbers begin
  std::uint64_t elements() const;         ///< in all
  std::size_t element_bytes() const;
};

/// The header of doubles in the order of C, little-endian, before an array of that shape. names: fields of an element,
/// empty for a plain array.
std::string npy_header(const std::vector<std::uint64_t>& shape, const std::vector<std::string>& names = {});

/// Of a text that begins with one. Throws InputError at `where` for what is no header, is cut off, or has elements
/// other than numbers.
NpyHeader read_npy_header(std::string_view text, const Location& where);

/// The longest header that is read [bytes].
inline constexpr std::size_t longest_npy_header = std::size_t{1} << 20;

/// Whether a text begins as an array, or an archive of arrays, does.
bool is_npy(std::string_view text);
bool is_zip(std::string_view text);

/// A number of an element.
double npy_number(const char* bytes, const NpyField& field);

}  // namespace assay::drivers
