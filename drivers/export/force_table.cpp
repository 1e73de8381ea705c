// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/force_table.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/exact/places.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t fewest_intervals = 16, most_intervals = 512;  ///< of a period
constexpr double most_periods = 32;
/// Twice as many times make the error of a smooth force sixteen times smaller. Where it does not even become half, more
/// of them are of no use; with fewer than so many intervals of a period that is not known.
constexpr double of_no_use = 0.5;
constexpr std::size_t tried_intervals = 64;
constexpr double gib = 1024.0 * 1024 * 1024;

/// Weights of the four values at -1, 0, 1, 2 of a cubic at s.
std::array<double, 4> cubic_weights(double s) {
  return {-s * (s - 1) * (s - 2) / 6, (s + 1) * (s - 1) * (s - 2) / 2, -(s + 1) * s * (s - 2) / 2,
          (s + 1) * s * (s - 1) / 6};
}

double longest_vector(std::span<const double> values, std::size_t dimension) {
  double longest = 0;
  for (std::size_t k = 0; k < values.size(); k += dimension) {
    double square = 0;
    for (std::size_t d = 0; d < dimension; ++d) square += values[k + d] * values[k + d];
    longest = std::max(longest, square);
  }
  return std::sqrt(longest);
}

/// 16, 24, 32, 48, ... of each period.
std::size_t next_intervals(std::size_t intervals, std::size_t periods) {
  const std::size_t each = intervals / periods;
  return periods * (each % 3 == 0 ? each / 3 * 4 : each / 2 * 3);
}

void fill(ForceTable& table, const VectorsOverTime& vectors, std::size_t intervals, double end) {
  const std::size_t row = table.points * table.dimension;
  table.times = intervals + 1, table.step = end / static_cast<double>(intervals);
  table.values.resize(table.times * row);
  for (std::size_t k = 0; k < table.times; ++k) {
    stop_if_interrupted();
    vectors(k == intervals ? end : table.step * static_cast<double>(k), std::span(table.values).subspan(k * row, row));
  }
  table.largest = longest_vector(table.values, table.dimension);
}

/// Measured halfway between times; in the first and last intervals, where the cubic is one-sided, where its error is
/// largest.
void measure(ForceTable& table, const VectorsOverTime& vectors) {
  constexpr double one_sided = 0.381966;  // where s (s - 1) (s - 2) (s - 3) is largest, between 0 and 1
  std::vector<double> exact(table.points * table.dimension);
  table.error = 0;
  for (std::size_t k = 0; k + 1 < table.times; ++k) {
    stop_if_interrupted();
    const double s = k == 0 ? one_sided : k + 2 == table.times ? 1 - one_sided : 0.5;
    const double t = table.step * (static_cast<double>(k) + s);
    vectors(t, exact);
    const std::vector<double> found = table.at(t);
    std::ranges::transform(exact, found, exact.begin(), std::minus());
    table.error = std::max(table.error, longest_vector(exact, table.dimension));
  }
  if (table.largest > 0) table.error /= table.largest;
}

template <class Number>
void append_bytes(std::string& to, const Number& value) {
  static_assert(std::endian::native == std::endian::little);
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::vector<double> ForceTable::at(double t) const {
  const double place = std::clamp(t / step, 0.0, static_cast<double>(times - 1));
  const std::size_t last = times - 4;
  const auto begin = static_cast<std::size_t>(std::clamp(std::floor(place) - 1, 0.0, static_cast<double>(last)));
  const std::array<double, 4> weights = cubic_weights(place - static_cast<double>(begin + 1));
  const std::size_t row = points * dimension;
  std::vector<double> out(row, 0.0);
  for (std::size_t w = 0; w < 4; ++w) {
    const double* from = values.data() + (begin + w) * row;
    for (std::size_t k = 0; k < row; ++k) out[k] += weights[w] * from[k];
  }
  return out;
}

ForceTable table_over_time(const VectorsOverTime& vectors, std::size_t points, int dimension, double end, double period,
                           double limit_gib) {
  ForceTable table;
  table.points = points, table.dimension = static_cast<std::size_t>(dimension);
  const auto periods = static_cast<std::size_t>(std::ceil(std::clamp(end / period, 1.0, most_periods)));
  std::vector<double> errors;
  for (std::size_t intervals = periods * fewest_intervals;; intervals = next_intervals(intervals, periods)) {
    const double bytes = 8.0 * static_cast<double>((intervals + 1) * points * table.dimension);
    if (bytes > limit_gib * gib)
      throw InputError({}, "limits.memory_gib",
                       "a table of " + std::to_string(intervals + 1) + " times at " +
                           grouped_text(static_cast<std::int64_t>(points)) + " points needs " +
                           rounded_text(bytes / gib, 3) + " GiB, more than " + rounded_text(limit_gib, 6) +
                           ": take coarser --grids");
    fill(table, vectors, intervals, end);
    measure(table, vectors);
    errors.push_back(table.error);
    const bool helped = errors.size() < 3 || table.error <= of_no_use * errors[errors.size() - 3];
    if (table.error <= interpolation_error || intervals >= periods * most_intervals) return table;
    if (intervals >= periods * tried_intervals && !helped) return table;
  }
}

ForceTable body_force_table(const ExportedProblem& problem, const ExportedGrid& grid) {
  const auto places = problem.exact->places(grid.X);
  const auto dimension = static_cast<std::size_t>(problem.dimension);
  const auto force = [&](double t, std::span<double> out) {
    const FieldView view{out.data(), static_cast<std::ptrdiff_t>(dimension), 1};
    const auto slice = problem.exact->slice(t);
    FieldViews views{.dimension = dimension};
    (problem.quasi_static ? views.static_force : views.b) = view;
    places->evaluate(*slice, 0, places->size(), views);
  };
  return table_over_time(force, grid.size(), problem.dimension, problem.end, problem.period,
                         problem.scene.limits.memory_gib);
}

ForceTable traction_table(const ExportedProblem& problem, const std::vector<SurfaceFace>& faces) {
  std::vector<Vector3> X;
  for (const SurfaceFace& face : faces) X.push_back(face.X);
  const auto places = problem.exact->places(std::move(X));
  constexpr std::ptrdiff_t components = 9;
  std::vector<double> P(components * faces.size());
  const auto traction = [&](double t, std::span<double> out) {
    const auto slice = problem.exact->slice(t);
    FieldViews views;
    views.P = {P.data(), components, 1};
    places->evaluate(*slice, 0, faces.size(), views);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> here(P.data() + components * k);
      const Vector3 force = here * faces[k].normal;
      for (int d = 0; d < problem.dimension; ++d)
        out[k * static_cast<std::size_t>(problem.dimension) + static_cast<std::size_t>(d)] = force[d];
    }
  };
  return table_over_time(traction, faces.size(), problem.dimension, problem.end, problem.period,
                         problem.scene.limits.memory_gib);
}

ForceTable nodal_load_table(const ExportedProblem& problem, const ExportedGrid& grid) {
  const NodalLoads loads(mesh_of(grid, problem.dimension), *problem.exact, problem.density,
                         {.quasi_static = problem.quasi_static});
  const auto force = [&](double t, std::span<double> out) {
    const auto slice = problem.exact->slice(t);
    const std::vector<Vector3> forces = loads.at(*slice);
    for (std::size_t k = 0; k < forces.size(); ++k) {
      for (int d = 0; d < problem.dimension; ++d)
        out[k * static_cast<std::size_t>(problem.dimension) + static_cast<std::size_t>(d)] = forces[k][d];
    }
  };
  return table_over_time(force, grid.size(), problem.dimension, problem.end, problem.period,
                         problem.scene.limits.memory_gib);
}

std::string bytes_of_table(const ForceTable& table) {
  std::string bytes = "ASSAYFT1";
  for (const std::size_t count : {table.times, table.points, table.dimension})
    append_bytes(bytes, static_cast<std::int64_t>(count));
  append_bytes(bytes, 0.0);
  append_bytes(bytes, table.step);
  bytes.append(reinterpret_cast<const char*>(table.values.data()), table.values.size() * sizeof(double));
  return bytes;
}

std::map<std::string, std::string> table_routines() {
  std::map<std::string, std::string> files;
  for (const char* file : {"force_table.py", "force_table.h", "force_table.c", "force_table.f90"})
    files[file] = filled_template("common", file);
  return files;
}

std::string table_words(const ForceTable& table, const std::string& unit) {
  const std::string measured =
      std::to_string(table.times) + " times; cubic interpolation between them is off by at most " +
      rounded_text(table.error, 2) + " of the largest value, " + rounded_text(table.largest, 3) + " " + unit + ".";
  return table.error <= interpolation_error
             ? measured
             : measured + " This is more than " + rounded_text(interpolation_error, 2) +
                   ", because the force has kinks in time. Do not expect the order of a smooth problem.";
}

}  // namespace assay::drivers
