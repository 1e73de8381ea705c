// SPDX-License-Identifier: BSD-3-Clause
// Archives of files (.zip, with the numbers of 64 bits that large ones need), as NumPy keeps several arrays in.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_bytes.hpp"

namespace assay::drivers {

/// An archive whose members are not compressed and whose sizes are known before: each has its place, and all of them
/// may grow at the same time.
class ZipLayout {
 public:
  /// Returns its number.
  std::size_t add(const std::string& name, std::uint64_t size);

  /// Where the bytes of a member begin.
  std::uint64_t begin(std::size_t member) const { return members_[member].begin; }

  /// The next bytes of a member, in their order.
  void count(std::size_t member, std::string_view bytes);

  /// What stands before a member and behind all of them, once all bytes are counted.
  struct Piece {
    std::uint64_t at = 0;
    std::string bytes;
  };
  std::vector<Piece> pieces() const;

 private:
  struct Member {
    std::string name;
    std::uint64_t size = 0, at = 0, begin = 0;  ///< at: of its header
    std::uint32_t crc = 0;
  };
  std::vector<Member> members_;
  std::uint64_t end_ = 0;
};

/// The members of an archive, stored or deflated. What is deflated is kept in unnamed files.
class ZipReader {
 public:
  /// Throws InputError for what is no such archive, is damaged (its checksums, too), encrypted or compressed otherwise.
  explicit ZipReader(const InputBytes& input);

  struct Member {
    std::string name;
    std::uint64_t size = 0;
  };
  const std::vector<Member>& members() const { return members_; }

  /// Bytes of a member from `at` on, as many as there are up to `most`.
  std::size_t read(std::size_t member, std::uint64_t at, char* into, std::size_t most) const;

 private:
  struct Place {
    std::uint64_t begin = 0;
    std::unique_ptr<UnnamedFile> inflated = {};
  };
  [[noreturn]] void refuse(const std::string& what) const;
  void directory(std::uint64_t at, std::uint64_t size, std::uint64_t count);
  std::string bytes(std::uint64_t at, std::size_t size) const;
  Place stored(std::uint64_t at, std::uint64_t size, std::uint32_t crc) const;
  Place deflated(std::uint64_t at, std::uint64_t packed, std::uint64_t size, std::uint32_t crc) const;

  const InputBytes& input_;
  std::vector<Member> members_;
  std::vector<Place> places_;
};

}  // namespace assay::drivers
