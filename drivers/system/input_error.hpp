// SPDX-License-Identifier: BSD-3-Clause
// Bad input: one line for the user, exit status 2.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/text/words.hpp"

namespace assay::drivers {

/// Where in a file something stands; line and column count from 1, 0 is unknown.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
  /// "file:line:column", as much of it as is known; "standard input:line:column".
  std::string text() const;
};

/// Location::file of what came from `--set`; the line then reads `--set key.path: what`.
inline constexpr const char* set_option = "--set";

/// what(): one line `file:line:column: key.path: what; known: ...`. What cannot be seen in it is written out and named.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& what);
  InputError(const Location& where, const std::string& key, const std::string& what, const std::string& known = {});

  const Location& where() const { return where_; }
  const std::string& key() const { return key_; }  ///< of the scene, "motion.peak"; empty: none

 private:
  Location where_;
  std::string key_;
};

/// The system failed (unwritable folder, full disk): exit status 3.
class SystemError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of a system call that failed: its name, and what errno says.
[[noreturn]] void throw_system_error(const char* call);

/// Another run writes into the folder.
class FolderBusy : public SystemError {
 public:
  using SystemError::SystemError;
};

/// The text on one line, as printable() has it; what exceeds `limit` bytes is cut and marked by "...".
std::string one_line(std::string_view text, std::size_t limit = 4096);

/// The known word nearest to a mistyped one by edit distance, whatever cannot be seen in it; empty where none is near.
std::string nearest(const std::string& mistyped, const std::vector<std::string>& known);

/// "a, b, c"; of more than 40 words the nearest to `word`, and that `source` lists the others.
std::string known_words(const std::string& word, const std::vector<std::string>& known,
                        const std::string& source = "`assay schema`");

/// " (nearest: inner), U+2013 stands where '-' belongs", as far as either is known.
std::string nearest_words(const std::string& word, const std::vector<std::string>& known);

/// "unknown key" or "unknown key (nearest: inner)".
std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& known);

}  // namespace assay::drivers
