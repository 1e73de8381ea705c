// SPDX-License-Identifier: BSD-3-Clause
// The one place where text goes to standard output and warnings to standard error: nothing that a name, a label or a
// model's words hold reaches the terminal as a command.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

/// How much a verb says on standard error.
enum class Verbosity { quiet, normal, verbose };

/// Lines for a reader, on standard output and flushed: what steers a terminal is written as "<U+001B>".
void print(std::string_view lines);

/// Numbers, as text or not: the bytes as they are.
void print_bytes(std::string_view bytes);

/// JSON: the same characters as \u001b, which leaves the data as they are.
void print_json(std::string_view json);

/// Whether what is printed goes to a person's terminal, and not to a file or to another program.
bool prints_to_terminal();

/// False where the system did not take what was printed.
bool all_is_printed();

/// "warning: SENTENCE" on standard error, one line.
void warn(std::string_view sentence);

/// While one lives, what this thread warns of is kept in it and not printed. At most one a thread.
class KeptWarnings {
 public:
  KeptWarnings();
  KeptWarnings(const KeptWarnings&) = delete;
  KeptWarnings& operator=(const KeptWarnings&) = delete;
  ~KeptWarnings();
  const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  friend void warn(std::string_view sentence);
  std::vector<std::string> sentences_;
};

/// One text that a verb tells, and where it goes.
struct Page {
  std::string file;  ///< "-": standard output; empty: none
  std::string text;
  bool is_json = false;
};

/// What was found first, on standard output: `text`, or the last page that is asked for there. Then the files, whatever
/// becomes of them. Throws SystemError.
void tell(const std::string& text, const std::vector<Page>& pages);

}  // namespace assay::drivers
