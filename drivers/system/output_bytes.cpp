// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/output_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

OutputBytes::OutputBytes(const fs::path& path, Order order)
    : path_(path), is_standard_(path.empty() || path == standard_stream || is_standard_output(path)) {
  if (!is_standard_) {
    put_files_right();
    std::error_code error;
    const fs::file_status there = fs::status(path, error);
    if (!fs::exists(there) || fs::is_regular_file(there)) {
      // Through a link the file is replaced, not the link.
      real_ = fs::exists(there) ? fs::canonical(path, error) : path;
      sweep_dead(real_.has_parent_path() ? real_.parent_path() : fs::path("."));
      hidden_ = real_.parent_path() / hidden_name();
      return;
    }
  }
  if (order == Order::any) gathered_.emplace();
}

OutputBytes::~OutputBytes() {
  std::error_code ignored;
  if (begun_ && !done_ && !hidden_.empty()) fs::remove(hidden_, ignored);
}

void OutputBytes::append(std::string_view bytes) {
  if (hidden_.empty())
    put_into_stream(bytes);
  else
    put(size_, bytes);
  size_ += bytes.size();
}

void OutputBytes::write_at(std::uint64_t at, std::string_view bytes) {
  if (gathered_)
    gathered_->write_at(at, bytes);
  else
    put(at, bytes);
}

void OutputBytes::put_into_stream(std::string_view bytes) {
  stop_if_interrupted();
  if (is_standard_) {
    print_bytes(bytes);
    if (!all_is_printed()) throw SystemError("standard output cannot be written");
    return;
  }
  put_files_right();
  if (!stream_) stream_.emplace(open_output(path_, 0));
  write_all(stream_->number(), bytes, path_);
}

void OutputBytes::put(std::uint64_t at, std::string_view bytes) {
  try {
    stop_if_interrupted();
    put_files_right();
    const int how = begun_ ? O_WRONLY | O_CLOEXEC : O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL;
    adapters::OpenFile file(::open(hidden_.c_str(), how, 0666));
    if (file.number() < 0) fail(hidden_, begun_ ? "cannot be written" : "cannot be created", errno);
    begun_ = true;
    if (!write_at_all(file.number(), at, bytes)) fail(hidden_, "cannot be written", errno);
    if (file.close() != 0 && errno != EINTR) fail(hidden_, "cannot be written", errno);
  } catch (const SystemError& failure) {
    rethrow_with(failure, hidden_, path_);
  }
}

void OutputBytes::commit() {
  if (gathered_) {
    std::vector<char> piece(std::size_t{1} << 20);
    for (std::uint64_t at = 0; at < gathered_->size();) {
      const std::int64_t n = read_at(gathered_->number(), at, piece.data(), piece.size());
      if (n <= 0) throw SystemError("a temporary file cannot be read");
      put_into_stream({piece.data(), static_cast<std::size_t>(n)});
      at += static_cast<std::uint64_t>(n);
    }
  }
  done_ = hidden_.empty();
  if (done_ && stream_ && stream_->close() != 0 && errno != EINTR) fail(path_, "cannot be written", errno);
  if (done_) return;
  if (!begun_) put(0, {});
  try {
    put_files_right();
    adapters::OpenFile file(::open(hidden_.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0 || (::fsync(file.number()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS))
      fail(hidden_, "cannot be written", errno);
    std::error_code error;
    const fs::file_status there = fs::status(real_, error);
    if (fs::exists(there)) fs::permissions(hidden_, there.permissions(), error);  // who could not read it still cannot
    stop_if_interrupted();
    fs::rename(hidden_, real_, error);
    if (error) fail(hidden_, "cannot be put in place", error);
    done_ = true;
  } catch (const SystemError& failure) {
    rethrow_with(failure, hidden_, path_);
  }
}

}  // namespace assay::drivers
