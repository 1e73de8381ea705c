// SPDX-License-Identifier: BSD-3-Clause
// Vectors of many points over time, dense enough for cubic interpolation: what codes read that cannot call assay.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "drivers/export/export.hpp"

namespace assay::drivers {

/// Values at equal steps of time. Between them: the cubic through the four nearest times.
struct ForceTable {
  double step = 0;  ///< between times, the first of which is 0 [s]
  std::size_t times = 0, points = 0, dimension = 0;
  std::vector<double> values;  ///< [(time * points + point) * dimension + component]
  double largest = 0;          ///< length of a vector
  double error = 0;            ///< of the interpolation, of the largest length [1]

  /// As the routines of the templates interpolate: all components of all points.
  std::vector<double> at(double t) const;
};

/// What a table is made of: writes all components of all points at a time.
using VectorsOverTime = std::function<void(double t, std::span<double> out)>;

/// The largest error of the interpolation that is asked for, of the largest vector [1].
inline constexpr double interpolation_error = 1e-4;

/// As many times as the error asks for, up to where more do not help; the error is measured halfway between the times.
/// period: of the motion. limit_gib: of memory. Throws InputError where it would be more.
ForceTable table_over_time(const VectorsOverTime& vectors, std::size_t points, int dimension, double end, double period,
                           double limit_gib);

/// b at the seeds of a grid, with or without inertia as the problem says [m/s^2].
ForceTable body_force_table(const ExportedProblem& problem, const ExportedGrid& grid);

/// P N on faces of the surface, per reference area [Pa].
ForceTable traction_table(const ExportedProblem& problem, const std::vector<SurfaceFace>& faces);

/// Consistent forces on the nodes of a grid's mesh [N]; in the plane per metre of thickness [N/m].
ForceTable nodal_load_table(const ExportedProblem& problem, const ExportedGrid& grid);

/// The file that the routines read: "ASSAYFT1", three integers of 64 bits (times, points, components), the first time
/// and the step, then the values; all of them little-endian.
std::string bytes_of_table(const ForceTable& table);

/// The routines in C, Fortran and Python, by their names.
std::map<std::string, std::string> table_routines();

/// A sentence on times and error, and what follows where the error is larger than asked for.
std::string table_words(const ForceTable& table, const std::string& unit);

}  // namespace assay::drivers
