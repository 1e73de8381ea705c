// SPDX-License-Identifier: BSD-3-Clause
// A Fortran source on the command line: what was given, and what is told of it.
#pragma once

#include <string>

#include "drivers/material/source_description.hpp"
#include "drivers/text/verbosity.hpp"

namespace assay::drivers {

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

/// Describes the source `material`, absolute, tells on standard error what was taken and guessed, and writes the
/// description to DIR/NAME.yaml, or beside it where somebody has edited that. The file, absolute. Throws InputError,
/// SystemError.
std::string described_source(const std::string& material, SourceRequest request, const std::string& folder,
                             Verbosity verbosity);

}  // namespace assay::drivers
