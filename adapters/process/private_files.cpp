// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/private_files.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace assay::adapters {

namespace {

[[noreturn]] void fail(const char* what, int reason) { throw std::system_error(reason, std::generic_category(), what); }

/// Closes the files of what has failed; errno stays.
void close_all(std::initializer_list<int> files) {
  const int reason = errno;
  for (const int file : files) {
    if (file >= 0) ::close(file);
  }
  errno = reason;
}

int new_memory(std::size_t bytes) {
  const int low = ::memfd_create("assay", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (low < 0) fail("memfd_create", errno);
  const int file = high_copy(low);
  close_all({low});
  if (file < 0) fail("fcntl", errno);
  if (::ftruncate(file, static_cast<off_t>(bytes)) != 0) {
    close_all({file});
    fail("ftruncate", errno);
  }
  ::fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);  // or who shares it could take it away
  return file;
}

std::size_t size_of(int file) {
  struct stat status = {};
  if (::fstat(file, &status) != 0) fail("fstat", errno);
  return static_cast<std::size_t>(status.st_size);
}

}  // namespace

int high_copy(int file) {
  constexpr int after_ours = 16;
  for (const int least : {1500, 900, 64, after_ours}) {
    if (const int copy = ::fcntl(file, F_DUPFD_CLOEXEC, least); copy >= 0) return copy;
  }
  if (errno == EINVAL) errno = EMFILE;  // the limit lies below all of these
  return -1;
}

bool high_pipe(int ends[2]) {
  int low[2];
  if (::pipe2(low, O_CLOEXEC) != 0) return false;
  for (const int k : {0, 1}) ends[k] = high_copy(low[k]);
  close_all({low[0], low[1]});
  if (ends[0] >= 0 && ends[1] >= 0) return true;
  close_all({ends[0], ends[1]});
  return false;
}

Pipe::Pipe() {
  if (!high_pipe(ends_)) fail("pipe", errno);
}

void Pipe::close(int k) {
  if (const int end = std::exchange(ends_[k], -1); end >= 0) ::close(end);
}

PrintedFile::PrintedFile(const char* name) : file_(::memfd_create(name, MFD_CLOEXEC)) {
  if (number() < 0) fail("memfd_create", errno);
}

std::string PrintedFile::text(std::size_t most, bool last) const {
  const auto size = static_cast<std::size_t>(std::max<off_t>(::lseek(number(), 0, SEEK_END), 0));
  std::string text(std::min(size, most), '\0');
  const ssize_t length = ::pread(number(), text.data(), text.size(), last ? static_cast<off_t>(size - text.size()) : 0);
  text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return text;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

void send_streams_to(int output, int errors) {
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  if (nothing > STDERR_FILENO) ::close(nothing);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string temporary_folder() {
  const char* said = std::getenv("TMPDIR");
  return said && *said == '/' ? said : "/tmp";
}

OwnFolder::OwnFolder(const char* names) {
  if (stands_apart) return;
  path_ = temporary_folder() + "/" + names + "XXXXXX";
  if (!::mkdtemp(path_.data())) reason_ = errno, path_.clear();
}

OwnFolder::~OwnFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

bool OwnFolder::enter() const {
  stands_apart = stands_apart || ::chdir(path_.c_str()) == 0;
  if (!stands_apart && reason_ != 0) errno = reason_;
  return stands_apart;
}

SharedMemory::SharedMemory(int file, std::size_t bytes)
    : file_(file),
      data_(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | (file < 0 ? MAP_ANONYMOUS : MAP_NORESERVE),
                   file, 0)),
      size_(bytes) {
  if (data_ != MAP_FAILED) return;
  close_all({file});
  fail("mmap", errno);
}

SharedMemory::SharedMemory(std::size_t bytes) : SharedMemory(new_memory(bytes), bytes) {}

SharedMemory SharedMemory::of_forks(std::size_t bytes) { return SharedMemory(-1, bytes); }

SharedMemory SharedMemory::of_file(int file) { return SharedMemory(file, size_of(file)); }

SharedMemory::~SharedMemory() {
  ::munmap(data_, size_);
  close_all({file_});
}

}  // namespace assay::adapters
