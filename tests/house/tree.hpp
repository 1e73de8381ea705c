// SPDX-License-Identifier: BSD-3-Clause
// The source tree as data, for tests of the tree itself.
#pragma once

#include <string>
#include <vector>

namespace assay::house {

/// Paths from the root, sorted, of the regular files in `folder` ("" is the root, not deep) with one of the extensions
/// (".hpp"; empty list: every file). Throws std::runtime_error where the folder cannot be read.
std::vector<std::string> files_in(const std::string& folder, const std::vector<std::string>& extensions, bool deep);

/// Text of a file; path from the root. Throws std::runtime_error where it cannot be read.
std::string text_of(const std::string& path);

std::vector<std::string> lines_of(const std::string& text);

struct Include {
  int line = 0;
  std::string name;  ///< "drivers/scene/scene.hpp", "vector"
  bool quoted = false;
};

/// #include lines of a C or C++ source.
std::vector<Include> includes_of(const std::string& text);

struct Outcome {
  int status = -1;     ///< exit status, -1 where the program did not exit
  std::string output;  ///< standard output
};

/// Runs the built program `assay` with these arguments (shell syntax).
Outcome run_assay(const std::string& arguments);

/// The verbs that `assay --help` lists.
std::vector<std::string> verbs();

}  // namespace assay::house
