// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_description.hpp"

#include <cmath>
#include <set>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/words.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

namespace {

/// In a comment: no line end, whatever a path holds.
std::string comment(const std::string& text) { return "# " + one_line(text) + "\n"; }

std::string with_comment(const std::string& line, const std::string& text) {
  constexpr std::size_t column = 26;
  if (text.empty()) return line + "\n";
  return line + std::string(line.size() < column ? column - line.size() : 1, ' ') + comment(text);
}

std::string properties_text(const SourceYaml& yaml) {
  if (yaml.properties.empty()) return {};
  std::string text = with_comment("properties:", "PROPS, in this order, from " + yaml.properties_from);
  for (std::size_t k = 0; k < yaml.properties.size(); ++k) {
    const GivenProperty& p = yaml.properties[k];
    const std::string name = p.name.empty() ? "p" + std::to_string(k + 1) : p.name;
    const auto known = yaml.facts.property_names.find(static_cast<int>(k + 1));
    text += with_comment("  " + yaml_scalar(name) + ": " + (std::isfinite(p.value) ? yaml_number(p.value) : "~"),
                         known == yaml.facts.property_names.end() ? "" : known->second + " in the source");
  }
  return text;
}

/// The deck's names where they can serve: as keys, each once.
std::string named_state_text(const SourceYaml& yaml) {
  std::vector<std::string> names(static_cast<std::size_t>(yaml.state)), docs(names.size());
  for (const DeckVariable& variable : yaml.variables) {
    names[static_cast<std::size_t>(variable.number - 1)] = variable.name;
    docs[static_cast<std::size_t>(variable.number - 1)] = variable.doc;
  }
  std::set<std::string> seen;
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::string name = names[k];
    if (!can_be_a_key(name) || !seen.insert(name).second) {
      if (docs[k].empty()) docs[k] = name;
      seen.insert(name = "s" + std::to_string(k + 1));
    }
    const std::string value = docs[k].empty() ? "scalar" : "{kind: scalar, doc: " + yaml_scalar(docs[k]) + "}";
    text += "  " + yaml_scalar(name) + ": " + value + "\n";
  }
  return text;
}

std::string state_yaml(const SourceYaml& yaml) {
  if (yaml.state == 0) return {};
  const std::string advice =
      yaml.state >= 6 ? "; declare the tensors among them: {back_stress: symmetric_tensor, p: scalar}" : "";
  const std::string of = "STATEV, in this order, from " + yaml.state_from + advice;
  if (yaml.variables.empty()) return with_comment("state: " + std::to_string(yaml.state), of);
  return with_comment("state:", of) + named_state_text(yaml);
}

}  // namespace

std::string source_yaml(const SourceYaml& yaml) {
  constexpr std::size_t longest_name = 80;  // CMNAME
  const bool umat = yaml.entry.interface == adapters::ForeignInterface::umat;
  std::string text = comment("What assay takes " + yaml.source + " for" +
                             (yaml.deck.empty() ? "" : ", by " + yaml.deck) + ". Made to be edited:");
  text += comment("assay check, run, register and the other verbs take this file.");
  for (const std::string& sentence : yaml.facts.sentences) text += comment("Not assumed: " + sentence);
  text += with_comment("source: " + yaml_scalar(yaml.source), "compiled when it has changed");
  if (!yaml.link.empty()) text += with_comment("link: " + yaml_list(yaml.link), "of --link");
  text += "name: " + yaml_scalar(yaml.name) + "\n";
  text += with_comment(std::string("interface: ") + (umat ? "umat" : "vumat"), "by its entry");
  text += "symbol: " + yaml_scalar(yaml.entry.symbol) + "\n";
  text += properties_text(yaml) + state_yaml(yaml);
  if (umat)
    text += with_comment("# strain: finite", "where DDSDDE is that of J sigma with Jaumann's rate; small otherwise");
  text += with_comment("# flags: [non_smooth]", "what yields, breaks or touches; rate_dependent: what flows with time");
  if (!yaml.material_name.empty())
    text += "material_name: " + yaml_scalar(capital_letters(yaml.material_name).substr(0, longest_name)) + "\n";
  if (!yaml.density) return text;
  text += with_comment("density: " + yaml_number(yaml.density->si), "kg/m^3");
  if (!yaml.density->stress.empty()) {
    text += "units: {stress: " + yaml.density->stress + ", length: " + yaml.density->length + "}\n";
  }
  return text;
}

}  // namespace assay::drivers
