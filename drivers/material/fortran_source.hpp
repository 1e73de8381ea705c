// SPDX-License-Identifier: BSD-3-Clause
// A Fortran source with all that it includes, read and not compiled.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_text.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// A file that a source includes, by the name that it says.
struct IncludedFile {
  std::string name;
  std::string path;  ///< in the source's folder, where letters of the other size count too; empty: this program's own
  std::string bytes;
  std::string adapted;  ///< what gfortran is given in its place; empty: itself
};

struct FortranSource {
  std::string file;  ///< absolute
  std::string bytes;
  FoundForm form;
  std::vector<std::string> lines;            ///< as gfortran reads them: see fortran_form.hpp
  std::string adapted;                       ///< the same where they are not those of the file; else empty
  bool preprocessed = false;                 ///< its name ends in capitals, or it has lines that begin with '#'
  std::vector<IncludedFile> includes;        ///< those that are found
  std::vector<FortranStatement> statements;  ///< its own, and those of files of its folder
  std::vector<std::string> warnings;         ///< sentences on columns, of the source and of files of its folder

  std::vector<FortranRoutine> routines() const { return subroutines_of(statements); }
  bool includes_parameters(const FortranRoutine& routine) const;  ///< ABA_PARAM.INC, VABA_PARAM.INC
  bool has_cards = false;                                         ///< numbers of punched cards, which are read as code
  int cut_line = 0;                                               ///< the first with code beyond column 132; 0: none
  std::vector<std::string> link;                                  ///< what it is linked with: words of linked_word()
  std::vector<Location> link_where = {};                          ///< of each in a description; empty: in none
};

/// Throws InputError at `where`, `key`: missing, no text, too long.
FortranSource read_fortran_source(const std::string& file, const Location& where, const std::string& key);

/// The source of the same name beside a deck. Throws InputError at `where`, `key` where there is none, or several.
std::string source_beside(const std::string& deck, const Location& where, const std::string& key);

/// The text of a file that the routine's host provides, by its name in any letters. Of Abaqus: ABA_PARAM.INC,
/// VABA_PARAM.INC, SMAAspUserSubroutines.hdr and its like. Of Ansys: impcom.inc. Of LS-DYNA: nlqparm, bk06.inc,
/// iounits.inc. Empty for any other name.
std::string include_of_host(const std::string& name);

/// "lapack" is a library of the linker's folders (-llapack), "./mine.a" a file (.a, .o, .so) relative to `folder`: the
/// word of either, files absolute. Throws InputError at `where`, `key`.
std::string linked_word(const std::string& said, const std::string& folder, const Location& where,
                        const std::string& key);

/// The arguments of the compiler for such a word.
std::vector<std::string> link_arguments(const std::string& word);

/// What a library depends on when it is linked with such a word: its name, and the bytes of a file.
std::string link_content(const std::string& word);

}  // namespace assay::drivers
