// SPDX-License-Identifier: BSD-3-Clause
// Typed values out of a YAML tree, one by one or as the rows of a struct: a key, how its value is read, and how it is
// written. Each function that reads throws InputError at the value's place, naming `key`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/text/words.hpp"
#include "harness/numeric/range.hpp"

namespace assay::drivers {

using assay::positive;
using assay::Range;

/// Throws InputError at the value.
[[noreturn]] void refuse_value(const Tree& tree, const std::string& key, const std::string& what,
                               const std::string& known = {});

/// Finite, in range.
double number_value(const Tree& tree, const std::string& key, const Range& range = {});
bool boolean_value(const Tree& tree, const std::string& key);
/// Any scalar as it stands, without line breaks at its end.
std::string text_value(const Tree& tree, const std::string& key);

/// source: what lists all the words where they are many.
std::string choice_value(const Tree& tree, const std::string& key, const std::vector<std::string>& known,
                         const std::string& source = "`assay schema`");
/// Exactly `rows` rows of `columns` numbers, row by row; one row is a plain sequence.
std::vector<double> numbers_value(const Tree& tree, const std::string& key, std::size_t rows, std::size_t columns,
                                  const Range& range = {});

void require_map(const Tree& tree, const std::string& key, const std::string& known);
/// `prefix` is the path of the map, empty at the top.
void refuse_unknown_keys(const Tree& map, const std::string& prefix, const std::vector<std::string>& known);

/// "text 'abc'", "a list", "a map", "nothing": for messages.
std::string described(const Tree& tree);

/// prefix.key, or key at the top.
std::string key_path(const std::string& prefix, const std::string& key);
/// "body.per_cell[1]": value number `index`, from 0, of the list at the path.
std::string item_path(const std::string& list, std::size_t index);
/// Of "motion.amplitude.peak" "motion.amplitude"; empty at the top.
std::string parent_of(const std::string& path);
/// And "peak".
std::string last_part(const std::string& path);

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
