// SPDX-License-Identifier: BSD-3-Clause
// What an Abaqus input file says of a material of a user's routine: its keyword blocks, and their material.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// Of *Depvar: "3, PEEQ, "equivalent plastic strain"".
struct DeckVariable {
  int number = 0;
  std::string name, doc;
};

struct DeckMaterial {
  std::string name;               ///< as it stands: CMNAME in capitals
  std::vector<double> constants;  ///< of *User Material, type MECHANICAL
  int depvar = 0;                 ///< of *Depvar
  std::vector<DeckVariable> variables;
  std::optional<double> density;      ///< of *Density, in the deck's own units
  std::vector<std::string> notes;     ///< sentences: what was seen and not taken
  std::vector<std::string> warnings;  ///< sentences: what is not there, and may say of the material what nobody knows
};

/// The material of that name, in small or large letters; empty: the only one that has *User Material. Throws InputError
/// at the line to blame; `key` names the choice among several materials.
DeckMaterial read_deck(const std::string& file, const std::string& asked, const std::string& key);

/// A number as Abaqus and Fortran write it: 1.d5 too. Nothing for what is none.
std::optional<double> deck_number(std::string text);

/// A keyword, which may be cut after `least` letters: Abaqus knows it by as many.
struct Keyword {
  const char* whole;
  std::size_t least;
};

struct DeckLine {
  Location where;
  std::vector<std::string> items;  ///< between commas, without blanks around them
};

/// "*User Material, constants=8" and the data lines below it. Words are in small letters and without blanks, values as
/// they stand and without quotes.
struct DeckBlock {
  std::string keyword;  ///< "usermaterial"
  std::map<std::string, std::string> parameters;
  Location where;
  std::vector<DeckLine> data;

  bool is(const Keyword& known) const;
  /// The value of a parameter, which may be cut after `least` letters; empty where it has none.
  std::string value(const std::string& parameter, std::size_t least = std::string::npos) const;
};

/// The blocks whose keyword `wanted` takes, in their order; *Include is followed. What cannot be included is told in
/// `notes`. Throws InputError where the file cannot be read.
std::vector<DeckBlock> deck_blocks(const std::string& file, bool (*wanted)(const DeckBlock& block),
                                   std::vector<std::string>& notes);

}  // namespace assay::drivers
