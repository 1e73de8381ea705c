// SPDX-License-Identifier: BSD-3-Clause
// The points of the response that `tabulate` is asked for.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

/// A point of the response sheet.
struct SheetPoint {
  double xi = 0;  ///< [1]
  double t = 0;   ///< [s]
  int line = 0;   ///< in the file, from 1
};

/// Columns xi,t. Throws InputError as read_csv does, and for t < 0.
std::vector<SheetPoint> read_sheet_points(const std::string& file);

}  // namespace assay::drivers
