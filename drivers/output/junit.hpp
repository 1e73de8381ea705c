// SPDX-License-Identifier: BSD-3-Clause
// JUnit's XML, as Ant and Jenkins read it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace assay::drivers {

struct JunitCase {
  enum class Kind { passed, skipped, failure, error };
  std::string classname, name;
  double seconds = 0;
  Kind kind = Kind::passed;
  std::string message = {};  ///< why it did not pass
  std::string type = {};     ///< kind of failure or error
  std::string text = {};     ///< more of it
};

struct JunitSuite {
  std::string name, package;
  std::vector<std::pair<std::string, std::string>> properties = {};
  std::vector<JunitCase> cases = {};
  double seconds = 0;
  std::string said = {};  ///< system-out
};

/// A whole file: tests/drivers/junit.rng describes it.
std::string junit_text(const std::vector<JunitSuite>& suites);

/// Before work whose findings go to that file ("-" or empty: none): a file of earlier work is removed, so that nobody
/// takes it for this one's.
void remove_earlier_junit(const std::string& file);

/// Throws SystemError where the file's folder is missing, unless it lies in `made`, a folder that the work makes.
void require_junit_folder(const std::string& file, const std::string& made);

}  // namespace assay::drivers
