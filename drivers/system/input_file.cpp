// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>

#include "adapters/process/private_files.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// The descriptor that a name stands for.
std::optional<int> stream_of(std::string_view name) {
  if (name == standard_stream || name == "/dev/stdin") return 0;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    constexpr std::int64_t most = 1 << 20;
    const auto number = parse_integer(name.substr(folder.size()));
    if (number && *number >= 0 && *number < most) return static_cast<int>(*number);
  }
  return std::nullopt;
}

std::string fault_of_mode(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "is a folder, not a file";
  if (S_ISFIFO(mode)) return "is a named pipe, not a regular file: write its text to a file, and name that";
  return std::string("is a ") + (S_ISSOCK(mode) ? "socket" : "device") + ", not a regular file";
}

std::string because() {
  const int error = errno;
  return std::string("cannot be read: ") + std::strerror(error) + open_files_words(error);
}

std::string bytes_of(int descriptor, const Location& where, std::size_t limit) {
  std::string bytes;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t n = ::read(descriptor, buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) {
      stop_if_interrupted();
      continue;
    }
    if (n < 0) throw InputError(where, "", because());
    if (n == 0) return bytes;
    bytes.append(buffer, static_cast<std::size_t>(n));
    if (bytes.size() > limit) throw InputError(where, "", "longer than " + std::to_string(limit) + " bytes");
  }
}

std::string bytes_of_stream(int number, const Location& where, std::size_t limit) {
  static std::map<int, std::string> read_before;
  const auto found = read_before.find(number);
  if (found != read_before.end()) return found->second;
  const int file = number == 0 ? user_input() : number;
  struct stat status {};
  if (::fstat(file, &status) != 0) throw InputError(where, "", because());
  if (S_ISDIR(status.st_mode)) throw InputError(where, "", fault_of_mode(status.st_mode));
  return read_before[number] = bytes_of(file, where, limit);
}

FileState file_state_of(const struct stat& status) {
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

std::mutex guard_of_inputs;
std::set<FileState> files_read;

void note_input(const struct stat& status) {
  const std::lock_guard lock(guard_of_inputs);
  if (S_ISREG(status.st_mode)) files_read.insert(file_state_of(status));
}

}  // namespace

void note_input(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) note_input(status);
}

void forget_inputs() {
  const std::lock_guard lock(guard_of_inputs);
  files_read.clear();
}

bool is_input(const std::string& file) {
  put_files_right();
  struct stat status {};
  const std::lock_guard lock(guard_of_inputs);
  return ::stat(file.c_str(), &status) == 0 && files_read.contains(file_state_of(status));
}

void refuse_input_as_output(const std::string& output, const std::string& option) {
  if (output.empty() || output == standard_stream || !is_input(output)) return;
  throw InputError({}, option, "'" + shown(output, 200) + "' would replace an input of that name: choose another name");
}

int open_input(const std::string& file, FileState* state) {
  const Location where{file, 0, 0};
  if (file.find('\0') != file.npos || file.empty())
    throw InputError({}, "", "'" + shown(file, 200) + "' is not the name of a file");
  struct stat status {};
  if (const auto stream = stream_of(file)) {
    const int source = *stream == 0 ? user_input() : *stream;
    const int copy = ::fstat(source, &status) == 0 ? adapters::high_copy(source) : -1;
    if (copy < 0) throw InputError(where, "", because());
    return copy;
  }
  put_files_right();
  // Without O_NONBLOCK a pipe that nobody writes into is waited for.
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (opened < 0) {
    const std::string reason = because();
    const bool unfit = ::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
    throw InputError(where, "", unfit ? fault_of_mode(status.st_mode) : reason);
  }
  const std::string fault = ::fstat(opened, &status) != 0 ? because() : fault_of_mode(status.st_mode);
  if (!fault.empty()) {
    ::close(opened);
    throw InputError(where, "", fault);
  }
  note_input(status);
  if (state) *state = file_state_of(status);
  return opened;
}

std::string read_bytes(const std::string& file, std::size_t limit) {
  const Location where{file, 0, 0};
  if (const auto stream = stream_of(file)) return bytes_of_stream(*stream, where, limit);
  const adapters::OpenFile opened(open_input(file));
  return bytes_of(opened.number(), where, limit);
}

std::string fault_of_file(const std::string& file) {
  if (stream_of(file)) return {};
  struct stat status {};
  const std::string quoted = "'" + shown(file, 200) + "'";
  if (::stat(file.c_str(), &status) != 0) {
    return errno == ENOENT || errno == ENOTDIR ? "no such file: " + quoted : quoted + " " + because();
  }
  const std::string fault = fault_of_mode(status.st_mode);
  return fault.empty() ? fault : quoted + " " + fault;
}

bool is_stream(const std::string& file) { return stream_of(file).has_value(); }

bool is_same_stream(const std::string& one, const std::string& other) {
  const auto stream = stream_of(one);
  return stream && stream == stream_of(other);
}

std::string stem_of_input(const std::string& file) {
  if (file == standard_stream) return "stdin";
  const std::string stem = std::filesystem::path(file).stem().string();
  return stem.find_first_not_of('.') == stem.npos ? "unnamed" : stem;  // "..yaml" is no name of a folder
}

}  // namespace assay::drivers
