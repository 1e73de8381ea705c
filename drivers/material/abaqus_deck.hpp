// SPDX-License-Identifier: BSD-3-Clause
// What an Abaqus input file says of a material of a user's routine.
#pragma once

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

}  // namespace assay::drivers
