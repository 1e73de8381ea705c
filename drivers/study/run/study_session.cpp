// SPDX-License-Identifier: BSD-3-Clause
// Which processes work in a study's folder.
#include "drivers/study/run/runner.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// "process 12 on host"
std::string this_process() {
  char name[256] = "";
  if (::gethostname(name, sizeof name - 1) != 0) name[0] = '\0';
  return "process " + std::to_string(::getpid()) + (name[0] ? " on " + std::string(name) : "");
}

constexpr const char* session_file = ".study";
constexpr const char *fresh = "fresh ", *resumed = "resumed ", *shard = "shard ";  ///< how its text begins

std::string text_in(int file) {
  char text[256];
  const ssize_t length = ::pread(file, text, sizeof text, 0);
  return one_line(std::string(text, length > 0 ? static_cast<std::size_t>(length) : 0), 200);
}

void put_text(int file, const std::string& text) {
  if (::ftruncate(file, 0) != 0) return;  // the time of the file is what counts
  [[maybe_unused]] const ssize_t written = ::pwrite(file, text.data(), text.size(), 0);
}

}  // namespace

StudySession::StudySession(const fs::path& folder, const std::string& study, bool resumes, bool is_shard)
    : resumes_(resumes) {
  const fs::path cases = folder / "cases";
  std::error_code error;
  fs::create_directories(cases, error);
  if (error) fail(cases, "folder cannot be created", error);
  // One at a time, so that between looking and joining nobody begins a session.
  const int turn = ::open(cases.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  while (turn >= 0 && ::flock(turn, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK && !interrupted()) ::usleep(3000);
  try {
    enter(folder / session_file, study, is_shard);
  } catch (const SystemError&) {
    ::close(turn);
    if (file_ >= 0) ::close(file_);
    throw;
  }
  ::close(turn);
  stop_if_interrupted();
}

StudySession::~StudySession() {
  if (file_ >= 0) ::close(file_);
}

void StudySession::enter(const fs::path& file, const std::string& study, bool is_shard) {
  file_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail(file, "cannot be written", errno);
  const bool alone = ::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  if (alone) {
    put_text(file_, std::string(is_shard ? shard : resumes_ ? resumed : fresh) + study + " " + this_process());
  } else {
    const std::string text = text_in(file_);
    const std::size_t begin = std::min(text.find(' ') + 1, text.size());
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    begun_by_ = text.substr(std::min(end + 1, text.size()));
    if (text.substr(begin, end - begin) != study)
      throw FolderBusy(file.parent_path().string() + ": another study runs in this folder (" + begun_by_ +
                       " began): choose another one with -o");
    if (!is_shard && !text.starts_with(shard)) resumes_ = text.starts_with(resumed);
  }
  ::flock(file_, LOCK_SH | LOCK_NB);
  std::error_code error;
  begin_ = fs::last_write_time(file, error);
  if (error) fail(file, "cannot be read", error);
}

bool StudySession::has_seen(const fs::path& file) const {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  return !error && written >= begin_;
}

}  // namespace assay::drivers
