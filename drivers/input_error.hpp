// SPDX-License-Identifier: BSD-3-Clause
// Bad input: one line for the user, exit status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace assay::drivers {

/// Where in a file something stands; line and column count from 1, 0 is unknown.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
  /// "file:line:column", as much of it as is known.
  std::string text() const;
};

/// what(): one line `file:line:column: key.path: what; known: ...`.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& what) : std::runtime_error(what) {}
  InputError(const Location& where, const std::string& key, const std::string& what, const std::string& known = {});
};

/// The system failed (unwritable folder, full disk): exit status 3.
class SystemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace assay::drivers
