// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_description.hpp"

#include <algorithm>
#include <cctype>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "adapters/library.hpp"

namespace assay::drivers {

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

MaterialDescription mfront_description(MaterialDescription description, const std::vector<std::string>& behaviours) {
  std::string asked = description.name.empty() && behaviours.size() == 1 ? behaviours.front() : description.name;
  for (const std::string& behaviour : behaviours) {
    if (lower_case(behaviour) == asked) asked = behaviour;  // by the name that its model has here
  }
  if (std::find(behaviours.begin(), behaviours.end(), asked) == behaviours.end()) {
    const std::string what = asked.empty() ? "holds several behaviours of MFront: ask for one as 'lib.so:NAME'"
                                           : "has no behaviour '" + one_line(asked, 80) + "'";
    throw InputError(description.library_where, description.library_key, "'" + description.library + "' " + what,
                     joined(behaviours));
  }
  adapters::ForeignModel model;
  model.interface = adapters::ForeignInterface::mfront;
  model.library = description.library;
  model.symbol = asked;
  description.name = model.name = lower_case(asked);
  model.temperature = 293.15;
  description.foreign = std::move(model);
  return description;
}

/// Throws InputError where a library is one of those that need a description.
void refuse_subroutines(const MaterialDescription& description, const std::vector<std::string>& symbols) {
  for (const std::string word : {"vumat", "umat"}) {
    const std::vector<std::string> found = subroutines_in(symbols, word);
    if (found.empty()) continue;
    throw InputError(description.library_where, description.library_key,
                     "'" + description.library + "' exports '" + found.front() + "', a " +
                         (word == "umat" ? "UMAT" : "VUMAT") + ": it needs a description, a YAML file with library, " +
                         "interface: " + word + (found.front() == word + "_" ? "" : ", symbol: " + found.front()) +
                         ", properties and state");
  }
}

}  // namespace

void refuse_undeclared_interface(const MaterialDescription& description) {
  try {
    const std::vector<std::string> symbols = adapters::exported_symbols(description.library);
    if (std::binary_search(symbols.begin(), symbols.end(), "assay_material_entry")) return;
    std::string interface = adapters::mfront_behaviours(description.library).empty() ? "" : "mfront";
    for (const char* word : {"vumat", "umat"}) {
      if (interface.empty() && !subroutines_in(symbols, word).empty()) interface = word;
    }
    if (interface.empty()) return;
    throw InputError(
        description.library_where, description.library_key,
        "'" + description.library + "' is no plug-in of the ABI: the description lacks interface: " + interface);
  } catch (const adapters::LibraryError&) {
  }
}

std::vector<std::string> subroutines_in(const std::vector<std::string>& symbols, const std::string& word) {
  std::vector<std::string> found;
  for (const std::string& symbol : symbols) {
    const std::string name = lower_case(symbol);
    const bool named = name == word || name == word + "_";
    if (named) found.insert(found.begin(), symbol);
    if (!named && name.starts_with(word + "_") && name.ends_with("_")) found.push_back(symbol);
  }
  return found;
}

MaterialDescription description_of_library(const std::string& library, const std::string& table, const Location& where,
                                           const std::string& key) {
  MaterialDescription description;
  description.library = library;
  description.name = table;
  description.library_where = description.name_where = where;
  description.library_key = key;
  try {
    const std::vector<std::string> symbols = adapters::exported_symbols(library);
    if (std::binary_search(symbols.begin(), symbols.end(), "assay_material_entry")) return description;
    const std::vector<std::string> behaviours = adapters::mfront_behaviours(library);
    if (!behaviours.empty()) return mfront_description(std::move(description), behaviours);
    refuse_subroutines(description, symbols);
  } catch (const adapters::LibraryError&) {
    return description;
  }
  return description;
}

}  // namespace assay::drivers
