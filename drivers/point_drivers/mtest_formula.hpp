// SPDX-License-Identifier: BSD-3-Clause
// A formula as MTest writes it, ready to be evaluated.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// Operators + - * / **, comparisons, && || !, "condition ? a : b", and the functions of mtest_functions(). Powers bind
/// closest and are taken from the left: a**b**c is (a**b)**c. The names of variables may hold indices, as omega[2].
class MtestFormula {
 public:
  /// Throws InputError at the character that is wrong. where: of the first character of the text.
  MtestFormula(const std::string& text, const Location& where);

  /// In the order in which they first appear.
  const std::vector<std::string>& variables() const { return variables_; }
  /// `values` are those of the variables, in their order. Two threads must not evaluate one formula at once.
  double value(const std::vector<double>& values) const;

 private:
  struct Program;

  std::vector<std::string> variables_;
  std::shared_ptr<Program> program_;
};

/// The names of functions, which no variable may have.
const std::vector<std::string>& mtest_functions();

}  // namespace assay::drivers
