// SPDX-License-Identifier: BSD-3-Clause
// Typed values out of a YAML tree. Each function throws InputError at the value's place, naming `key`.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
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
/// Of "motion.amplitude.peak" "motion.amplitude"; empty at the top.
std::string parent_of(const std::string& path);

}  // namespace assay::drivers
