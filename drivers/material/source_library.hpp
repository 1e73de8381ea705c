// SPDX-License-Identifier: BSD-3-Clause
// The library of a Fortran source, compiled once and kept.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_source.hpp"

namespace assay::drivers {

/// The folder of libraries and descriptions made from sources, CACHE/sources. Throws SystemError where there is none.
std::string source_folder();

struct SourceLibrary {
  std::string file;                   ///< absolute
  std::string compiler;               ///< its version
  std::vector<std::string> warnings;  ///< of the compiler: "/home/me/model.f:12: text"
};

/// Compiles the source unless its library is kept: one file for each content of the source and what it includes,
/// compiler and flags. Two processes may do so at once; what does not compile leaves nothing. Throws InputError,
/// SystemError.
SourceLibrary library_of_source(const FortranSource& source);

/// Keeps a description that was made of a source, under a name that its text has alone. Throws SystemError.
std::string kept_description(const std::string& stem, const std::string& text);

}  // namespace assay::drivers
