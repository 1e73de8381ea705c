// SPDX-License-Identifier: BSD-3-Clause
// Studies that run in one folder at the same time: they share its cases, and none runs again what another has just
// finished.
#pragma once

#include <filesystem>
#include <string>

namespace assay::drivers {

/// A session begins with a study that is alone in its folder, and ends with the last that has joined it meanwhile.
class StudySession {
 public:
  /// Makes the folder. `resumes`: this study keeps what it finds finished; `is_shard`: it is a part, which no other
  /// part has a case of; `study`: what tells it from others, without blanks. Throws SystemError where the folder cannot
  /// be written to, FolderBusy where another study runs in it, Interrupted.
  StudySession(const std::filesystem::path& folder, const std::string& study, bool resumes, bool is_shard);
  StudySession(const StudySession&) = delete;
  StudySession& operator=(const StudySession&) = delete;
  ~StudySession();

  /// Who began it, "process 12 on host", where that is not this study; empty otherwise.
  const std::string& begun_by() const { return begun_by_; }

  /// Whether finished cases stay: as whoever began it wants it, since nobody may take a case away that another counts.
  bool resumes() const { return resumes_; }

  /// Whether a file was written since the session began.
  bool has_seen(const std::filesystem::path& file) const;

 private:
  void enter(const std::filesystem::path& file, const std::string& study, bool is_shard);

  int file_ = -1;  ///< locked, shared
  bool resumes_;
  std::filesystem::file_time_type begin_;
  std::string begun_by_;
};

}  // namespace assay::drivers
