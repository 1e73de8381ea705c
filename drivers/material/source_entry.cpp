// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_entry.hpp"

#include <algorithm>

#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;

std::string fortran_name(std::string symbol) {
  if (symbol.ends_with('_')) symbol.pop_back();
  return small_letters(std::move(symbol));
}

std::optional<ForeignInterface> interface_by_arguments(const FortranRoutine& routine) {
  for (const ForeignInterface interface : {ForeignInterface::umat, ForeignInterface::vumat}) {
    if (routine.arguments.size() == usual_arguments(interface).size()) return interface;
  }
  return std::nullopt;
}

/// The numbers of arguments that a routine of that name may have; none: the name is that of no other vendor.
std::vector<std::size_t> served_counts(const std::string& name) {
  if (name == "usermat") return {41, 42};
  return is_name_of_lsdyna(name) ? std::vector<std::size_t>{12, 13, 16, 18} : std::vector<std::size_t>();
}

std::optional<ForeignInterface> interface_of_other_vendors(const FortranRoutine& routine) {
  if (std::ranges::count(served_counts(routine.name), routine.arguments.size()) == 0) return std::nullopt;
  return routine.name == "usermat" ? ForeignInterface::usermat : ForeignInterface::lsdyna;
}

/// "has 14 arguments, and a user material of LS-DYNA has 12, 13, 16 or 18"; empty where its name says nothing.
std::string other_count_of(const FortranRoutine& routine) {
  const std::vector<std::size_t> counts = served_counts(routine.name);
  if (counts.empty()) return {};
  std::string list;
  for (std::size_t k = 0; k < counts.size(); ++k)
    list += (k == 0 ? "" : k + 1 < counts.size() ? ", " : " or ") + std::to_string(counts[k]);
  return "has " + std::to_string(routine.arguments.size()) + " arguments, and a " +
         capital_name(routine.name == "usermat" ? ForeignInterface::usermat : ForeignInterface::lsdyna) + " has " +
         list;
}

std::optional<ForeignInterface> interface_by_name(const std::string& name) {
  if (name == "umat" || name.starts_with("umat_")) return ForeignInterface::umat;
  if (name == "vumat" || name.starts_with("vumat_")) return ForeignInterface::vumat;
  return std::nullopt;
}

FortranRoutine routine_named(const std::vector<FortranRoutine>& routines, const std::string& name) {
  const auto found = std::ranges::find(routines, name, &FortranRoutine::name);
  return found == routines.end() ? FortranRoutine{name, {}, 0, 0, {}} : *found;
}

/// Whether a symbol may be one: its text has the arguments of an interface, or its name says so and no text
/// contradicts.
std::optional<SourceEntry> entry_behind(const std::string& symbol, const std::vector<FortranRoutine>& routines) {
  const std::string name = fortran_name(symbol);
  FortranRoutine routine = routine_named(routines, name);
  if (const auto other = interface_of_other_vendors(routine)) return SourceEntry{symbol, *other, std::move(routine)};
  const auto by_arguments = interface_by_arguments(routine), by_name = interface_by_name(name);
  if (by_arguments) return SourceEntry{symbol, *by_arguments, std::move(routine)};
  const bool plain = name == "umat" || name == "vumat";
  if (by_name && (plain || routine.line == 0)) return SourceEntry{symbol, *by_name, std::move(routine)};
  return std::nullopt;
}

SourceEntry asked_entry(const FortranSource& source, const std::vector<std::string>& symbols,
                        const std::vector<SourceEntry>& entries, const std::string& asked) {
  const auto is_asked = [&](const std::string& symbol) { return fortran_name(symbol) == fortran_name(asked); };
  const auto entry = std::ranges::find_if(entries, is_asked, &SourceEntry::symbol);
  if (entry != entries.end()) return *entry;
  const std::string quoted = "'" + one_line(asked, 80) + "' ";
  const std::string other = other_count_of(routine_named(source.routines(), fortran_name(asked)));
  throw InputError({source.file}, "symbol",
                   quoted + (std::ranges::none_of(symbols, is_asked) ? "is no routine of it"
                             : !other.empty()                        ? other
                                              : "has neither the 37 arguments of a UMAT nor the 33 of a VUMAT"),
                   joined(entries, &SourceEntry::symbol));
}

InputError none_found(const FortranSource& source, const std::vector<FortranRoutine>& routines) {
  std::vector<std::string> names;
  for (const FortranRoutine& routine : routines) {
    const std::string count = std::to_string(routine.arguments.size());
    if (const auto interface = interface_by_arguments(routine)) {
      return {{source.file, routine.line, 1},
              "",
              "'" + routine.name + "' has the " + count + " arguments of a " + capital_name(*interface) +
                  ", but no program can find it: move it out of its MODULE or CONTAINS"};
    }
    if (const std::string other = other_count_of(routine); !other.empty())
      return {{source.file, routine.line, 1}, "", "'" + routine.name + "' " + other};
    names.push_back(routine.name + " (" + count + ")");
  }
  return {
      {source.file},
      "",
      "has no UMAT and no VUMAT: no routine of that name, and none of 37 or 33 arguments; no usermat, and no umat41 "
      "to umat50",
      names.empty() ? "" : "its subroutines " + joined(names)};
}

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
    if (index && *index > 0 && *index < 100000 && is_plain_variable(name))
      names.emplace(static_cast<int>(*index), name);
  }
  return names;
}

}  // namespace

SourceEntry entry_of_source(const FortranSource& source, const std::vector<std::string>& symbols,
                            const std::string& asked, const std::string& key) {
  const std::vector<FortranRoutine> routines = source.routines();
  std::vector<SourceEntry> entries, plain;
  for (const std::string& symbol : symbols) {
    auto entry = entry_behind(symbol, routines);
    if (!entry) continue;
    const std::string name = fortran_name(symbol);
    if (is_one_of(name, {"umat", "vumat", "usermat"})) plain.push_back(*entry);
    entries.push_back(std::move(*entry));
  }
  if (!asked.empty()) return asked_entry(source, symbols, entries, asked);
  if (entries.empty()) throw none_found(source, routines);
  if (entries.size() == 1) return entries.front();
  if (plain.size() == 1) return plain.front();
  throw InputError({source.file}, "", "has several entry points: choose one by " + key,
                   joined(plain.empty() ? entries : plain, &SourceEntry::symbol));
}

const std::vector<std::string>& usual_arguments(ForeignInterface interface) {
  static const std::vector<std::string> of_umat{
      "stress", "statev", "ddsdde", "sse",   "spd",    "scd",    "rpl",    "ddsddt", "drplde", "drpldt",
      "stran",  "dstran", "time",   "dtime", "temp",   "dtemp",  "predef", "dpred",  "cmname", "ndi",
      "nshr",   "ntens",  "nstatv", "props", "nprops", "coords", "drot",   "pnewdt", "celent", "dfgrd0",
      "dfgrd1", "noel",   "npt",    "layer", "kspt",   "jstep",  "kinc"};
  static const std::vector<std::string> of_vumat{
      "nblock",        "ndir",    "nshr",       "nstatev",    "nfieldv",    "nprops",    "lanneal",  "steptime",
      "totaltime",     "dt",      "cmname",     "coordmp",    "charlength", "props",     "density",  "straininc",
      "relspininc",    "tempold", "stretchold", "defgradold", "fieldold",   "stressold", "stateold", "enerinternold",
      "enerinelasold", "tempnew", "stretchnew", "defgradnew", "fieldnew",   "stressnew", "statenew", "enerinternnew",
      "enerinelasnew"};
  static const std::vector<std::string> of_usermat{
      "matid",   "elemid", "kdomintpt", "klayer",  "ksectpt", "ldstep", "isubst",    "keycut", "ndirect",
      "nshear",  "ncomp",  "nstatev",   "nprop",   "time",    "dtime",  "temp",      "dtemp",  "stress",
      "ustatev", "dsdepl", "sedel",     "sedpl",   "epseq",   "strain", "dstrain",   "epspl",  "prop",
      "coords",  "var0",   "defgrad_t", "defgrad", "tsstif",  "epszz",  "cutfactor", "var1",   "var2",
      "var3",    "var4",   "var5",      "var6",    "var7"};
  static const std::vector<std::string> of_lsdyna{"cm",     "eps",   "sig",  "epsp",   "hsv",    "dt1",
                                                  "capa",   "etype", "tt",   "temper", "failel", "crv",
                                                  "nnpcrv", "cma",   "qmat", "elsiz",  "idele",  "reject"};
  if (interface == ForeignInterface::usermat) return of_usermat;
  if (interface == ForeignInterface::lsdyna) return of_lsdyna;
  return interface == ForeignInterface::umat ? of_umat : of_vumat;
}

EntryNames names_of_entry(const SourceEntry& entry) {
  const std::vector<std::string>&own = entry.routine.arguments, &usual = usual_arguments(entry.interface);
  const auto at = [&](const char* word) { return own[index_of(word, usual)]; };  // those in front are always there
  if (entry.interface == ForeignInterface::usermat)
    return {at("prop"), at("dtime"), {at("ustatev")}, {at("strain"), at("dstrain")}, {at("defgrad")}, {}};
  if (entry.interface == ForeignInterface::lsdyna) return {at("cm"), at("dt1"), {at("hsv")}, {at("eps")}, {}, {}};
  const bool umat = entry.interface == ForeignInterface::umat, known = own.size() == usual.size();
  if (umat && !known) return {};
  const auto name = [&](const char* word) { return known ? own[index_of(word, usual)] : word; };
  if (!umat) return {name("props"), name("dt"), {name("stateold"), name("statenew")}, {}, {}, {}};
  return {name("props"),
          name("dtime"),
          {name("statev")},
          {name("stran"), name("dstran")},
          {name("dfgrd0"), name("dfgrd1")},
          {name("drot"), "rotsig"}};
}

bool is_plain_variable(const std::string& name) {
  return std::all_of(name.begin(), name.end(), [](char c) { return is_letter_or_digit(c) || c == '_'; });
}

std::string capital_name(ForeignInterface interface) {
  return interface == ForeignInterface::lsdyna ? "user material of LS-DYNA" : capital_letters(word_of(interface));
}

std::string constants_word(ForeignInterface interface) {
  return interface == ForeignInterface::lsdyna ? "cm" : interface == ForeignInterface::usermat ? "prop" : "PROPS";
}

std::string state_word(ForeignInterface interface) {
  return interface == ForeignInterface::lsdyna ? "hsv" : interface == ForeignInterface::usermat ? "ustatev" : "STATEV";
}

bool is_name_of_lsdyna(const std::string& name) {
  const bool forties = name.size() == 6 && name.starts_with("umat4") && name[5] >= '1' && name[5] <= '9';
  return forties || name == "umat50";
}

bool is_of_lsdyna(const FortranSource& source) {
  const std::vector<FortranRoutine> routines = source.routines();
  return std::ranges::any_of(routines, [](const FortranRoutine& routine) {
    return interface_of_other_vendors(routine) == ForeignInterface::lsdyna;
  });
}

bool is_of_other_vendor(const FortranSource& source) {
  return std::ranges::any_of(source.routines(),
                             [](const FortranRoutine& routine) { return !served_counts(routine.name).empty(); });
}

std::optional<SourceEntry> entry_named(const FortranSource& source, const std::string& symbol) {
  return entry_behind(symbol, source.routines());
}

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
    facts.sentences.emplace_back((umat ? "DTIME" : names.dtime) +
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
