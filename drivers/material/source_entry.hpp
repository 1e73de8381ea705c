// SPDX-License-Identifier: BSD-3-Clause
// The entry point of a Fortran source: which of its routines Abaqus would call.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "drivers/material/fortran_source.hpp"

namespace assay::drivers {

constexpr std::size_t umat_arguments = 37, vumat_arguments = 33;

struct SourceEntry {
  std::string symbol;  ///< in the library
  adapters::ForeignInterface interface = adapters::ForeignInterface::umat;
  FortranRoutine routine;  ///< without arguments where the text has none of that name
};

/// By the names of the library's symbols and the numbers of their arguments: 37 of a UMAT, 33 of a VUMAT. The plain
/// names umat and vumat go before others, as in Abaqus. asked: a name, with or without its underscore, in any letters;
/// empty: the only one. Throws InputError at the source: none, or several; `key` names the choice.
SourceEntry entry_of_source(const FortranSource& source, const std::vector<std::string>& symbols,
                            const std::string& asked, const std::string& key);

/// The dummy arguments that an interface has at the places of these: props, statev, dtime, drot, ... For a routine
/// whose arguments are not known, the usual names.
struct EntryNames {
  std::string props = "props", dtime = "dtime";
  std::vector<std::string> state{"statev"}, strains, gradients, rotations;
};

EntryNames names_of_entry(const SourceEntry& entry);

/// The entry of a symbol, which need not be there; nothing where it is neither a UMAT nor a VUMAT.
std::optional<SourceEntry> entry_named(const FortranSource& source, const std::string& symbol);

}  // namespace assay::drivers
