// SPDX-License-Identifier: BSD-3-Clause
// A file of any size that is written in pieces and appears whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "adapters/process/private_files.hpp"
#include "drivers/system/input_bytes.hpp"

namespace assay::drivers {

/// Written under a temporary name beside the file, which it replaces at the end. What is no regular file (standard
/// output, a pipe, a device) takes each piece as it comes. The file is open while a piece is written alone, so that
/// there may be any number of them. Throws SystemError, and Interrupted when a signal came.
class OutputBytes {
 public:
  /// Pieces in their order from the beginning, or at any places: then all is put together before a stream gets it.
  enum class Order { given, any };

  /// path: empty or "-" for standard output.
  explicit OutputBytes(const std::filesystem::path& path, Order order = Order::given);
  OutputBytes(const OutputBytes&) = delete;
  OutputBytes& operator=(const OutputBytes&) = delete;
  /// Without commit() nothing is left.
  ~OutputBytes();

  /// Of Order::given.
  void append(std::string_view bytes);
  /// Of Order::any.
  void write_at(std::uint64_t at, std::string_view bytes);
  /// All bytes are on the disk, and the file has its name.
  void commit();

 private:
  void put(std::uint64_t at, std::string_view bytes);
  void put_into_stream(std::string_view bytes);

  std::filesystem::path path_, real_, hidden_;  ///< hidden_: empty for what is no regular file
  bool is_standard_ = false, begun_ = false, done_ = false;
  std::uint64_t size_ = 0;                    ///< of what was appended
  std::optional<adapters::OpenFile> stream_;  ///< what is no regular file
  std::optional<UnnamedFile> gathered_;       ///< of Order::any for a stream
};

}  // namespace assay::drivers
