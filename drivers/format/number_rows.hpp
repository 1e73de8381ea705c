// SPDX-License-Identifier: BSD-3-Clause
// Rows of numbers under names, whatever file they come from.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

class NumberRows {
 public:
  virtual ~NumberRows() = default;

  const std::vector<std::string>& names() const { return names_; }  ///< as in the file
  int header_line() const { return header_line_; }                  ///< from 1; 0: there are no lines

  /// The numbers of the next row, finite and in the order of the names. False at the end. Throws InputError.
  virtual bool next(std::vector<double>& row) = 0;
  virtual double share() const = 0;  ///< of the file that was read
  virtual int line() const = 0;      ///< of the row; its number in a file without lines; from 1

 protected:
  std::vector<std::string> names_;
  int header_line_ = 0;
};

}  // namespace assay::drivers
