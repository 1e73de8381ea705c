// SPDX-License-Identifier: BSD-3-Clause
// The text of a Fortran source as a compiler reads it: lines, code without comments, statements.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

enum class FortranForm { fixed, free };
constexpr const char* word_of(FortranForm form) { return form == FortranForm::fixed ? "fixed" : "free"; }

/// Columns that a compiler reads of a line in fixed form: by the standard, by Abaqus, and without a bound.
inline constexpr std::size_t standard_columns = 72, abaqus_columns = 132, all_columns = std::string::npos;

/// Without line ends, those of Windows too, and without a byte order mark.
std::vector<std::string> lines_of_source(std::string_view bytes);

/// What of each line is code: comments are cut off, and blanks at the end. A character constant may go on in the next
/// line, and an exclamation mark in it begins no comment; so lines are to be given in their order.
class FortranCode {
 public:
  /// columns: that are read, of fixed form.
  explicit FortranCode(FortranForm form, std::size_t columns = abaqus_columns) : form_(form), columns_(columns) {}

  /// Columns of the result are those of the line; tabs at the beginning of fixed form are written out.
  std::string of(const std::string& line);
  /// Whether the last line ended in a character constant.
  bool is_open() const { return open_ != 0; }

 private:
  FortranForm form_;
  std::size_t columns_;
  char open_ = 0;  ///< the mark of a character constant that the line before has left open
};

/// Whether a line of fixed form, with its tabs written out, continues the one before.
bool continues_in_fixed_form(const std::string& code);

/// One statement: small letters, no blanks, no label; the text of a character constant is left out.
struct FortranStatement {
  int line = 0;  ///< at which it begins
  std::string text;
};

/// "model.f:12: ", as warnings begin.
std::string place_text(const std::string& file, int line);

std::vector<FortranStatement> statements_of(const std::vector<std::string>& lines, FortranForm form);

}  // namespace assay::drivers
