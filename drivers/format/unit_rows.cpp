// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/unit_rows.hpp"

#include <algorithm>

namespace assay::drivers {

namespace {

double si_of(const std::string& word) { return parse_unit(word)->scale.to_si(1); }

}  // namespace

Range in_units(const Range& si, const Scale& scale) {
  Range own = si;
  own.lower = scale.from_si(si.lower), own.upper = scale.from_si(si.upper);
  return own;
}

YamlRow unit_row(const char* name, double& value, const std::vector<std::string>& words) {
  return {name,
          [=, &value](const Tree& tree, const std::string& key) { value = si_of(choice_value(tree, key, words)); },
          [=, &value] {
            const auto found = std::ranges::find_if(words, [&](const auto& word) { return si_of(word) == value; });
            return found == words.end() ? std::string() : *found;
          }};
}

}  // namespace assay::drivers
