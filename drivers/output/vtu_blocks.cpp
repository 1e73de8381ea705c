// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/vtu_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>

namespace assay::drivers {

namespace {

/// Measured on the snapshots of a run of 10,000 particles: level 1 leaves 51.7 % of the bytes, level 6 leaves 50.6 % in
/// twice the time, level 9 no less in eighteen times the time.
constexpr int vtu_compression_level = 1;

/// One state of zlib for all blocks of an array. Each block begins afresh, so that a reader can take any of them alone.
class Deflater {
 public:
  Deflater() {
    if (deflateInit(&stream_, vtu_compression_level) != Z_OK) throw std::bad_alloc();  // nothing else can fail here
    compressed_.resize(deflateBound(&stream_, vtu_block_bytes));
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream_); }

  /// Valid until the next call.
  std::string_view compressed(std::string_view block) {
    deflateReset(&stream_);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));  // zlib does not write there
    stream_.avail_in = static_cast<uInt>(block.size());
    stream_.next_out = reinterpret_cast<Bytef*>(compressed_.data());
    stream_.avail_out = static_cast<uInt>(compressed_.size());
    if (deflate(&stream_, Z_FINISH) != Z_STREAM_END) throw std::logic_error("vtu: zlib does not end a block");
    return {compressed_.data(), compressed_.size() - stream_.avail_out};
  }

 private:
  z_stream stream_{};
  std::string compressed_;
};

void append_number(std::string& out, std::uint64_t number) {
  out.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace

void append_compressed(std::string& out, std::string_view bytes) {
  const std::size_t blocks = (bytes.size() + vtu_block_bytes - 1) / vtu_block_bytes;
  append_number(out, blocks);
  append_number(out, vtu_block_bytes);
  append_number(out, bytes.size() % vtu_block_bytes);
  if (blocks == 0) return;
  std::size_t size_at = out.size();  // of the block at hand
  out.append(blocks * sizeof(std::uint64_t), '\0');
  Deflater deflater;
  for (std::size_t begin = 0; begin < bytes.size(); begin += vtu_block_bytes) {
    const std::string_view block = deflater.compressed(bytes.substr(begin, vtu_block_bytes));
    const std::uint64_t size = block.size();
    std::memcpy(out.data() + size_at, &size, sizeof size);
    size_at += sizeof size;
    out.append(block);
  }
}

}  // namespace assay::drivers
