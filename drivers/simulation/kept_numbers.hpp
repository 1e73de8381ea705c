// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are written again and again and hardly ever read.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "drivers/system/input_bytes.hpp"

namespace assay::drivers {

/// They wait in a file without a name, so that they take no memory; in memory where a file cannot hold them, as on a
/// full disk.
class KeptNumbers {
 public:
  explicit KeptNumbers(bool in_file);

  /// Numbers from place `at` on. Throws Interrupted.
  void put(std::size_t at, std::span<const double> numbers);
  /// So many from the first on. Throws SystemError, Interrupted.
  std::vector<double> first(std::size_t count) const;
  bool in_file() const { return file_.has_value(); }

 private:
  void go_to_memory(std::size_t count);

  std::optional<UnnamedFile> file_;
  std::vector<double> memory_;
};

}  // namespace assay::drivers
