// SPDX-License-Identifier: BSD-3-Clause
// Maps of YAML as rows: a key, how its value is read, and how it is written. A struct lists its rows once.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/format/yaml_values.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

struct YamlRow {
  const char* name;
  std::function<void(const Tree& value, const std::string& key)> read;
  std::function<std::string()> written;  ///< YAML; empty: nothing. What begins with a line break is a block of lines
  bool* said = nullptr;                  ///< whether the key is there; the writer leaves out what nobody has said
};
using YamlRows = std::vector<YamlRow>;

/// The value is written where it is finite.
YamlRow number_row(const char* name, double& value, const Range& range = {}, bool* said = nullptr);
/// From 1 to `most`; a 1 is written where `always`.
YamlRow count_row(const char* name, int& value, int most, bool always = false);
/// Written unless it is empty, or `always`.
YamlRow text_row(const char* name, std::string& value, bool always = false);
/// `value` is the place of the word in its list: an enumeration, or true for the second one.
template <class T>
YamlRow word_row(const char* name, T& value, const std::vector<std::string>& words, bool* said = nullptr) {
  return {name,
          [&value, words](const Tree& tree, const std::string& key) {
            value = static_cast<T>(index_of(choice_value(tree, key, words), words));
          },
          [&value, words] { return words[static_cast<std::size_t>(value)]; }, said};
}

/// Reads what is there.
void read_rows(const Tree& map, const std::string& path, const YamlRows& rows);
/// The same where other keys are refused.
void read_only_rows(const Tree& map, const std::string& path, const YamlRows& rows);

std::vector<std::string> names_of(const YamlRows& rows);

/// "{value: 1, unit: Pa}", "[a, b]" and a line for each key.
std::string flow_map(const YamlRows& rows);
std::string flow_list(const std::vector<std::string>& values);
std::string yaml_lines_of(const YamlRows& rows);

}  // namespace assay::drivers
