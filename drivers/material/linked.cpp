// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/linked.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

bool is_file(const std::string& word) { return word.find('/') != word.npos; }

/// As the linker's -l takes it: no option, no list.
bool is_plain_name(const std::string& name) {
  return !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '.' || c == '+';
  });
}

}  // namespace

std::string linked_word(const std::string& said, const std::string& folder, const Location& where,
                        const std::string& key) {
  const std::string extension = fs::path(said).extension().string();
  const bool object = extension == ".a" || extension == ".o" || extension == ".so";
  std::error_code code;
  std::string file = absolute_path(fs::path(folder) / said);
  if (!is_file(said) && !object && !fs::exists(file, code)) {
    if (is_plain_name(said)) return said;
    throw InputError(
        where, key,
        "must be the name of a library (lapack) or a file (.a, .o, .so), found '" + one_line(said, 80) + "'");
  }
  if (object && fs::is_regular_file(file, code)) return file;
  throw InputError(where, key,
                   "'" + one_line(file, 200) +
                       (fs::exists(file, code) ? "' is no library and no object (.a, .o, .so)" : "': no such file"));
}

std::vector<std::string> link_arguments(const std::string& word) {
  if (!is_file(word)) return {"-l" + word};
  if (!word.ends_with(".so")) return {word};
  return {word, "-Wl,-rpath," + fs::path(word).parent_path().string()};
}

std::string link_content(const std::string& word) { return is_file(word) ? word + "\n" + read_bytes(word) : word; }

}  // namespace assay::drivers
