// SPDX-License-Identifier: BSD-3-Clause
// Reads VTU files as their format is described, with zlib's own uncompress: nothing of the writer is in it.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace assay {

/// A file whose appended arrays have headers of UInt64, and are compressed by vtkZLibDataCompressor or not at all.
/// Every function throws std::runtime_error where the file is not as the format wants it.
class VtuFile {
 public:
  explicit VtuFile(std::string text) : text_(std::move(text)) {
    constexpr std::string_view mark = "<AppendedData encoding=\"raw\">\n_";
    const std::size_t at = text_.find(mark);
    if (at == std::string::npos) throw std::runtime_error("no appended data");
    xml_ = text_.substr(0, at);
    data_ = std::string_view(text_).substr(at + mark.size());
    if (xml_.find(" header_type=\"UInt64\"") == std::string::npos) throw std::runtime_error("headers of another type");
    compressed_ = xml_.find(" compressor=\"vtkZLibDataCompressor\"") != std::string::npos;
    if (!compressed_ && xml_.find(" compressor=") != std::string::npos) throw std::runtime_error("another compressor");
    constexpr std::string_view end = "\n</AppendedData>\n</VTKFile>\n";
    if (!data_.ends_with(end)) throw std::runtime_error("the file is not whole");
    data_.remove_suffix(end.size());
  }
  VtuFile(const VtuFile&) = delete;
  VtuFile& operator=(const VtuFile&) = delete;

  /// Of all arrays, in the order of the file.
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (std::size_t at = xml_.find("<DataArray "); at != std::string::npos; at = xml_.find("<DataArray ", at + 1)) {
      found.push_back(value_of(xml_.substr(at, xml_.find('>', at) - at), "Name"));
    }
    return found;
  }

  /// An attribute of the array of this name; empty where it has none.
  std::string attribute(const std::string& name, const std::string& key) const {
    const std::size_t at = xml_.find(" Name=\"" + name + "\"");
    if (at == std::string::npos) return {};
    const std::size_t begin = xml_.rfind('<', at);
    return value_of(xml_.substr(begin, xml_.find('>', at) - begin), key);
  }

  /// The values of an array, as bytes.
  std::string bytes(const std::string& name) const {
    const std::string offset = attribute(name, "offset");
    if (offset.empty()) throw std::runtime_error("an array without data: " + name);
    std::size_t at = std::stoull(offset);
    if (!compressed_) {
      const std::uint64_t size = number(at);
      if (size > data_.size() - at) throw std::runtime_error("an array beyond the end: " + name);
      return std::string(data_.substr(at, size));
    }
    const std::uint64_t blocks = number(at), block_bytes = number(at), last_bytes = number(at);
    if (blocks > data_.size() / sizeof(std::uint64_t)) throw std::runtime_error("more blocks than bytes: " + name);
    if (last_bytes >= block_bytes || block_bytes > most_block_bytes) {
      throw std::runtime_error("the size of a block: " + name);
    }
    std::vector<std::uint64_t> sizes;
    for (std::uint64_t k = 0; k < blocks; ++k) sizes.push_back(number(at));
    std::string out;
    for (std::uint64_t k = 0; k < blocks; ++k) {
      append_block(out, at, sizes[k], k + 1 == blocks && last_bytes > 0 ? last_bytes : block_bytes);
      at += sizes[k];
    }
    return out;
  }

  template <typename Value>
  std::vector<Value> array(const std::string& name) const {
    const std::string found = bytes(name);
    if (found.size() % sizeof(Value) != 0) throw std::runtime_error("a part of a value: " + name);
    std::vector<Value> values(found.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(values.data(), found.data(), found.size());
    return values;
  }

 private:
  static constexpr std::uint64_t most_block_bytes = std::uint64_t{1} << 20;

  static std::string value_of(const std::string& tag, const std::string& key) {
    const std::size_t at = tag.find(" " + key + "=\"");
    if (at == std::string::npos) return {};
    const std::size_t begin = at + key.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  std::uint64_t number(std::size_t& at) const {
    std::uint64_t value = 0;
    if (at > data_.size() || data_.size() - at < sizeof value) throw std::runtime_error("an array beyond the end");
    std::memcpy(&value, data_.data() + at, sizeof value);
    at += sizeof value;
    return value;
  }

  void append_block(std::string& out, std::size_t at, std::uint64_t compressed, std::uint64_t size) const {
    if (at > data_.size() || data_.size() - at < compressed) throw std::runtime_error("a block beyond the end");
    std::string block(size, '\0');
    uLongf found = size;
    const auto* from = reinterpret_cast<const Bytef*>(data_.data() + at);
    if (uncompress(reinterpret_cast<Bytef*>(block.data()), &found, from, compressed) != Z_OK || found != size) {
      throw std::runtime_error("a damaged block");
    }
    out += block;
  }

  std::string text_, xml_;
  std::string_view data_;
  bool compressed_ = false;
};

}  // namespace assay
