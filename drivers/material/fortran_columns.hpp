// SPDX-License-Identifier: BSD-3-Clause
// A source in fixed form, read at 72 columns as the standard has it, at 132 as Abaqus does, and without a bound: where
// the readings differ.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/fortran_text.hpp"

namespace assay::drivers {

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

/// What to tell of them, a sentence each, for warnings; `file` goes before the number of a line.
std::vector<std::string> column_sentences(const ColumnReadings& readings, const std::string& file);

/// What to tell of comments that end in a backslash where the preprocessor runs: it joins the next line to them.
std::vector<std::string> joined_line_sentences(const std::vector<std::string>& lines, FortranForm form,
                                               const std::string& file);

/// The command that takes the numbers of cards away: "cut -c1-72 model.f > model_72.f".
std::string card_remedy(const std::string& file);

}  // namespace assay::drivers
