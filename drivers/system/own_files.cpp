// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/own_files.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "adapters/process/private_files.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

struct Before {
  int streams[3];                ///< copies of the standard ones
  int folder;                    ///< in which this process stood
  mode_t forbidden;              ///< of new files
  std::array<rlimit, 9> limits;  ///< that a model has
  rlimit files;                  ///< with ours
};

constexpr rlim_t ours = 32;  ///< files that a model may not have

constexpr std::array resources{RLIMIT_NOFILE, RLIMIT_FSIZE, RLIMIT_AS,    RLIMIT_DATA,   RLIMIT_STACK,
                               RLIMIT_CORE,   RLIMIT_CPU,   RLIMIT_NPROC, RLIMIT_MEMLOCK};

constexpr std::array names_of_resources{"open files", "size of a file", "memory",    "data",         "stack",
                                        "core files", "processor time", "processes", "locked memory"};

std::optional<Before> before;
std::optional<adapters::ProcessWatch> since;
std::atomic<adapters::Habits> put_right{adapters::no_habit};

rlimit limit_of(std::size_t k) {
  rlimit limit = {};
  ::getrlimit(resources[k], &limit);
  return limit;
}

/// Where both streams lead while a model may print: a line of its own would spoil a table that goes on down a pipe.
int place_of_prints() { return before->streams[STDERR_FILENO]; }

void send_prints_to_errors() {
  std::fflush(stdout);
  if (place_of_prints() >= 0) ::dup2(place_of_prints(), STDOUT_FILENO);
}

bool is_another(int stream) {
  struct stat now = {}, then = {};
  if (::fstat(stream, &now) != 0) return true;
  return ::fstat(place_of_prints(), &then) == 0 && (now.st_dev != then.st_dev || now.st_ino != then.st_ino);
}

/// As far as it may: not beyond a hard limit that the model has lowered.
void put_limit_back(std::size_t k) {
  const rlimit& wanted = before->limits[k];
  if (::setrlimit(resources[k], &wanted) == 0) return;
  rlimit allowed = limit_of(k);
  allowed.rlim_cur = std::min(wanted.rlim_cur, allowed.rlim_max);
  ::setrlimit(resources[k], &allowed);
}

/// Whether the few that are open at once cannot be had.
bool has_no_files() {
  std::array<int, 6> files{};
  for (int& file : files) file = ::open("/", O_PATH | O_CLOEXEC);
  for (const int file : files) {
    if (file >= 0) ::close(file);
  }
  return files.back() < 0;
}

/// Of the hard ones, which stay so.
bool is_lowered(std::size_t k) { return limit_of(k).rlim_max < before->limits[k].rlim_max; }

/// A caller that serves many at once, or a model, may have made it fail where it should wait: output would be cut in
/// the middle. False where it waited already.
bool let_wait(int stream) {
  const int flags = ::fcntl(stream, F_GETFL);
  return flags >= 0 && (flags & O_NONBLOCK) != 0 && ::fcntl(stream, F_SETFL, flags & ~O_NONBLOCK) == 0;
}

}  // namespace

void keep_standard_streams() {
  for (const int stream : {0, 1, 2}) {
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
    let_wait(stream);
  }
}

void remember_files() {
  constexpr rlim_t few = 256;
  if (before) return;
  const adapters::OpenFile folder(::open(".", O_PATH | O_DIRECTORY | O_CLOEXEC)),
      nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  before = Before{{adapters::high_copy(0), adapters::high_copy(1), adapters::high_copy(2)},
                  adapters::high_copy(folder.number()),
                  ::umask(0),
                  {},
                  {}};
  if (before->streams[0] >= 0 && nothing.number() >= 0) ::dup2(nothing.number(), 0);
  send_prints_to_errors();
  ::umask(before->forbidden);
  for (std::size_t k = 0; k < resources.size(); ++k) before->limits[k] = limit_of(k);
  before->files = before->limits[0];
  if (before->files.rlim_cur != RLIM_INFINITY && before->files.rlim_cur >= few) before->limits[0].rlim_cur -= ours;
  put_limit_back(0);
  since.emplace();
}

void keep_these_streams() {
  if (!before) return;
  for (const int stream : {1, 2}) {
    if (before->streams[stream] >= 0) ::close(before->streams[stream]);
    before->streams[stream] = adapters::high_copy(stream);
  }
  send_prints_to_errors();
}

void require_open_files(std::size_t least) {
  const rlim_t limit = limit_of(0).rlim_cur;
  if (limit != RLIM_INFINITY && limit < least)
    throw SystemError("open files are limited to " + std::to_string(limit) + " (ulimit -n), and " +
                      std::to_string(least) + " are needed");
}

void require_temporary_folder() {
  const std::string folder = adapters::temporary_folder();
  std::string tried = folder + "/assay-XXXXXX";
  if (!::mkdtemp(tried.data()))
    throw SystemError("$TMPDIR, '" + one_line(folder, 200) +
                      "', is no folder for temporary files: " + std::generic_category().message(errno));
  ::rmdir(tried.c_str());
}

int user_input() { return before && before->streams[0] >= 0 ? before->streams[0] : 0; }

int user_output() { return before && before->streams[1] >= 0 ? before->streams[1] : STDOUT_FILENO; }

void put_files_right() {
  if (!before) return;
  put_right |= habits_of_process() & (adapters::folder_changed | adapters::limits_changed | adapters::files_forbidden);
  [[maybe_unused]] const int gone = ::fchdir(before->folder);
  ::umask(before->forbidden);
  for (std::size_t k = 0; k < resources.size(); ++k) put_limit_back(k);
  if (has_no_files()) ::setrlimit(RLIMIT_NOFILE, &before->files);  // not before: the model would take ours, too
  put_streams_right();
}

void put_streams_right() {
  if (!before) return;
  for (const int stream : {1, 2}) {
    if (let_wait(stream)) put_right |= adapters::streams_hurried;
    if (!is_another(stream)) continue;
    put_right |= adapters::output_closed;
    std::fflush(stream == 1 ? stdout : stderr);  // what the model has written belongs to its own file
    ::dup2(place_of_prints(), stream);
  }
  keep_standard_streams();
}

adapters::Habits habits_of_process() {
  if (!since) return adapters::no_habit;
  adapters::Habits found = since->habits() | put_right;
  if (limit_of(0).rlim_cur < before->limits[0].rlim_cur) {  // it looks as if no file could be opened any more
    found = (found & ~adapters::files_left) | adapters::limits_changed;
  }
  return found;
}

std::string lowered_limits_words() {
  std::string names;
  for (std::size_t k = 0; before && k < resources.size(); ++k) {
    if (is_lowered(k)) names += (names.empty() ? "" : ", ") + std::string(names_of_resources[k]);
  }
  return names.empty() ? "" : "; the material's library has lowered limits of the process: " + names;
}

const char* open_files_words(int error) {
  if (!before) return "";
  if (error == EMFILE && is_lowered(0)) return "; the material's library has lowered the limit of open files";
  if (error == EMFILE) return "; the material's library leaves files open";
  const bool too_large = error == EFBIG && is_lowered(1);
  return too_large ? "; the material's library has lowered the limit of a file's size" : "";
}

}  // namespace assay::drivers
