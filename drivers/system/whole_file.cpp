// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <vector>

#include "adapters/process/private_files.hpp"
#include "drivers/system/input_bytes.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/output_bytes.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
  return name.data();
}

}  // namespace

void fail(const fs::path& path, const std::string& what, int error) {
  throw SystemError(path.string() + ": " + what + ": " + std::generic_category().message(error) +
                    open_files_words(error));
}

void fail(const fs::path& path, const std::string& what, const std::error_code& error) {
  throw SystemError(path.string() + ": " + what + ": " + error.message());
}

void write_all(int descriptor, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      stop_if_interrupted();
      continue;
    }
    if (written < 0) fail(path, "cannot be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool is_standard_output(const fs::path& path) {
  return path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

/// A pipe without a reader would let nobody in: after some seconds the error is ENXIO.
int open_output(const fs::path& path, int flags) {
  constexpr int patience_ms = 2000, step_ms = 20;
  int descriptor = -1;
  for (int waited = 0; waited <= patience_ms; waited += step_ms) {
    descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | flags, 0666);
    if (descriptor >= 0 || errno != ENXIO) break;
    stop_if_interrupted();
    ::usleep(step_ms * 1000);
    errno = ENXIO;
  }
  if (descriptor < 0 && errno == ENXIO) throw SystemError(path.string() + ": is a pipe that nobody reads");
  if (descriptor < 0) fail(path, "cannot be created", errno);
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

namespace {

/// Pipes and terminals cannot be synced and say so.
void sync_and_close(adapters::OpenFile& file, const fs::path& path) {
  if (::fsync(file.number()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
    fail(path, "cannot be written", errno);
  if (file.close() != 0 && errno != EINTR) fail(path, "cannot be written", errno);
}

}  // namespace

void write_bytes(const fs::path& path, std::string_view bytes, int flags) {
  put_files_right();
  adapters::OpenFile file(open_output(path, flags));
  write_all(file.number(), bytes, path);
  sync_and_close(file, path);
}

void write_pieces(const fs::path& path, const std::function<void(const PutBytes&)>& write, int flags) {
  put_files_right();
  adapters::OpenFile file(open_output(path, flags));
  write([&](std::uint64_t at, std::string_view bytes) {
    stop_if_interrupted();
    if (!write_at_all(file.number(), at, bytes)) fail(path, "cannot be written", errno);
  });
  sync_and_close(file, path);
}

void sync_path(const fs::path& path) {
  const adapters::OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() >= 0) ::fsync(file.number());
}

std::string hidden_name() {
  static std::atomic<int> counter{0};
  return ".assay-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + "@" + host_name();
}

bool matches(std::string_view pattern, std::string_view name) {
  for (const char expected : pattern) {
    if (name.empty() || (expected == '#' ? !is_digit(name[0]) : name[0] != expected)) return false;
    name.remove_prefix(1);
    while (expected == '#' && !name.empty() && is_digit(name[0])) name.remove_prefix(1);
  }
  return name.empty();
}

void sweep_dead(const fs::path& folder) {
  const std::string tail = "@" + host_name();
  std::error_code error;
  std::vector<fs::path> dead;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.ends_with(tail) || !matches(".assay-#-#", name.substr(0, name.size() - tail.size()))) continue;
    const auto process = parse_integer(name.substr(7, name.find('-', 7) - 7));
    if (process && ::kill(static_cast<pid_t>(*process), 0) != 0 && errno == ESRCH) dead.push_back(entry->path());
  }
  for (const fs::path& path : dead) fs::remove_all(path, error);
}

void rethrow_with(const SystemError& failure, const fs::path& hidden, const fs::path& known) {
  std::string what = failure.what();
  if (what.starts_with(hidden.string())) what.replace(0, hidden.string().size(), known.string());
  throw SystemError(what);
}

void write_file(const fs::path& path, std::string_view bytes) {
  if (is_standard_output(path)) return print(bytes);
  OutputBytes out(path);
  out.append(bytes);
  out.commit();
}

}  // namespace assay::drivers
