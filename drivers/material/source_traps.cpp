// SPDX-License-Identifier: BSD-3-Clause
// Declarations in a source that compile and give wrong stresses.
#include "drivers/material/source_entry.hpp"

#include <algorithm>

#include "drivers/system/input_error.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

using adapters::ForeignInterface;

namespace {

/// Of both interfaces.
const std::vector<std::string> integer_arguments{"ndi",  "nshr",    "ntens",   "nstatv", "nprops", "noel",
                                                 "npt",  "layer",   "kspt",    "jstep",  "kinc",   "nblock",
                                                 "ndir", "nstatev", "nfieldv", "lanneal"};

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

/// "name" of "name=...props(...)", where that is a plain variable and its text makes no whole number of it; or empty.
std::string receiver_of(const std::string& text, const std::string& props) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || text.find(props + "(", equals) == text.npos) return {};
  for (const char* whole : {"int(", "floor(", "ceiling("}) {  // nint( too
    if (text.find(whole, equals) != text.npos) return {};
  }
  const std::string name = text.substr(0, equals);
  return is_plain_variable(name) ? name : std::string();
}

/// Sentences on variables that hold less of a property than it has: the compiler tells of integers by their letter.
void add_lossy(const FortranSource& source, const SourceEntry& entry, const std::vector<FortranVariable>& variables,
               std::vector<std::string>& all) {
  const std::string props = names_of_entry(entry).props;
  std::vector<std::string> single;
  int line_of_single = 0;
  for (const FortranStatement& statement : entry.routine.statements) {
    const std::string name = receiver_of(statement.text, props);
    if (name.empty()) continue;
    const auto declared = std::ranges::find(variables, name, &FortranVariable::name);
    if (declared == variables.end() || declared->type != "real" || declared->bytes != 4) continue;
    if (single.empty()) line_of_single = statement.line;
    single.push_back(capital_letters(name));
  }
  if (!single.empty()) {
    all.push_back(place_text(source.file, line_of_single) + few_names(single) +
                  (single.size() > 1 ? " are reals of 4 bytes, and take" : " is a real of 4 bytes, and takes") +
                  " PROPS: only seven digits are kept");
  }
}

/// Of a list that is longer or shorter, or has the usual names in another order; or empty.
std::string list_trap(const std::vector<std::string>& arguments, const std::vector<std::string>& usual) {
  if (arguments.size() != usual.size()) {
    std::vector<std::string> missing;
    for (const std::string& name : usual) {
      if (!is_one_of(name, arguments)) missing.push_back(capital_letters(name));
    }
    const bool few = missing.size() + arguments.size() == usual.size();  // the others are called as usual
    return "takes " + std::to_string(arguments.size()) + " arguments, and Abaqus hands over " +
           std::to_string(usual.size()) +
           (few ? ": " + few_names(missing) + (missing.size() > 1 ? " are" : " is") + " not among them" : "") +
           "; every argument after the first missing or added one is read wrongly";
  }
  for (std::size_t k = 0; k < usual.size(); ++k) {
    if (arguments[k] != usual[k] && is_one_of(arguments[k], usual))
      return capital_letters(arguments[k]) + " stands where Abaqus hands over " + capital_letters(usual[k]) +
             ": arguments go by their places";
  }
  return {};
}

}  // namespace

std::vector<std::string> entry_traps(const FortranSource& source, const SourceEntry& entry) {
  const FortranRoutine& routine = entry.routine;
  const bool of_abaqus = entry.interface == ForeignInterface::umat || entry.interface == ForeignInterface::vumat;
  if (routine.line == 0 || !of_abaqus) return {};
  const std::vector<std::string>& usual = usual_arguments(entry.interface);
  const std::string where = place_text(source.file, routine.line), list = list_trap(routine.arguments, usual);
  if (!list.empty()) return {where + list};
  const std::vector<FortranVariable> variables = variables_of(routine.statements);
  const ImplicitTypes implicit = implicit_types(source, routine);
  std::vector<std::string> wide, narrow;
  for (std::size_t k = 0; k < routine.arguments.size(); ++k) {
    if (usual[k] == "cmname") continue;
    const bool integer = is_one_of(usual[k], integer_arguments);
    const int bytes = bytes_of_argument(routine.arguments[k], integer, variables, implicit);
    if (integer && bytes == 8) wide.push_back(capital_letters(routine.arguments[k]));
    if (!integer && bytes == 4) narrow.push_back(capital_letters(routine.arguments[k]));
  }
  std::vector<std::string> all;
  if (!wide.empty()) {
    all.push_back(where + few_names(wide) + (wide.size() > 1 ? " are" : " is") +
                  " declared an integer of 8 bytes, and Abaqus hands over 4: what is read is another number");
  }
  if (!narrow.empty()) {
    all.push_back(where + few_names(narrow) + (narrow.size() > 1 ? " are reals" : " is a real") +
                  " of 4 bytes, and Abaqus hands over 8: INCLUDE '" +
                  (entry.interface == ForeignInterface::umat ? "ABA_PARAM.INC" : "VABA_PARAM.INC") +
                  "' or IMPLICIT REAL*8 (A-H,O-Z) is missing, or a declaration says real");
  }
  add_lossy(source, entry, variables, all);
  return all;
}

std::vector<std::string> entry_traps(const FortranSource& source, const std::string& symbol) {
  const auto entry = entry_named(source, symbol);
  return entry ? entry_traps(source, *entry) : std::vector<std::string>();
}

}  // namespace assay::drivers
