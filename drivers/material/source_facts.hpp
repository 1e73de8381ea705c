// SPDX-License-Identifier: BSD-3-Clause
// What the text of a routine lets one guess.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drivers/material/fortran_routines.hpp"
#include "drivers/material/source_entry.hpp"

namespace assay::drivers {

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

}  // namespace assay::drivers
