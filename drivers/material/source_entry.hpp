// SPDX-License-Identifier: BSD-3-Clause
// The entry point of a Fortran source, which of its routines Abaqus would call; what its text lets one guess; and what
// it compiles with although its author did not mean it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/material/fortran_source.hpp"
#include "drivers/material/fortran_text.hpp"

namespace assay::drivers {

/// What Abaqus hands over, by the names of its manual, in small letters; a routine may call them otherwise.
const std::vector<std::string>& usual_arguments(adapters::ForeignInterface interface);

/// What it is called by its users: "UMAT", "USERMAT", "user material of LS-DYNA".
std::string capital_name(adapters::ForeignInterface interface);

/// The arrays of the constants and of the state, as the manual of an interface has them: PROPS and STATEV, cm and hsv.
std::string constants_word(adapters::ForeignInterface interface);
std::string state_word(adapters::ForeignInterface interface);

/// umat41 to umat50.
bool is_name_of_lsdyna(const std::string& name);
/// Whether it has such a routine, in its scalar form: reals have 8 bytes there, whatever is declared.
bool is_of_lsdyna(const FortranSource& source);

/// Whether it has a routine of Ansys or LS-DYNA, by its name: how their compilers read columns is not known.
bool is_of_other_vendor(const FortranSource& source);

/// Letters, digits and underscores: no element of an array.
bool is_plain_variable(const std::string& name);

struct SourceEntry {
  std::string symbol;  ///< in the library
  adapters::ForeignInterface interface = adapters::ForeignInterface::umat;
  FortranRoutine routine;  ///< without arguments where the text has none of that name
};

/// By the names of the library's symbols and the numbers of their arguments: 37 of a UMAT, 33 of a VUMAT. By their
/// names: usermat of 41 or 42 arguments, umat41 to umat50 of 12, 13, 16 or 18.
/// The plain names umat and vumat go before others, as in Abaqus. asked: a name, with or without its underscore, in any
/// letters; empty: the only one. Throws InputError at the source: none, or several; `key` names the choice.
SourceEntry entry_of_source(const FortranSource& source, const std::vector<std::string>& symbols,
                            const std::string& asked, const std::string& key);

/// The dummy arguments that an interface has at the places of these: props, statev, dtime, drot, ... For a routine
/// whose arguments are not known, the usual names.
struct EntryNames {
  std::string props = "props", dtime = "dtime";
  std::vector<std::string> state{"statev"}, strains, gradients, rotations;
};

EntryNames names_of_entry(const SourceEntry& entry);

/// The entry of a symbol, which need not be there; nothing where it is neither a UMAT nor a VUMAT.
std::optional<SourceEntry> entry_named(const FortranSource& source, const std::string& symbol);

struct SourceFacts {
  ArrayUse props, state;
  std::map<int, std::string> property_names;  ///< of "EMOD = PROPS(1)": what the source calls it
  bool uses_duration = false;                 ///< DTIME
  bool finite_strain = false;                 ///< it reads F, and no strain
  std::vector<std::string> sentences;         ///< what may follow, and is not assumed
};

SourceFacts facts_of(const FortranSource& source, const SourceEntry& entry);

/// A deck's density, of which the size tells the units.
struct DeckDensity {
  double si = 0;               ///< [kg/m^3]
  std::string stress, length;  ///< units of the model; empty: SI, or not told
  std::string words;           ///< a sentence
};

DeckDensity density_of(double value);

/// Sentences on a list of arguments that is not what Abaqus hands over, in their number or by their names in another
/// order; on arguments whose declared size is another: integers of 8 bytes, reals of 4. And on reals of 4 bytes
/// that take a property.
std::vector<std::string> entry_traps(const FortranSource& source, const SourceEntry& entry);

/// The same of a symbol, which need not be there.
std::vector<std::string> entry_traps(const FortranSource& source, const std::string& symbol);

}  // namespace assay::drivers
