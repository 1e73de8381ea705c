// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_entry.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include "drivers/input_error.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;

constexpr std::size_t umat_arguments = 37, vumat_arguments = 33;

/// Places of arguments, from 0.
namespace place {
constexpr std::size_t umat_statev = 1, umat_dstran = 11, umat_stran = 10, umat_dtime = 13, umat_cmname = 18,
                      umat_props = 23, umat_drot = 26, umat_dfgrd0 = 29, umat_dfgrd1 = 30;
constexpr std::size_t vumat_dt = 9, vumat_cmname = 10, vumat_props = 13, vumat_state_old = 22, vumat_state_new = 30;
const std::set<std::size_t> umat_integers{19, 20, 21, 22, 24, 31, 32, 33, 34, 35, 36},
    vumat_integers{0, 1, 2, 3, 4, 5, 6};
}  // namespace place

std::string fortran_name(std::string symbol) {
  std::transform(symbol.begin(), symbol.end(), symbol.begin(), [](unsigned char c) { return std::tolower(c); });
  if (symbol.ends_with('_')) symbol.pop_back();
  return symbol;
}

std::optional<ForeignInterface> interface_by_arguments(const FortranRoutine& routine) {
  if (routine.arguments.size() == umat_arguments) return ForeignInterface::umat;
  if (routine.arguments.size() == vumat_arguments) return ForeignInterface::vumat;
  return std::nullopt;
}

std::optional<ForeignInterface> interface_by_name(const std::string& name) {
  if (name == "umat" || name.starts_with("umat_")) return ForeignInterface::umat;
  if (name == "vumat" || name.starts_with("vumat_")) return ForeignInterface::vumat;
  return std::nullopt;
}

FortranRoutine routine_named(const std::vector<FortranRoutine>& routines, const std::string& name) {
  const auto found =
      std::find_if(routines.begin(), routines.end(), [&](const FortranRoutine& each) { return each.name == name; });
  return found == routines.end() ? FortranRoutine{name, {}, 0, 0, {}} : *found;
}

/// Whether a symbol may be one: its text has the arguments of an interface, or its name says so and no text
/// contradicts.
std::optional<SourceEntry> entry_behind(const std::string& symbol, const std::vector<FortranRoutine>& routines) {
  const std::string name = fortran_name(symbol);
  FortranRoutine routine = routine_named(routines, name);
  const auto by_arguments = interface_by_arguments(routine), by_name = interface_by_name(name);
  if (by_arguments) return SourceEntry{symbol, *by_arguments, std::move(routine)};
  const bool plain = name == "umat" || name == "vumat";
  if (by_name && (plain || routine.line == 0)) return SourceEntry{symbol, *by_name, std::move(routine)};
  return std::nullopt;
}

std::string symbols_text(const std::vector<SourceEntry>& entries) {
  std::vector<std::string> names;
  for (const SourceEntry& entry : entries) names.push_back(entry.symbol);
  return joined(names);
}

SourceEntry asked_entry(const FortranSource& source, const std::vector<std::string>& symbols,
                        const std::vector<SourceEntry>& entries, const std::string& asked) {
  for (const SourceEntry& entry : entries) {
    if (entry.symbol == asked || fortran_name(entry.symbol) == fortran_name(asked)) return entry;
  }
  const auto exported = std::find_if(symbols.begin(), symbols.end(), [&](const std::string& symbol) {
    return symbol == asked || fortran_name(symbol) == fortran_name(asked);
  });
  const std::string quoted = "'" + one_line(asked, 80) + "' ";
  throw InputError({source.file}, "symbol",
                   exported == symbols.end() ? quoted + "is no routine of it"
                                             : quoted + "has neither the 37 arguments of a UMAT nor the 33 of a VUMAT",
                   symbols_text(entries));
}

InputError none_found(const FortranSource& source, const std::vector<FortranRoutine>& routines) {
  std::vector<std::string> names;
  for (const FortranRoutine& routine : routines) {
    const std::size_t count = routine.arguments.size();
    if (count == 37 || count == 33) {
      return {{source.file, routine.line, 1},
              "",
              "'" + routine.name + "' has the " + std::to_string(count) + " arguments of a " +
                  (count == 37 ? "UMAT" : "VUMAT") +
                  ", and no program finds it: it stands in a MODULE or behind CONTAINS, and belongs outside"};
    }
    names.push_back(routine.name + " (" + std::to_string(count) + ")");
  }
  return {{source.file},
          "",
          "has no UMAT and no VUMAT: no routine of that name, and none of 37 or 33 arguments",
          names.empty() ? "" : "its subroutines " + joined(names)};
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
    if (name == "umat" || name == "vumat") plain.push_back(*entry);
    entries.push_back(std::move(*entry));
  }
  if (!asked.empty()) return asked_entry(source, symbols, entries, asked);
  if (entries.empty()) throw none_found(source, routines);
  if (entries.size() == 1) return entries.front();
  if (plain.size() == 1) return plain.front();
  throw InputError({source.file}, "", "has several entry points: choose one by " + key,
                   symbols_text(plain.empty() ? entries : plain));
}

EntryNames names_of_entry(const SourceEntry& entry) {
  const std::vector<std::string>& a = entry.routine.arguments;
  EntryNames names;
  if (entry.interface == ForeignInterface::umat && a.size() == umat_arguments) {
    names = {a[place::umat_props],
             a[place::umat_dtime],
             {a[place::umat_statev]},
             {a[place::umat_stran], a[place::umat_dstran]},
             {a[place::umat_dfgrd0], a[place::umat_dfgrd1]},
             {a[place::umat_drot], "rotsig"}};
  } else if (entry.interface == ForeignInterface::vumat) {
    names = {"props", "dt", {"stateold", "statenew"}, {}, {}, {}};
    if (a.size() == vumat_arguments) {
      names.props = a[place::vumat_props];
      names.dtime = a[place::vumat_dt];
      names.state = {a[place::vumat_state_old], a[place::vumat_state_new]};
    }
  }
  return names;
}

namespace {

/// What stands for the types of arguments that are not declared.
struct ImplicitTypes {
  bool none = false;  ///< IMPLICIT NONE: all are declared
  int real_bytes = 4, integer_bytes = 4;
};

ImplicitTypes implicit_types(const FortranSource& source, const FortranRoutine& routine) {
  ImplicitTypes types;
  if (source.includes_parameters(routine)) types.real_bytes = 8;
  for (const FortranStatement& statement : routine.statements) {
    const std::string& text = statement.text;
    if (!text.starts_with("implicit")) continue;
    if (text == "implicitnone") types.none = true;
    if (text.starts_with("implicitreal*8") || text.starts_with("implicitreal(8)") ||
        text.starts_with("implicitreal(kind=8)") || text.starts_with("implicitdoubleprecision")) {
      types.real_bytes = 8;
    }
    if (text.starts_with("implicitinteger*8") || text.starts_with("implicitinteger(8)")) types.integer_bytes = 8;
  }
  return types;
}

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// Bytes of each argument as the routine has it; 0 where that is not told.
int bytes_of_argument(const std::string& name, bool integer, const std::vector<FortranVariable>& variables,
                      const ImplicitTypes& implicit) {
  for (const FortranVariable& variable : variables) {
    if (variable.name != name) continue;
    const bool known = variable.type == "integer" || variable.type == "real" || variable.type == "doubleprecision";
    return known && (variable.type == "integer") == integer ? variable.bytes : 0;
  }
  const bool named_integer = !name.empty() && name[0] >= 'i' && name[0] <= 'n';
  if (implicit.none || named_integer != integer) return 0;
  return integer ? implicit.integer_bytes : implicit.real_bytes;
}

std::string few_of(const std::vector<std::string>& names) {
  constexpr std::size_t shown = 4;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + static_cast<std::ptrdiff_t>(std::min(shown, names.size())));
  return joined(first) + (names.size() > shown ? " and " + std::to_string(names.size() - shown) + " others" : "");
}

/// "name" of "name=...props(...)", where that is a plain variable and its text makes no whole number of it; or empty.
std::string receiver_of(const std::string& text, const std::string& props) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || text.find(props + "(", equals) == text.npos) return {};
  for (const char* whole : {"int(", "floor(", "ceiling("}) {  // nint( too
    if (text.find(whole, equals) != text.npos) return {};
  }
  const std::string name = text.substr(0, equals);
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  return plain ? name : std::string();
}

/// Sentences on variables that hold less of a property than it has.
void add_lossy(const FortranSource& source, const SourceEntry& entry, const std::vector<FortranVariable>& variables,
               const ImplicitTypes& implicit, std::vector<std::string>& all) {
  const std::string props = names_of_entry(entry).props;
  std::vector<std::string> whole, single;
  int line_of_whole = 0, line_of_single = 0;
  for (const FortranStatement& statement : entry.routine.statements) {
    const std::string name = receiver_of(statement.text, props);
    if (name.empty()) continue;
    const auto same = [&](const FortranVariable& variable) { return variable.name == name; };
    const auto declared = std::find_if(variables.begin(), variables.end(), same);
    const bool is_declared = declared != variables.end();
    const bool by_letter = !is_declared && !implicit.none && name[0] >= 'i' && name[0] <= 'n';
    if (by_letter && whole.empty()) line_of_whole = statement.line;
    if (by_letter) whole.push_back(capitals(name));
    if (!is_declared || declared->type != "real" || declared->bytes != 4) continue;
    if (single.empty()) line_of_single = statement.line;
    single.push_back(capitals(name));
  }
  const auto at = [&](int line) { return source.file + ":" + std::to_string(line) + ": "; };
  if (!whole.empty()) {
    all.push_back(at(line_of_whole) + few_of(whole) +
                  (whole.size() > 1 ? " are integers by their first letter, and take"
                                    : " is an integer by its first "
                                      "letter, and takes") +
                  " PROPS: what stands behind the decimal point is lost (where that is meant, INT says so)");
  }
  if (!single.empty()) {
    all.push_back(at(line_of_single) + few_of(single) +
                  (single.size() > 1 ? " are reals of 4 bytes, and take" : " is a real of 4 bytes, and takes") +
                  " PROPS: seven digits of them are left");
  }
}

/// As the manual of Abaqus has them. A routine may call them otherwise.
const std::vector<std::string> usual_of_umat{
    "stress", "statev", "ddsdde", "sse",   "spd",    "scd",    "rpl",    "ddsddt", "drplde", "drpldt",
    "stran",  "dstran", "time",   "dtime", "temp",   "dtemp",  "predef", "dpred",  "cmname", "ndi",
    "nshr",   "ntens",  "nstatv", "props", "nprops", "coords", "drot",   "pnewdt", "celent", "dfgrd0",
    "dfgrd1", "noel",   "npt",    "layer", "kspt",   "jstep",  "kinc"};
const std::vector<std::string> usual_of_vumat{
    "nblock",        "ndir",    "nshr",       "nstatev",    "nfieldv",    "nprops",    "lanneal",  "steptime",
    "totaltime",     "dt",      "cmname",     "coordmp",    "charlength", "props",     "density",  "straininc",
    "relspininc",    "tempold", "stretchold", "defgradold", "fieldold",   "stressold", "stateold", "enerinternold",
    "enerinelasold", "tempnew", "stretchnew", "defgradnew", "fieldnew",   "stressnew", "statenew", "enerinternnew",
    "enerinelasnew"};

/// Of a list that is longer or shorter, or has the usual names in another order; or empty.
std::string list_trap(const std::vector<std::string>& arguments, const std::vector<std::string>& usual) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (arguments.size() != usual.size()) {
    std::vector<std::string> missing;
    for (const std::string& name : usual) {
      if (!has(arguments, name)) missing.push_back(capitals(name));
    }
    const bool few = missing.size() + arguments.size() == usual.size();  // the others are called as usual
    return "takes " + std::to_string(arguments.size()) + " arguments, and Abaqus hands over " +
           std::to_string(usual.size()) +
           (few ? ": " + few_of(missing) + (missing.size() > 1 ? " are" : " is") + " not among them" : "") +
           "; what follows the first that is missing or added is taken for another";
  }
  for (std::size_t k = 0; k < usual.size(); ++k) {
    if (arguments[k] != usual[k] && has(usual, arguments[k]))
      return capitals(arguments[k]) + " stands where Abaqus hands over " + capitals(usual[k]) +
             ": arguments go by their places";
  }
  return {};
}

}  // namespace

std::vector<std::string> entry_traps(const FortranSource& source, const SourceEntry& entry) {
  const FortranRoutine& routine = entry.routine;
  const bool umat = entry.interface == ForeignInterface::umat;
  if (routine.line == 0) return {};
  const std::string list = list_trap(routine.arguments, umat ? usual_of_umat : usual_of_vumat);
  if (!list.empty()) return {source.file + ":" + std::to_string(routine.line) + ": " + list};
  const std::vector<FortranVariable> variables = variables_of(routine.statements);
  const ImplicitTypes implicit = implicit_types(source, routine);
  const auto& integers = umat ? place::umat_integers : place::vumat_integers;
  const std::size_t text = umat ? place::umat_cmname : place::vumat_cmname;
  std::vector<std::string> wide, narrow;
  for (std::size_t k = 0; k < routine.arguments.size(); ++k) {
    if (k == text) continue;
    const bool integer = integers.contains(k);
    const int bytes = bytes_of_argument(routine.arguments[k], integer, variables, implicit);
    if (integer && bytes == 8) wide.push_back(capitals(routine.arguments[k]));
    if (!integer && bytes == 4) narrow.push_back(capitals(routine.arguments[k]));
  }
  std::vector<std::string> all;
  const std::string where = source.file + ":" + std::to_string(routine.line) + ": ";
  if (!wide.empty()) {
    all.push_back(where + few_of(wide) + (wide.size() > 1 ? " are" : " is") +
                  " declared an integer of 8 bytes, and Abaqus hands over 4: what is read is another number");
  }
  if (!narrow.empty()) {
    all.push_back(where + few_of(narrow) + (narrow.size() > 1 ? " are reals" : " is a real") +
                  " of 4 bytes, and Abaqus hands over 8: INCLUDE '" + (umat ? "ABA_PARAM.INC" : "VABA_PARAM.INC") +
                  "' or IMPLICIT REAL*8 (A-H,O-Z) is missing, or a declaration says real");
  }
  add_lossy(source, entry, variables, implicit, all);
  return all;
}

std::vector<std::string> entry_traps(const FortranSource& source, const std::string& symbol) {
  const auto entry = entry_behind(symbol, source.routines());
  return entry ? entry_traps(source, *entry) : std::vector<std::string>();
}

}  // namespace assay::drivers
