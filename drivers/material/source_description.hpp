// SPDX-License-Identifier: BSD-3-Clause
// From a Fortran source to the description of a foreign model, a file to be edited: what was given, what the text
// tells, what is not known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/source_entry.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// A constant of PROPS; without a name it is p1, p2, ...
struct GivenProperty {
  std::string name;
  double value = 0;
};

/// What a user says of a source beside its name.
struct SourceRequest {
  std::optional<std::vector<GivenProperty>> props;
  std::optional<int> statev;
  std::string deck;      ///< absolute; empty: none
  std::string material;  ///< of the deck, or CMNAME
  std::string symbol;
  std::vector<std::string> link;     ///< words of linked_word()
  std::size_t least_properties = 0;  ///< so many have names that somebody knows: p1, p2, ...
  bool needs_values = false;         ///< PROPS without values are refused
  std::string material_key = "FILE.inp:NAME", symbol_key = "FILE.f:NAME";  ///< how to choose, in messages
};

struct SourceDescription {
  std::string name;                   ///< of the model: the source's, in small letters
  std::string text;                   ///< YAML, with comments
  std::vector<std::string> notes;     ///< sentences: what was taken and guessed
  std::vector<std::string> warnings;  ///< sentences: what is probably not meant
};

/// A Fortran source or an Abaqus deck, which stands for the source of the same name beside it.
bool is_source_or_deck(const std::string& file);

/// Compiles it and describes it. file: absolute, of a source or a deck. Throws InputError at `where`, `key`, or at the
/// line of the source or the deck; SystemError.
SourceDescription describe_source(const std::string& file, const SourceRequest& request, const Location& where,
                                  const std::string& key);

}  // namespace assay::drivers
