// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/case_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "drivers/system/input_error.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// Some network file systems cannot lock: then two studies at once are the user's affair.
bool held_by_another(int file) { return ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; }

/// A run locks its folder (output_folder.cpp); that of a study that was killed may take a moment to die.
bool is_written_to(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return false;
  const bool written = held_by_another(file);
  ::close(file);
  return written;
}

}  // namespace

std::optional<CaseLock> CaseLock::tried(const fs::path& folder) {
  std::error_code error;
  if (fs::is_symlink(folder, error)) throw SystemError(folder.string() + ": is a link, and not followed");
  fs::create_directories(folder, error);
  if (error) fail(folder, "folder cannot be created", error);
  const int file = ::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) fail(folder, "folder cannot be written to", errno);
  CaseLock lock(file);
  if (held_by_another(file) || is_written_to(folder)) return std::nullopt;
  return lock;
}

CaseLock::~CaseLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace assay::drivers
