// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/input_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"

namespace assay::drivers {

namespace {

/// A high number, which a model that closes files does not think of.
int made_unnamed() {
  put_files_right();
  const std::string folder = adapters::temporary_folder();
  std::string name = folder + "/assay-XXXXXX";
  const adapters::OpenFile made(::mkostemp(name.data(), O_CLOEXEC));
  if (made.number() >= 0) ::unlink(name.c_str());
  const int kept = made.number() < 0 ? -1 : adapters::high_copy(made.number());
  if (kept < 0) {
    const int error = errno;
    throw SystemError("a temporary file in '" + one_line(folder, 200) +
                      "' cannot be made: " + std::generic_category().message(error) + open_files_words(error));
  }
  return kept;
}

[[noreturn]] void refuse(const char* what) {
  const int error = errno;
  throw SystemError("a temporary file in '" + one_line(adapters::temporary_folder(), 200) + "' cannot be " + what +
                    ": " + std::generic_category().message(error));
}

}  // namespace

std::int64_t read_at(int file, std::uint64_t at, char* into, std::size_t most) {
  std::size_t done = 0;
  while (done < most) {
    const ssize_t n = ::pread(file, into + done, most - done, static_cast<off_t>(at + done));
    if (n < 0 && errno == EINTR) {
      stop_if_interrupted();
      continue;
    }
    if (n < 0) return -1;
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return static_cast<std::int64_t>(done);
}

bool write_at_all(int file, std::uint64_t at, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) {
      stop_if_interrupted();
      continue;
    }
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
    at += static_cast<std::uint64_t>(n);
  }
  return true;
}

UnnamedFile::UnnamedFile() : file_(made_unnamed()) {}

void UnnamedFile::append(std::string_view bytes) { write_at(size_, bytes); }

void UnnamedFile::write_at(std::uint64_t at, std::string_view bytes) {
  stop_if_interrupted();
  put_files_right();
  if (!write_at_all(file_.number(), at, bytes)) refuse("written");
  size_ = std::max(size_, at + bytes.size());
}

std::size_t UnnamedFile::read(std::uint64_t at, char* into, std::size_t most) const {
  const std::int64_t n = read_at(file_.number(), at, into, most);
  if (n < 0) refuse("read");
  return static_cast<std::size_t>(n);
}

InputBytes::InputBytes(const std::string& file) : file_(file) {
  adapters::OpenFile opened(open_input(file, &state_));
  if (!is_stream(file)) {
    size_ = state_.size;
    return;
  }
  kept_.emplace();
  std::vector<char> piece(std::size_t{1} << 16);
  for (;;) {
    const ssize_t n = ::read(opened.number(), piece.data(), piece.size());
    if (n < 0 && errno == EINTR) {
      stop_if_interrupted();
      continue;
    }
    if (n < 0) refuse();
    if (n == 0) break;
    kept_->append({piece.data(), static_cast<std::size_t>(n)});
  }
  size_ = kept_->size();
}

void InputBytes::refuse() const {
  const int error = errno;
  throw InputError({file_, 0, 0}, "",
                   "cannot be read: " + std::generic_category().message(error) + open_files_words(error));
}

std::size_t InputBytes::read(std::uint64_t at, char* into, std::size_t most) const {
  FileState now;
  const adapters::OpenFile opened(kept_ ? -1 : open_input(file_, &now));
  if (!kept_ && now != state_) throw InputError({file_, 0, 0}, "", "was changed while it was read");
  const std::int64_t n = read_at(kept_ ? kept_->number() : opened.number(), at, into, most);
  if (n < 0) refuse();
  return static_cast<std::size_t>(n);
}

std::string InputBytes::text(std::uint64_t at, std::size_t most) const {
  std::string bytes(most, '\0');
  bytes.resize(read(at, bytes.data(), most));
  return bytes;
}

}  // namespace assay::drivers
