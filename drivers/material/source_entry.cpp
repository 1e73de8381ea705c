// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/source_entry.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;

/// Places of arguments, from 0.
namespace place {
constexpr std::size_t umat_statev = 1, umat_dstran = 11, umat_stran = 10, umat_dtime = 13, umat_props = 23,
                      umat_drot = 26, umat_dfgrd0 = 29, umat_dfgrd1 = 30;
constexpr std::size_t vumat_dt = 9, vumat_props = 13, vumat_state_old = 22, vumat_state_new = 30;
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
                  ", but no program can find it: move it out of its MODULE or CONTAINS"};
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

std::optional<SourceEntry> entry_named(const FortranSource& source, const std::string& symbol) {
  return entry_behind(symbol, source.routines());
}

}  // namespace assay::drivers
