// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line/next_steps.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;

constexpr const char* program_name = "assay";

/// CMake's prefix of a folder with programs.
fs::path prefix_of(const fs::path& folder) { return folder.filename() == "bin" ? folder.parent_path() : folder; }

/// Whether CMake finds the package below that prefix.
bool holds_package(const fs::path& prefix) {
  std::error_code ignored;
  const auto is_there = [&](const fs::path& folder) { return fs::exists(folder / "assay-config.cmake", ignored); };
  if (is_there(prefix / "cmake")) return true;
  for (const char* folder : {"lib", "lib64", "share"}) {
    if (is_there(prefix / folder / "cmake" / program_name)) return true;
  }
  for (fs::directory_iterator at(prefix / "lib", ignored), end; !ignored && at != end; at.increment(ignored)) {
    if (is_there(at->path() / "cmake" / program_name)) return true;  // of an architecture
  }
  return false;
}

/// The folder of the first program of that name on PATH; empty where there is none.
fs::path folder_on_path() {
  const char* value = std::getenv("PATH");
  const std::string path = value ? value : "";
  for (std::size_t begin = 0; begin < path.size();) {
    const std::size_t colon = std::min(path.find(':', begin), path.size());
    fs::path folder = path.substr(begin, colon - begin);
    std::error_code ignored;
    if (folder.is_absolute() && fs::is_regular_file(folder / program_name, ignored)) return folder;
    begin = colon + 1;
  }
  return {};
}

std::string with_word(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; at += by.size()) text.replace(at, word.size(), by);
  return text;
}

}  // namespace

std::string shell_word(const std::string& word) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.' || c == '/' || c == '+'; };
  return std::all_of(word.begin(), word.end(), plain) ? word : "'" + with_word(word, "'", "'\\''") + "'";
}

std::string next_steps(const std::string& folder, const std::string& run) {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error), there = folder_on_path();
  const bool on_path = !there.empty() && fs::equivalent(there / program_name, here, error);
  std::string configure = "cmake -B build";
  if (!on_path || !holds_package(prefix_of(there))) {
    const fs::path prefix = prefix_of(here.parent_path());
    configure += holds_package(prefix) ? " -D CMAKE_PREFIX_PATH=" + shell_word(prefix.string())
                                       : "   # with -D CMAKE_PREFIX_PATH=(where assay is installed)";
  }
  const std::string command = on_path ? run : with_word(run, "assay run", shell_word(here.string()) + " run");
  // A name that begins with a hyphen would be an option.
  return "  cd " + one_line(shell_word(folder.starts_with('-') ? "./" + folder : folder)) + "\n  " + configure +
         "\n  cmake --build build\n  ctest --test-dir build  # assay check\n  " + command + "\n";
}

}  // namespace assay::drivers
