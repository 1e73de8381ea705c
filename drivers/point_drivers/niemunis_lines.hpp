// SPDX-License-Identifier: BSD-3-Clause
// Lines of values as Fortran reads them: between blanks or commas, with remarks behind them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

struct NiemunisField {
  std::string text;
  Location where;
};

class NiemunisLines {
 public:
  NiemunisLines(std::string_view text, const std::string& file);

  /// Steps to the next line that has a field; false at the end.
  bool next();
  /// The same where there must be one: `what` is missing otherwise.
  void need(const std::string& what);

  std::string_view line() const { return line_; }
  Location where(std::size_t column = 0) const { return {file_, number_, static_cast<int>(column) + 1}; }
  /// Of the line, or of its end behind a column.
  std::vector<NiemunisField> fields(std::size_t from = 0) const;

  /// That many numbers at the begin of the next line. what: "stress or strain, and its change".
  std::vector<double> numbers(std::size_t count, const std::string& what);
  /// A whole number from `least` at the begin of the next line.
  int count(int least, const std::string& what);

 private:
  std::string_view rest_;
  std::string file_;
  std::string_view line_;
  int number_ = 0;
};

/// As Fortran writes it, also 1.5d-3. Throws InputError.
double niemunis_number(const NiemunisField& field);
int niemunis_count(const NiemunisField& field, int least);

}  // namespace assay::drivers
