// SPDX-License-Identifier: BSD-3-Clause
// gfortran, as it compiles a routine that was written for Abaqus, what it says in words for the author, and the library
// of a source, which is compiled once and kept.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_source.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

struct FortranCompiler {
  std::string program;               ///< absolute
  std::vector<std::string> options;  ///< that $FC holds behind its name
  std::string version;               ///< "GNU Fortran (Debian 12.2.0-14) 12.2.0"
};

/// The first gfortran of $PATH, or the one that $FC names; another compiler there is left alone. Throws SystemError
/// where there is none: `file` is what it would compile.
FortranCompiler find_fortran_compiler(const std::string& file);

/// What it is called with beside files: as Abaqus compiles, and so that the results do not depend on the processor.
std::vector<std::string> flags_for(const FortranSource& source, const FortranCompiler& compiler);

/// Compiles into a shared library. `folder` is empty, and for what is made on the way. Returns what the compiler warns
/// of and is seldom meant: arguments of another type or too few, a variable that is never set, a whole number that was
/// to be a fraction, a whole number that takes a real one; each as "model.f:12: text", from the folder of the source.
/// Throws InputError with the compiler's first message, at the source's line, SystemError where the compiler cannot do
/// its work.
std::vector<std::string> compile_library(const FortranSource& source, const FortranCompiler& compiler,
                                         const std::string& folder, const std::string& library);

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

/// Whether a library is named as library_of_source() names its own.
bool is_made_of_source(const std::string& library);

/// Keeps a description that was made of a source, under a name that its text has alone. Throws SystemError.
std::string kept_description(const std::string& stem, const std::string& text);

}  // namespace assay::drivers
