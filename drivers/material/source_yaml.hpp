// SPDX-License-Identifier: BSD-3-Clause
// The description of a source as a file to be edited.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/source_description.hpp"
#include "drivers/material/source_facts.hpp"

namespace assay::drivers {

struct SourceYaml {
  std::string source, deck;  ///< absolute
  std::string name, material_name;
  std::vector<std::string> link;  ///< words of linked_word()
  SourceEntry entry;
  SourceFacts facts;
  std::vector<GivenProperty> properties;  ///< NaN: to be given by whoever uses it
  std::string properties_from;            ///< "--props", "*User Material", "its text"; empty: there are none
  int state = 0;
  std::vector<DeckVariable> variables;  ///< names of some of them
  std::string state_from;
  std::optional<DeckDensity> density;
};

std::string source_yaml(const SourceYaml& yaml);

}  // namespace assay::drivers
