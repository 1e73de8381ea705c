// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_facts.hpp"

#include <algorithm>
#include <cctype>

#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Of several arrays together: old and new state of a VUMAT.
ArrayUse use_of_any(const std::vector<FortranStatement>& statements, const std::vector<std::string>& arrays) {
  ArrayUse all;
  for (const std::string& array : arrays) {
    const ArrayUse one = use_of(statements, array);
    all.used = all.used || one.used;
    all.whole = all.whole && one.whole;
    all.largest = std::max(all.largest, one.largest);
  }
  return all;
}

bool uses_any(const std::vector<FortranStatement>& statements, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return uses(statements, name); });
}

/// "emod=props(1)".
std::map<int, std::string> property_names(const std::vector<FortranStatement>& statements, const std::string& props) {
  std::map<int, std::string> names;
  for (const FortranStatement& statement : statements) {
    const std::string& text = statement.text;
    const std::size_t equals = text.find("=" + props + "(");
    if (equals == text.npos || equals == 0 || !text.ends_with(')')) continue;
    const std::size_t begin = equals + props.size() + 2;
    const auto index = parse_integer(text.substr(begin, text.size() - 1 - begin));
    const std::string name = text.substr(0, equals);
    const bool plain =
        std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (index && *index > 0 && *index < 100000 && plain) names.emplace(static_cast<int>(*index), name);
  }
  return names;
}

}  // namespace

SourceFacts facts_of(const FortranSource& source, const SourceEntry& entry) {
  const EntryNames names = names_of_entry(entry);
  const std::vector<FortranStatement>& all = source.statements;
  const bool umat = entry.interface == adapters::ForeignInterface::umat;
  SourceFacts facts;
  facts.props = use_of(all, names.props);
  facts.state = use_of_any(all, names.state);
  facts.property_names = property_names(all, names.props);
  facts.uses_duration = uses(all, names.dtime);
  const bool gradients = uses_any(all, names.gradients), strains = uses_any(all, names.strains);
  facts.finite_strain = umat && gradients && !strains;
  if (facts.uses_duration) {
    facts.sentences.emplace_back(std::string(umat ? "DTIME" : "dt") +
                                 " is used: if the stress depends on the rate, write flags: [rate_dependent]");
  }
  if (umat && facts.state.used && !gradients && !uses_any(all, names.rotations)) {
    facts.sentences.emplace_back(
        "neither DROT nor ROTSIG nor DFGRD1 is used: a tensor in STATEV would not rotate with the body");
  }
  if (facts.finite_strain) {
    facts.sentences.emplace_back(
        "the source reads DFGRD1 and no strain: DDSDDE may be for finite strain (then declare strain: finite)");
  }
  return facts;
}

DeckDensity density_of(double value) {
  constexpr double tonne_per_mm3 = 1e12, pound_s2_per_in4 = 1.0686895e7;  // [kg/m^3]
  DeckDensity density{value, "", "", ""};
  const std::string said = "density " + rounded_text(value, 6) + " of *Density";
  if (value > 1e-10 && value < 1e-7) {
    density = {value * tonne_per_mm3, "MPa", "mm", said + " can only be t/mm^3: units {stress: MPa, length: mm}"};
  } else if (value > 1e-5 && value < 1e-2) {
    density = {value * pound_s2_per_in4, "psi", "in",
               said + " can only be lbf s^2/in^4: units {stress: psi, length: in}"};
  } else {
    density.words = said + " is taken for kg/m^3, and stresses for Pa";
  }
  return density;
}

}  // namespace assay::drivers
