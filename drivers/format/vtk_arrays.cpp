// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/vtk_arrays.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>

namespace assay::drivers {

namespace {

/// Texts of base64, one behind the other: what is not of the alphabet is passed over, and '=' ends a text.
class Base64 {
 public:
  explicit Base64(std::string_view text) : text_(text) {}

  /// The next so many bytes; fewer at the end.
  std::string take(std::size_t bytes) {
    std::string found;
    while (found.size() < bytes && at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '=') held_ = 0;
      const int digit = digit_of(c);
      if (digit < 0) continue;
      bits_ = bits_ << 6 | static_cast<std::uint32_t>(digit);
      held_ += 6;
      if (held_ < 8) continue;
      held_ -= 8;
      found += static_cast<char>(bits_ >> held_ & 0xff);
    }
    return found;
  }

 private:
  static int digit_of(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  }
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t bits_ = 0;
  int held_ = 0;  ///< bits of the last characters that are of no byte yet
};

/// One after the other of an array's bytes, as raw data or base64.
class ArrayBytes {
 public:
  ArrayBytes(std::string_view data, bool base64) : raw_(data), base64_(data), is_base64_(base64) {}
  std::string take(std::size_t bytes) {
    if (is_base64_) return base64_.take(bytes);
    std::string found(raw_.substr(0, bytes));
    raw_.remove_prefix(found.size());
    return found;
  }

 private:
  std::string_view raw_;
  Base64 base64_;
  bool is_base64_;
};

template <class Value>
void append_as(std::string bytes, bool swapped, std::vector<double>& out) {
  const std::size_t count = bytes.size() / sizeof(Value);
  for (std::size_t k = 0; k < count; ++k) {
    char* at = bytes.data() + k * sizeof(Value);
    if (swapped) std::reverse(at, at + sizeof(Value));
    Value value;
    std::memcpy(&value, at, sizeof value);
    out.push_back(static_cast<double>(value));
  }
}

}  // namespace

std::optional<std::string> vtk_bytes(std::string_view text, bool base64, const VtkEncoding& encoding) {
  ArrayBytes data(text, base64);
  const std::size_t all = text.size();
  const std::size_t word = encoding.wide_headers ? 8 : 4;
  const auto numbers_of = [&](std::string bytes) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t at = 0; at + word <= bytes.size(); at += word) {
      if (encoding.swapped)
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                     bytes.begin() + static_cast<std::ptrdiff_t>(at + word));
      std::uint64_t number = 0;
      std::memcpy(&number, bytes.data() + at, word);
      numbers.push_back(number);
    }
    return numbers;
  };
  if (!encoding.compressed) {
    const auto size = numbers_of(data.take(word));
    if (size.empty() || size[0] > all) return std::nullopt;
    std::string bytes = data.take(static_cast<std::size_t>(size[0]));
    if (bytes.size() != size[0]) return std::nullopt;
    return bytes;
  }
  const auto head = numbers_of(data.take(3 * word));
  constexpr std::uint64_t most_block = std::uint64_t{1} << 30;
  if (head.size() != 3 || head[0] > all || head[1] > most_block || head[2] > most_block) return std::nullopt;
  const auto sizes = numbers_of(data.take(static_cast<std::size_t>(head[0]) * word));
  if (sizes.size() != head[0]) return std::nullopt;
  std::string bytes;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const bool last = k + 1 == sizes.size() && head[2] > 0;
    std::string block(static_cast<std::size_t>(last ? head[2] : head[1]), '\0');
    const std::string packed = data.take(static_cast<std::size_t>(std::min<std::uint64_t>(sizes[k], all)));
    uLongf found = block.size();
    const int status = ::uncompress(reinterpret_cast<Bytef*>(block.data()), &found,
                                    reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (packed.size() != sizes[k] || status != Z_OK || found != block.size()) return std::nullopt;
    bytes += block;
  }
  return bytes;
}

bool append_vtk_numbers(const std::string& bytes, std::string_view type, bool swapped, std::vector<double>& values) {
  using Append = void (*)(std::string, bool, std::vector<double>&);
  static const std::map<std::string_view, Append> types{
      {"Float64", append_as<double>},       {"Float32", append_as<float>},        {"Int64", append_as<std::int64_t>},
      {"UInt64", append_as<std::uint64_t>}, {"Int32", append_as<std::int32_t>},   {"UInt32", append_as<std::uint32_t>},
      {"Int16", append_as<std::int16_t>},   {"UInt16", append_as<std::uint16_t>}, {"Int8", append_as<std::int8_t>},
      {"UInt8", append_as<std::uint8_t>}};
  const auto found = types.find(type);
  if (found == types.end()) return false;
  found->second(bytes, swapped, values);
  return true;
}

}  // namespace assay::drivers
