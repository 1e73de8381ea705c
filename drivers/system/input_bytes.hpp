// SPDX-License-Identifier: BSD-3-Clause
// The bytes of an input of any size, in pieces and again and again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "adapters/process/private_files.hpp"
#include "drivers/system/input_file.hpp"

namespace assay::drivers {

/// A file without a name in the folder of temporary files: gone with the last who has it open. Throws SystemError.
class UnnamedFile {
 public:
  UnnamedFile();
  int number() const { return file_.number(); }
  /// Behind what is there. Throws SystemError, as on a full disk, and Interrupted.
  void append(std::string_view bytes);
  void write_at(std::uint64_t at, std::string_view bytes);
  /// As many bytes as there are up to `most`. Throws SystemError, Interrupted.
  std::size_t read(std::uint64_t at, char* into, std::size_t most) const;
  std::uint64_t size() const { return size_; }

 private:
  adapters::OpenFile file_;
  std::uint64_t size_ = 0;
};

/// A file that the user names. It is opened for each look alone, and may not change between them. A stream is kept in
/// an unnamed file, so that a second look finds the same.
class InputBytes {
 public:
  /// Throws InputError as read_bytes() does.
  explicit InputBytes(const std::string& file);

  const std::string& file() const { return file_; }  ///< its name in messages
  std::uint64_t size() const { return size_; }

  /// Bytes from `at` on, as many as there are up to `most`. Throws InputError, Interrupted.
  std::size_t read(std::uint64_t at, char* into, std::size_t most) const;
  /// The same as a text.
  std::string text(std::uint64_t at, std::size_t most) const;

 private:
  [[noreturn]] void refuse() const;  ///< for the reason that errno says

  std::string file_;
  std::optional<UnnamedFile> kept_;  ///< of a stream
  FileState state_ = {};             ///< else: what the file was when it was first opened
  std::uint64_t size_ = 0;
};

/// Bytes of a file that is open, from `at` on: fewer than `most` at its end alone. Below 0: errno says why. Throws
/// Interrupted.
std::int64_t read_at(int file, std::uint64_t at, char* into, std::size_t most);

/// All bytes go to that place. False: errno says why. Throws Interrupted.
bool write_at_all(int file, std::uint64_t at, std::string_view bytes);

}  // namespace assay::drivers
