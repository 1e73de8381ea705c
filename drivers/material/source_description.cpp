// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_description.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "adapters/elf_symbols.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/material/foreign_description.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/text/words.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// "; model.inp beside it may have them: --deck model.inp".
std::string deck_hint(const std::string& source) {
  const fs::path deck = fs::path(source).replace_extension(".inp");
  std::error_code code;
  if (!fs::is_regular_file(deck, code)) return {};
  return "; " + deck.filename().string() + " beside it may have them: --deck " + deck.filename().string();
}

/// In a comment: no line end, whatever a path holds.
std::string comment(const std::string& text) { return "# " + one_line(text) + "\n"; }

std::string with_comment(const std::string& line, const std::string& text) {
  constexpr std::size_t column = 26;
  if (text.empty()) return line + "\n";
  return line + std::string(line.size() < column ? column - line.size() : 1, ' ') + comment(text);
}

class Describer {
 public:
  Describer(const std::string& file, const SourceRequest& request, const Location& where, const std::string& key)
      : request_(request), where_(where), key_(key) {
    const bool by_deck = is_deck(file);
    const std::string source = by_deck ? source_beside(file, where, key) : file;
    deck_file_ = by_deck ? file : request.deck;
    source_ = read_fortran_source(source, where, key);
    source_.link = request.link;
    if (!deck_file_.empty()) deck_ = read_deck(deck_file_, request.material, request.material_key);
    library_ = library_of_source(source_);
    entry_ = entry_of_source(source_, adapters::exported_symbols(library_.file), request.symbol, request.symbol_key);
    facts_ = facts_of(source_, entry_);
    constants_ = constants_word(entry_.interface);
    variables_word_ = state_word(entry_.interface);
    name_ = as_name(fs::path(source).stem().string());
  }

  SourceDescription described() {
    SourceDescription result;
    result.name = name_;
    take_properties();
    take_state();
    if (deck_ && deck_->density && *deck_->density > 0) density_ = density_of(*deck_->density);
    result.text = yaml();
    result.notes = notes();
    result.warnings = source_.warnings;
    if (deck_) append_all(result.warnings, deck_->warnings);
    append_all(result.warnings, library_.warnings);
    append_all(result.warnings, entry_traps(source_, entry_));
    warn_of_too_few(facts_.props, constants_, properties_.size(), result.warnings);
    warn_of_too_few(facts_.state, variables_word_, static_cast<std::size_t>(state_), result.warnings);
    return result;
  }

 private:
  std::string uses_of(const ArrayUse& use, const std::string& array) const {
    if (!use.used) return "the source uses none";
    const std::string largest = array + "(" + std::to_string(use.largest) + ")";
    if (use.whole) return "the source reads " + array + "(1) to " + largest;
    return use.largest > 0 ? "the source reads " + largest + ", and others by computed indices"
                           : "the source reads " + array + " by computed indices";
  }

  void take_properties() {
    const ArrayUse& use = facts_.props;
    if (request_.props) {
      properties_ = *request_.props;
      properties_from_ = "--props";
      refuse_exchanged_names();
    } else if (deck_) {
      for (const double value : deck_->constants) properties_.push_back({"", value});
      properties_from_ = "*User Material";
    } else if (use.used) {
      if (request_.needs_values) {
        throw InputError(
            {source_.file}, "--props",
            "required and not given: " + uses_of(use, constants_) + ", as --props 1000,.3" + deck_hint(source_.file));
      }
      refuse_what_is_not_told(use, constants_, request_.least_properties > 0);
      const auto count = std::max(static_cast<std::size_t>(use.largest), request_.least_properties);
      properties_.assign(count, {"", NAN});
      properties_from_ = "the source";
    }
  }

  /// PROPS are taken by their places: a name that the source has for another place is a slip.
  void refuse_exchanged_names() const {
    for (std::size_t k = 0; k < properties_.size(); ++k) {
      const std::string& name = properties_[k].name;
      for (const auto& [place, own] : facts_.property_names) {
        if (small_letters(name) != small_letters(own) || place == static_cast<int>(k + 1)) continue;
        throw InputError({}, "--props",
                         "'" + one_line(name, 60) + "' stands at place " + std::to_string(k + 1) + ", and in " +
                             source_.file + " it is PROPS(" + std::to_string(place) +
                             "): PROPS are taken in the order in which they are given");
      }
    }
  }

  void take_state() {
    const ArrayUse& use = facts_.state;
    if (request_.statev) {
      state_ = *request_.statev;
      state_from_ = "--statev";
    } else if (deck_) {
      state_ = deck_->depvar;
      variables_ = deck_->variables;
      state_from_ = "*Depvar";
    } else if (use.used) {
      if (request_.needs_values && !use.whole) {
        throw InputError({source_.file}, "--statev",
                         "required and not given: " + uses_of(use, variables_word_) + deck_hint(source_.file));
      }
      refuse_what_is_not_told(use, variables_word_, false);
      state_ = use.largest;
      state_from_ = "the source";
    }
  }

  /// Where nobody can be asked: a scene has no key for it.
  void refuse_what_is_not_told(const ArrayUse& use, const std::string& array, bool is_named) const {
    if (use.whole || is_named) return;
    throw InputError(where_, key_,
                     "'" + source_.file + "' does not tell how many " + array + " it needs (" + uses_of(use, array) +
                         "). `assay check " + fs::path(source_.file).filename().string() +
                         " --props ... --statev N` writes a description that does: name that in its place, or an "
                         "Abaqus deck " +
                         fs::path(source_.file).stem().string() + ".inp");
  }

  void warn_of_too_few(const ArrayUse& use, const std::string& array, std::size_t given,
                       std::vector<std::string>& warnings) const {
    if (!use.used || given >= static_cast<std::size_t>(std::max(use.largest, 1))) return;
    warnings.push_back(source_.file + ": uses " + array +
                       (use.largest > 0 ? "(" + std::to_string(use.largest) + ")" : "") + ", and there " +
                       (given == 1 ? "is 1" : "are " + std::to_string(given)));
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> all{source_note()};
    const auto count = [](std::size_t n, const std::string& what) { return std::to_string(n) + " " + what + " from "; };
    if (!properties_from_.empty()) {
      all.push_back(count(properties_.size(), constants_) + properties_from_ + "; " +
                    uses_of(facts_.props, constants_));
    }
    if (!state_from_.empty()) {
      all.push_back(
          count(static_cast<std::size_t>(state_), variables_word_) + state_from_ + "; " +
          uses_of(facts_.state, variables_word_) +
          (state_ >= 6 ? "; all are taken as scalars, because the source does not say which are tensors" : ""));
    }
    if (density_) all.push_back(density_->words);
    all.push_back(assumptions());
    append_all(all, facts_.sentences);
    if (deck_) append_all(all, deck_->notes);
    return all;
  }

  std::string yaml() const {
    constexpr std::size_t longest_name = 80;  // CMNAME
    const bool umat = entry_.interface == adapters::ForeignInterface::umat;
    std::string text = comment("What assay takes " + source_.file + " for" +
                               (deck_file_.empty() ? "" : ", by " + deck_file_) + ". Made to be edited:");
    text += comment("assay check, run, register and the other verbs take this file.");
    for (const std::string& sentence : facts_.sentences) text += comment("Not assumed: " + sentence);
    text += with_comment("source: " + yaml_scalar(source_.file), "compiled when it has changed");
    if (!request_.link.empty()) text += with_comment("link: " + yaml_list(request_.link), "of --link");
    text += "name: " + yaml_scalar(name_) + "\n";
    text += with_comment("interface: " + word_of(entry_.interface), "by its entry");
    text += "symbol: " + yaml_scalar(entry_.symbol) + "\n";
    if (entry_.interface == adapters::ForeignInterface::lsdyna)
      text += "arguments: " + std::to_string(entry_.routine.arguments.size()) + "\n";
    text += properties_yaml() + state_yaml();
    if (umat)
      text += with_comment("# strain: finite", "where DDSDDE is that of J sigma with Jaumann's rate; small otherwise");
    text +=
        with_comment("# flags: [non_smooth]", "what yields, breaks or touches; rate_dependent: what flows with time");
    const std::string material = deck_ ? deck_->name : request_.material;
    if (!material.empty() && !is_one_of("material_name", keys_without_effect(word_of(entry_.interface))))
      text += "material_name: " + yaml_scalar(capital_letters(material).substr(0, longest_name)) + "\n";
    if (!density_) return text;
    text += with_comment("density: " + yaml_number(density_->si), "kg/m^3");
    if (!density_->stress.empty()) {
      text += "units: {stress: " + density_->stress + ", length: " + density_->length + "}\n";
    }
    return text;
  }

  std::string properties_yaml() const {
    if (properties_.empty()) return {};
    std::string text = with_comment("properties:", constants_ + ", in this order, from " + properties_from_);
    for (std::size_t k = 0; k < properties_.size(); ++k) {
      const GivenProperty& p = properties_[k];
      const std::string name = p.name.empty() ? "p" + std::to_string(k + 1) : p.name;
      const auto known = facts_.property_names.find(static_cast<int>(k + 1));
      text += with_comment("  " + yaml_scalar(name) + ": " + (std::isfinite(p.value) ? yaml_number(p.value) : "~"),
                           known == facts_.property_names.end() ? "" : known->second + " in the source");
    }
    return text;
  }

  /// The deck's names where they can serve: as keys, each once.
  std::string named_state_yaml() const {
    std::vector<std::string> names(static_cast<std::size_t>(state_)), docs(names.size());
    for (const DeckVariable& variable : variables_) {
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

  std::string state_yaml() const {
    if (state_ == 0) return {};
    const std::string advice =
        state_ >= 6 ? "; declare the tensors among them: {back_stress: symmetric_tensor, p: scalar}" : "";
    const std::string of = variables_word_ + ", in this order, from " + state_from_ + advice;
    if (variables_.empty()) return with_comment("state: " + std::to_string(state_), of);
    return with_comment("state:", of) + named_state_yaml();
  }

  std::string assumptions() const {
    const bool umat = entry_.interface == adapters::ForeignInterface::umat;
    const bool units = density_ && !density_->stress.empty();
    return std::string("assumed unless the description says otherwise: isotropic, smooth, independent of the rate") +
           (umat ? ", DDSDDE for small strain" : "") + (units ? "" : ", SI units (no verdict depends on the units)");
  }

  std::string source_note() const {
    const bool fixed = source_.form.form == FortranForm::fixed;
    const std::string form = source_.form.mixed ? "a" : word_of(source_.form.form);
    return "a " + capital_name(entry_.interface) + " (" + entry_.symbol + ") in " + form + " form" +
           (source_.form.why.empty() ? "" : " " + source_.form.why) +
           (fixed ? std::string(", read at 132 columns") + (is_of_other_vendor(source_) ? "" : " as by Abaqus") : "") +
           "; " + library_.compiler;
  }

  const SourceRequest& request_;
  const Location& where_;
  const std::string& key_;
  FortranSource source_;
  std::string deck_file_;  ///< absolute; empty: none
  std::optional<DeckMaterial> deck_;
  SourceLibrary library_;
  SourceEntry entry_;
  SourceFacts facts_;
  std::string constants_, variables_word_;  ///< names of the arrays, in the words of the interface
  std::string name_;                        ///< of the model
  std::vector<GivenProperty> properties_;   ///< NaN: to be given by whoever uses it
  std::string properties_from_;             ///< "--props", "*User Material", "the source"; empty: there are none
  int state_ = 0;
  std::vector<DeckVariable> variables_;  ///< names of some of them
  std::string state_from_;
  std::optional<DeckDensity> density_;
};

}  // namespace

bool is_source_or_deck(const std::string& file) { return is_fortran_source(file) || is_deck(file); }

SourceDescription describe_source(const std::string& file, const SourceRequest& request, const Location& where,
                                  const std::string& key) {
  return Describer(file, request, where, key).described();
}

}  // namespace assay::drivers
