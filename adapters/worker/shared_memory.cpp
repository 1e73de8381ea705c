// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/shared_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace assay::adapters {

namespace {

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

int new_file(std::size_t bytes) {
  const int file = ::memfd_create("assay", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (file < 0) fail("memfd_create");
  if (::ftruncate(file, static_cast<off_t>(bytes)) != 0) {
    const int reason = errno;
    ::close(file);
    errno = reason;
    fail("ftruncate");
  }
  ::fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);  // or who shares it could take it away
  return file;
}

std::size_t size_of(int file) {
  struct stat status = {};
  if (::fstat(file, &status) != 0) fail("fstat");
  return static_cast<std::size_t>(status.st_size);
}

}  // namespace

SharedMemory::SharedMemory(int file, std::size_t bytes) : file_(file), size_(bytes) {
  data_ = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_NORESERVE, file, 0);
  if (data_ == MAP_FAILED) {
    const int reason = errno;
    ::close(file);
    errno = reason;
    fail("mmap");
  }
}

SharedMemory::SharedMemory(std::size_t bytes) : SharedMemory(new_file(bytes), bytes) {}

SharedMemory SharedMemory::of_file(int file) { return SharedMemory(file, size_of(file)); }

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : file_(std::exchange(other.file_, -1)), data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

SharedMemory::~SharedMemory() {
  if (data_) ::munmap(data_, size_);
  if (file_ >= 0) ::close(file_);
}

}  // namespace assay::adapters
