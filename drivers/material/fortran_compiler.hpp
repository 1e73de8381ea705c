// SPDX-License-Identifier: BSD-3-Clause
// gfortran, as it compiles a routine that was written for Abaqus.
// What gfortran says of a source, in words for its author.
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
/// to be a fraction; each as "model.f:12: text", from the folder of the source. Throws InputError with the compiler's
/// first message, at the source's line, SystemError where the compiler cannot do its work.
std::vector<std::string> compile_library(const FortranSource& source, const FortranCompiler& compiler,
                                         const std::string& folder, const std::string& library);

/// Whether the compiler has something to say of a line of the source; else it failed by itself.
bool names_a_line(const std::string& said);

/// "x.f:12: 'n' is used uninitialized" of what it warns of and is seldom meant, each once. Its columns are those of the
/// end of a line, and are left out.
std::vector<std::string> warnings_in(const std::string& said);

/// The first error that it names, at its place in the source or in what that includes; version: the compiler's.
InputError refusal_of_compiler(const FortranSource& source, const std::string& version, const std::string& said);

}  // namespace assay::drivers
