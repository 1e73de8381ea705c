// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/junit.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "drivers/picture/drawing.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

namespace {

constexpr const char* file_begin = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

/// [s], as a decimal: schemas know no exponents.
std::string decimal(double seconds) { return fmt::format("{:.{}f}", seconds, seconds == 0 || seconds >= 0.1 ? 3 : 6); }

/// "2026-11-20T22:38:27", UTC.
std::string timestamp() { return fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(std::time(nullptr))); }

std::string case_text(const JunitCase& one) {
  const std::string head = "    <testcase" + attribute("classname", one.classname) + attribute("name", one.name) +
                           attribute("time", one.seconds == 0 ? "0" : decimal(one.seconds));
  if (one.kind == JunitCase::Kind::passed) return head + "/>\n";
  if (one.kind == JunitCase::Kind::skipped) {
    return head + ">\n      <skipped" + attribute("message", one.message) + "/>\n    </testcase>\n";
  }
  const std::string tag = one.kind == JunitCase::Kind::failure ? "failure" : "error";
  // Some servers show the attribute and some the text of the element: both say why.
  const std::string why = one.message + (one.text.empty() ? "" : "\n" + one.text);
  return head + ">\n      <" + tag + attribute("message", one.message) + attribute("type", one.type) + ">" +
         escaped(why) + "</" + tag + ">\n    </testcase>\n";
}

/// In the order and with the attributes that Ant's schema and that of Jenkins ask for.
std::string suite_text(const JunitSuite& suite, std::size_t id) {
  const auto count = [&](JunitCase::Kind kind) {
    return std::to_string(
        std::count_if(suite.cases.begin(), suite.cases.end(), [&](const JunitCase& one) { return one.kind == kind; }));
  };
  std::string page =
      "  <testsuite" + attribute("name", suite.name) + attribute("package", suite.package) +
      attribute("id", std::to_string(id)) + attribute("timestamp", timestamp()) + attribute("hostname", "localhost") +
      attribute("tests", std::to_string(suite.cases.size())) + attribute("failures", count(JunitCase::Kind::failure)) +
      attribute("errors", count(JunitCase::Kind::error)) + attribute("skipped", count(JunitCase::Kind::skipped)) +
      attribute("time", decimal(suite.seconds)) + ">\n    <properties>\n";
  for (const auto& [name, value] : suite.properties) {
    page += "      <property" + attribute("name", name) + attribute("value", value) + "/>\n";
  }
  page += "    </properties>\n";
  for (const JunitCase& one : suite.cases) page += case_text(one);
  return page + "    <system-out>" + escaped(suite.said) + "</system-out>\n    <system-err/>\n  </testsuite>\n";
}

}  // namespace

std::string junit_text(const std::vector<JunitSuite>& suites) {
  std::string page = file_begin;
  for (std::size_t id = 0; id < suites.size(); ++id) page += suite_text(suites[id], id);
  return page + "</testsuites>\n";
}

void require_junit_folder(const std::string& file, const std::string& made) {
  if (file.empty() || file == standard_stream) return;
  namespace fs = std::filesystem;
  std::error_code code;
  const std::string folder = fs::path(absolute_path(file)).parent_path().string(), ours = absolute_path(made);
  const bool is_made = folder == ours || folder.starts_with(ours + "/");
  if (!is_made && !fs::is_directory(folder, code)) fail(file, "cannot be created", ENOENT);
}

void remove_earlier_junit(const std::string& file) {
  if (file.empty() || file == standard_stream) return;
  namespace fs = std::filesystem;
  std::error_code code;
  const fs::path path = file;
  if (!fs::is_regular_file(path, code)) return;
  const std::string ours = std::string(file_begin) + "  <testsuite name=\"assay";
  std::string begin(ours.size(), '\0');
  std::ifstream earlier(path, std::ios::binary);
  earlier.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (begin == ours) fs::remove(path, code);
}

}  // namespace assay::drivers
