// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/high_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace assay::adapters {

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
  const int reason = errno;
  for (const int k : {0, 1}) ::close(low[k]);
  if (ends[0] >= 0 && ends[1] >= 0) return true;
  for (const int k : {0, 1}) ::close(ends[k]);
  errno = reason;
  return false;
}

}  // namespace assay::adapters
