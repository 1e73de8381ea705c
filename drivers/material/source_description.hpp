// SPDX-License-Identifier: BSD-3-Clause
// From a Fortran source to the description of a foreign model, a file to be edited: what was given, what the text
// tells, what is not known; and what is said of it on the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/source_entry.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

/// A constant of PROPS; without a name it is p1, p2, ...
struct GivenProperty {
  std::string name;
  double value = 0;
};

/// What a user says of a source beside its name.
struct SourceRequest {
  std::optional<std::vector<GivenProperty>> props;
  std::optional<int> statev;
  std::string deck;      ///< absolute; empty: none
  std::string material;  ///< of the deck, or CMNAME
  std::string symbol;
  std::vector<std::string> link;     ///< words of linked_word()
  std::size_t least_properties = 0;  ///< so many have names that somebody knows: p1, p2, ...
  bool needs_values = false;         ///< PROPS without values are refused
  std::string material_key = "FILE.inp:NAME", symbol_key = "FILE.f:NAME";  ///< how to choose, in messages
};

struct SourceDescription {
  std::string name;                   ///< of the model: the source's, in small letters
  std::string text;                   ///< YAML, with comments
  std::vector<std::string> notes;     ///< sentences: what was taken and guessed
  std::vector<std::string> warnings;  ///< sentences: what is probably not meant
};

/// A Fortran source or an Abaqus deck, which stands for the source of the same name beside it.
bool is_source_or_deck(const std::string& file);

/// Compiles it and describes it. file: absolute, of a source or a deck. Throws InputError at `where`, `key`, or at the
/// line of the source or the deck; SystemError.
SourceDescription describe_source(const std::string& file, const SourceRequest& request, const Location& where,
                                  const std::string& key);

/// What is said of a material that is a Fortran source, as it stands on the command line; empty: nothing.
struct SourceOptions {
  std::string props;     ///< "1000,.3", "E=1000,nu=.3"
  std::string statev;    ///< number of STATEV
  std::string deck;      ///< Abaqus input file
  std::string material;  ///< of the deck
  std::string symbol;    ///< entry point
  std::string link;      ///< "lapack,./mine.a"
};

/// Throws InputError at the option that is no number, no file, or goes with something else.
SourceRequest request_of(const SourceOptions& options);

/// Throws InputError where one is given beside a material that is no source. material: as it was asked for.
void refuse_source_options(const SourceOptions& options, const std::string& material);

/// Whether a material, as it was asked for, is a Fortran source or a deck.
bool asks_for_source(const std::string& material);

/// A description that was written, absolute, and the warnings that were told.
struct DescribedSource {
  std::string file;
  std::vector<std::string> warnings;
};

/// Describes the source `material`, absolute, tells on standard error what was taken and guessed, and writes the
/// description to DIR/NAME.yaml, or beside it where somebody has edited that. Throws InputError, SystemError.
DescribedSource described_source(const std::string& material, SourceRequest request, const std::string& folder,
                                 Verbosity verbosity);

}  // namespace assay::drivers
