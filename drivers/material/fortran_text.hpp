// SPDX-License-Identifier: BSD-3-Clause
// The text of a Fortran source, read and not compiled: lines, code without comments, statements; its form, fixed or
// free, and its lines as gfortran can read them; where readings at 72 columns (the standard), at 132 (Abaqus) and
// without a bound differ; and what its statements say of routines and variables. What that cannot tell it leaves open.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
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

/// The first few of them, in a list: "K0, LAM and 3 others".
std::string few_names(const std::vector<std::string>& names);

std::vector<FortranStatement> statements_of(const std::vector<std::string>& lines, FortranForm form);

/// What a directive says of the lines behind it: "!DIR$ FREEFORM", "cDEC$ NOFREEFORM", "!DIR$ FIXEDFORMLINESIZE:132".
std::optional<FortranForm> form_by_directive(const std::string& line);

struct FoundForm {
  FortranForm form = FortranForm::fixed;  ///< free, where it changes
  bool mixed = false;                     ///< directives change it on the way
  std::string why;  ///< where the name does not tell: "by a directive in line 2", "by its text: line 3"; else empty
};

/// By directives (!DIR$ FREEFORM), else by the name, unless lines of the text cannot be of that form and none
/// contradicts the other.
FoundForm form_of_source(const std::string& file, const std::vector<std::string>& lines);

/// What the name alone says.
FortranForm form_by_name(const std::string& file);

/// The form of each line: that of the name, until a directive says another.
std::vector<FortranForm> forms_of_lines(const std::vector<std::string>& lines, FortranForm by_name);

/// Lines of fixed form as lines of free form; those whose form is free stay.
std::vector<std::string> in_free_form(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms);

/// Directives of the preprocessor in the first column, in small letters and with its quotes; an ampersand at the end of
/// a line of fixed form, as sources for both forms have it, is taken off.
std::vector<std::string> adapted_lines(const std::vector<std::string>& lines, const std::vector<FortranForm>& forms);

/// Whether a line is a directive of the preprocessor, wherever it begins.
bool is_preprocessor_line(const std::string& line, FortranForm form);

/// A line that has code beyond a column. Comments and blanks are none.
struct LongLine {
  int line = 0;
  std::string beyond;  ///< the code there, without blanks around it
  std::string before;  ///< the code up to there
};

struct ColumnReadings {
  std::vector<LongLine> tails;  ///< code in columns 73 to 132: read by Abaqus, cut at 72 columns
  std::vector<LongLine> cards;  ///< of these, numbers of punched cards in columns 73 to 80, which Abaqus reads as code
  std::vector<LongLine> cut;    ///< code beyond column 132, which Abaqus cuts
};

/// Cards are numbered where columns 73 to 80 hold numbers that rise from line to line, by themselves or behind the same
/// letters, and nothing stands beyond; a single line where all eight columns are digits behind a blank. Nothing is long
/// in free form.
ColumnReadings readings_of(const std::vector<std::string>& lines, FortranForm form);

/// What to tell of them, a sentence each, for warnings; `file` goes before the number of a line. by_abaqus: the source
/// is for Abaqus, of which it is known how it reads them.
std::vector<std::string> column_sentences(const ColumnReadings& readings, const std::string& file,
                                          bool by_abaqus = true);

/// What to tell of comments that end in a backslash where the preprocessor runs: it joins the next line to them.
std::vector<std::string> joined_line_sentences(const std::vector<std::string>& lines, FortranForm form,
                                               const std::string& file);

/// The command that takes the numbers of cards away: "cut -c1-72 model.f > model_72.f".
std::string card_remedy(const std::string& file);

struct FortranRoutine {
  std::string name;  ///< small letters
  std::vector<std::string> arguments;
  int line = 0, last_line = 0;               ///< of its text
  std::vector<FortranStatement> statements;  ///< those between its head and its end
};

/// The subroutines, in their order; those of modules and inner ones too.
std::vector<FortranRoutine> subroutines_of(const std::vector<FortranStatement>& statements);

/// One variable of a declaration: "real(8), intent(in) :: a(3), b" are two.
struct FortranVariable {
  std::string type;  ///< integer, real, doubleprecision, ...
  int bytes = 0;     ///< 0: its kind is no number
  std::string name;
  int line = 0;
};

std::vector<FortranVariable> variables_of(std::span<const FortranStatement> statements);

/// Declarations, IMPLICIT, DIMENSION and the like: nothing that is executed.
bool declares(const std::string& statement);

/// Whether a statement that is executed names the variable.
bool uses(std::span<const FortranStatement> statements, const std::string& variable);

/// How an array is indexed where it is used.
struct ArrayUse {
  bool used = false;
  int largest = 0;    ///< of the indices that are constants
  bool whole = true;  ///< all indices are constants, and no other routine is given it: `largest` is its size
};

/// The last index counts. `array` in small letters.
ArrayUse use_of(std::span<const FortranStatement> statements, const std::string& array);

/// The file names that INCLUDE and #include lines name.
struct FortranInclude {
  std::string name;
  int line = 0;
};

std::vector<FortranInclude> includes_of(const std::vector<std::string>& lines, FortranForm form);

}  // namespace assay::drivers
