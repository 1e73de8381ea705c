// SPDX-License-Identifier: BSD-3-Clause
// Memory without a name that processes share: nothing is left of it when the last of them has ended.
#pragma once

#include <cstddef>

namespace assay::adapters {

class SharedMemory {
 public:
  /// New, zero, of so many bytes; pages are taken when they are touched. Throws std::system_error.
  explicit SharedMemory(std::size_t bytes);
  /// That of another process, by an inherited file. Throws std::system_error.
  static SharedMemory of_file(int file);

  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  ~SharedMemory();

  void* data() const { return data_; }
  std::size_t size() const { return size_; }
  int file() const { return file_; }

 private:
  SharedMemory(int file, std::size_t bytes);
  int file_ = -1;
  void* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace assay::adapters
