// SPDX-License-Identifier: BSD-3-Clause
// The points that `eval` and `tabulate` are asked for.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

/// A reference point at a time, with the outward unit normal of a surface element where one is given.
struct ReferencePoint {
  double X = 0, Y = 0, Z = 0;     ///< [m]
  double t = 0;                   ///< [s]
  double NX = 0, NY = 0, NZ = 0;  ///< [1], as given
  double HX = 0, HY = 0, HZ = 0;  ///< half edges of the box around it over which b is averaged [m]; 0: at the point
  int line = 0;                   ///< in the file, from 1
};

struct ReferencePoints {
  std::vector<ReferencePoint> points;
  bool has_z = false, has_normals = false, has_third_normal = false, has_boxes = false, has_third_edge = false;
};

/// Columns X,Y,t and perhaps Z, NX and NY (both or neither), with them perhaps NZ, not all zero; HX and HY likewise,
/// with them perhaps HZ, all above 0. Throws InputError as read_csv does, and for t < 0.
ReferencePoints read_reference_points(const std::string& file);

/// A point of the response sheet.
struct SheetPoint {
  double xi = 0;  ///< [1]
  double t = 0;   ///< [s]
  int line = 0;   ///< in the file, from 1
};

/// Columns xi,t. Throws InputError as read_csv does, and for t < 0.
std::vector<SheetPoint> read_sheet_points(const std::string& file);

}  // namespace assay::drivers
