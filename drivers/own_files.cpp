// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/own_files.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

#include "adapters/worker/high_files.hpp"

namespace assay::drivers {

namespace {

struct Before {
  int streams[3];    ///< copies of the standard ones
  mode_t forbidden;  ///< of new files
  rlimit files;
};

std::optional<Before> before;

}  // namespace

void keep_standard_streams() {
  for (const int stream : {0, 1, 2}) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
  }
}

void remember_files() {
  constexpr rlim_t ours = 32, few = 256;
  if (before) return;
  before = Before{{adapters::high_copy(0), adapters::high_copy(1), adapters::high_copy(2)}, ::umask(0), {}};
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (before->streams[0] >= 0 && nothing >= 0) ::dup2(nothing, 0);
  if (nothing > 0) ::close(nothing);
  ::umask(before->forbidden);
  ::getrlimit(RLIMIT_NOFILE, &before->files);
  rlimit fewer = before->files;
  if (fewer.rlim_cur == RLIM_INFINITY || fewer.rlim_cur < few) return;
  fewer.rlim_cur -= ours;
  ::setrlimit(RLIMIT_NOFILE, &fewer);
}

int user_input() { return before && before->streams[0] >= 0 ? before->streams[0] : 0; }

void put_files_right() {
  if (!before) return;
  ::umask(before->forbidden);
  ::setrlimit(RLIMIT_NOFILE, &before->files);
  for (const int stream : {1, 2}) {
    if (::fcntl(stream, F_GETFD) < 0) ::dup2(before->streams[stream], stream);
  }
  keep_standard_streams();
}

const char* open_files_words(int error) {
  return error == EMFILE && before ? "; the material's library leaves files open" : "";
}

}  // namespace assay::drivers
