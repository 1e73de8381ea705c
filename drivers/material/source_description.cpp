// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_description.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "adapters/elf_symbols.hpp"
#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/material/source_entry.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// The source of the same name beside a deck.
std::string source_beside(const std::string& deck, const Location& where, const std::string& key) {
  const fs::path path(deck);
  std::error_code code;
  if (!fs::exists(path, code)) throw InputError(where, key, "no such file: '" + deck + "'");
  std::vector<std::string> found;
  for (fs::directory_iterator at(path.parent_path(), code), end; !code && at != end; at.increment(code)) {
    const bool named = at->path().stem() == path.stem() && is_fortran_source(at->path().string());
    if (std::error_code unknown_kind; named && at->is_regular_file(unknown_kind)) found.push_back(at->path().string());
  }
  std::sort(found.begin(), found.end());
  if (found.size() == 1) return found.front();
  const std::string stem = path.stem().string();
  throw InputError(where, key,
                   "'" + deck +
                       (found.empty() ? "' has no Fortran source beside it: " + stem + ".f, " + stem + ".for, ..."
                                      : "' has several Fortran sources beside it") +
                       "; assay check takes SOURCE --deck " + path.filename().string(),
                   joined(found));
}

/// "; model.inp beside it may have them: --deck model.inp".
std::string deck_hint(const std::string& source) {
  const fs::path deck = fs::path(source).replace_extension(".inp");
  std::error_code code;
  if (!fs::is_regular_file(deck, code)) return {};
  return "; " + deck.filename().string() + " beside it may have them: --deck " + deck.filename().string();
}

class Describer {
 public:
  Describer(const std::string& file, const SourceRequest& request, const Location& where, const std::string& key)
      : request_(request), where_(where), key_(key) {
    const bool by_deck = is_deck(file);
    const std::string source = by_deck ? source_beside(file, where, key) : file;
    const std::string deck = by_deck ? file : request.deck;
    source_ = read_fortran_source(source, where, key);
    source_.link = request.link;
    if (!deck.empty()) deck_ = read_deck(deck, request.material, request.material_key);
    library_ = library_of_source(source_);
    entry_ = entry_of_source(source_, adapters::exported_symbols(library_.file), request.symbol, request.symbol_key);
    facts_ = facts_of(source_, entry_);
    yaml_.source = source;
    yaml_.deck = deck;
  }

  SourceDescription described() {
    SourceDescription result;
    yaml_.name = result.name = as_name(fs::path(source_.file).stem().string());
    yaml_.entry = entry_;
    yaml_.facts = facts_;
    yaml_.link = request_.link;
    yaml_.material_name = deck_ ? deck_->name : request_.material;
    take_properties();
    take_state();
    take_density();
    result.text = source_yaml(yaml_);
    result.notes = notes();
    result.warnings = source_.warnings;
    if (deck_) append_all(result.warnings, deck_->warnings);
    append_all(result.warnings, library_.warnings);
    append_all(result.warnings, entry_traps(source_, entry_));
    warn_of_too_few(facts_.props, "PROPS", yaml_.properties.size(), result.warnings);
    warn_of_too_few(facts_.state, "STATEV", static_cast<std::size_t>(yaml_.state), result.warnings);
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
      yaml_.properties = *request_.props;
      yaml_.properties_from = "--props";
      refuse_exchanged_names();
    } else if (deck_) {
      for (const double value : deck_->constants) yaml_.properties.push_back({"", value});
      yaml_.properties_from = "*User Material";
    } else if (use.used) {
      if (request_.needs_values) {
        throw InputError(
            {source_.file}, "--props",
            "required and not given: " + uses_of(use, "PROPS") + ", as --props 1000,.3" + deck_hint(source_.file));
      }
      refuse_what_is_not_told(use, "PROPS", request_.least_properties > 0);
      const auto count = std::max(static_cast<std::size_t>(use.largest), request_.least_properties);
      yaml_.properties.assign(count, {"", NAN});
      yaml_.properties_from = "the source";
    }
  }

  /// PROPS are taken by their places: a name that the source has for another place is a slip.
  void refuse_exchanged_names() const {
    for (std::size_t k = 0; k < yaml_.properties.size(); ++k) {
      const std::string& name = yaml_.properties[k].name;
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
      yaml_.state = *request_.statev;
      yaml_.state_from = "--statev";
    } else if (deck_) {
      yaml_.state = deck_->depvar;
      yaml_.variables = deck_->variables;
      yaml_.state_from = "*Depvar";
    } else if (use.used) {
      if (request_.needs_values && !use.whole) {
        throw InputError({source_.file}, "--statev",
                         "required and not given: " + uses_of(use, "STATEV") + deck_hint(source_.file));
      }
      refuse_what_is_not_told(use, "STATEV", false);
      yaml_.state = use.largest;
      yaml_.state_from = "the source";
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

  void take_density() {
    if (deck_ && deck_->density && *deck_->density > 0) yaml_.density = density_of(*deck_->density);
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> all{source_note()};
    const auto count = [](std::size_t n, const char* what) { return std::to_string(n) + " " + what; };
    if (!yaml_.properties_from.empty()) {
      all.push_back(count(yaml_.properties.size(), "PROPS from ") + yaml_.properties_from + "; " +
                    uses_of(facts_.props, "PROPS"));
    }
    if (!yaml_.state_from.empty()) {
      all.push_back(
          count(static_cast<std::size_t>(yaml_.state), "STATEV from ") + yaml_.state_from + "; " +
          uses_of(facts_.state, "STATEV") +
          (yaml_.state >= 6 ? "; all are taken as scalars, because the source does not say which are tensors" : ""));
    }
    if (yaml_.density) all.push_back(yaml_.density->words);
    all.push_back(assumptions());
    append_all(all, facts_.sentences);
    if (deck_) append_all(all, deck_->notes);
    return all;
  }

  std::string assumptions() const {
    const bool umat = entry_.interface == adapters::ForeignInterface::umat;
    const bool units = yaml_.density && !yaml_.density->stress.empty();
    return std::string("assumed unless the description says otherwise: isotropic, smooth, independent of the rate") +
           (umat ? ", DDSDDE for small strain" : "") + (units ? "" : ", SI units (no verdict depends on the units)");
  }

  std::string source_note() const {
    const bool fixed = source_.form.form == FortranForm::fixed;
    const std::string form = source_.form.mixed ? "a" : word_of(source_.form.form);
    return "a " + capital_name(entry_.interface) + " (" + entry_.symbol + ") in " + form + " form" +
           (source_.form.why.empty() ? "" : " " + source_.form.why) +
           (fixed ? ", read at 132 columns as by Abaqus" : "") + "; " + library_.compiler;
  }

  const SourceRequest& request_;
  const Location& where_;
  const std::string& key_;
  FortranSource source_;
  std::optional<DeckMaterial> deck_;
  SourceLibrary library_;
  SourceEntry entry_;
  SourceFacts facts_;
  SourceYaml yaml_;
};

}  // namespace

bool is_source_or_deck(const std::string& file) { return is_fortran_source(file) || is_deck(file); }

SourceDescription describe_source(const std::string& file, const SourceRequest& request, const Location& where,
                                  const std::string& key) {
  return Describer(file, request, where, key).described();
}

}  // namespace assay::drivers
