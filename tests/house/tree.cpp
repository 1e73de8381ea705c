// SPDX-License-Identifier: BSD-3-Clause
#include "tests/house/tree.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::house {

namespace fs = std::filesystem;

namespace {

const fs::path& root() {
  static const fs::path path{tree_folder()};
  return path;
}

bool has_one_of(const fs::path& file, const std::vector<std::string>& extensions) {
  return extensions.empty() ||
         std::find(extensions.begin(), extensions.end(), file.extension().string()) != extensions.end();
}

}  // namespace

std::vector<std::string> files_in(const std::string& folder, const std::vector<std::string>& extensions, bool deep) {
  std::vector<std::string> found;
  const auto take = [&](const fs::directory_entry& entry) {
    if (entry.is_regular_file() && has_one_of(entry.path(), extensions)) {
      found.push_back(fs::relative(entry.path(), root()).string());
    }
  };
  if (deep) {
    for (const auto& entry : fs::recursive_directory_iterator(root() / folder)) take(entry);
  } else {
    for (const auto& entry : fs::directory_iterator(root() / folder)) take(entry);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string text_of(const std::string& path) {
  std::ifstream in(root() / path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex form(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> found;
  int number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, form)) found.push_back({number, match[2], match[1] == "\""});
  }
  return found;
}

Outcome run_assay(const std::string& arguments) {
  const std::string command = "'" + built("assay") + "' " + arguments + " </dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run " + command);
  Outcome outcome;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.output.append(buffer, n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  return outcome;
}

std::vector<std::string> verbs() {
  static const std::regex form(R"(^ {1,8}([a-z][a-z-]+)( |$))");
  std::vector<std::string> found;
  bool listed = false;
  for (const std::string& line : lines_of(run_assay("--help").output)) {
    std::smatch match;
    if (std::regex_search(line, std::regex("^(Subcommands|Verbs|verbs|Commands):"))) {
      listed = true;
    } else if (line.empty()) {
      listed = false;  // examples
    } else if (listed && std::regex_search(line, match, form)) {
      found.push_back(match[1]);
    }
  }
  return found;
}

}  // namespace assay::house
