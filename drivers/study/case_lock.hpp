// SPDX-License-Identifier: BSD-3-Clause
// Who runs a case: two studies, or two shards that were given the same part, must not do it at once.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace assay::drivers {

/// Held until it goes, or the process that holds it.
class CaseLock {
 public:
  /// None where another holds it, or a run still writes into the folder. Makes the folder. Throws SystemError.
  static std::optional<CaseLock> tried(const std::filesystem::path& folder);

  CaseLock(CaseLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  CaseLock& operator=(CaseLock&&) = delete;
  ~CaseLock();

 private:
  explicit CaseLock(int file) : file_(file) {}
  int file_;
};

}  // namespace assay::drivers
