// SPDX-License-Identifier: BSD-3-Clause
// @RotationMatrix: the directions of an orthotropic material, as a matrix, Euler's angles, Miller's indices or vectors.
#include <cmath>
#include <limits>

#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

using Vector = std::array<double, 3>;
using Rows = std::array<double, 9>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector unit(MtestTokens& tokens, const Location& where, const Vector& v) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 0) || !std::isfinite(length)) tokens.refuse(where, "a direction has no length");
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rows of_columns(const Vector& a, const Vector& b, const Vector& c) {
  return {a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]};
}

/// The numbers between the braces, as many as must be there.
std::vector<double> read_some(MtestReading& reading, std::size_t count) {
  const Location where = reading.tokens.where();
  std::vector<double> values = read_numbers(reading);
  if (values.size() != count) reading.tokens.refuse(where, std::to_string(count) + " numbers are needed");
  return values;
}

/// The rows are the rotations about z by psi, about the new x by theta, about the new z by phi, one after the other.
Rows of_euler_angles(const std::vector<double>& angles) {
  const double c1 = std::cos(angles[0]), s1 = std::sin(angles[0]), c2 = std::cos(angles[1]), s2 = std::sin(angles[1]);
  const double c3 = std::cos(angles[2]), s3 = std::sin(angles[2]);
  return {c3 * c1 - s3 * c2 * s1,
          c3 * s1 + s3 * c2 * c1,
          s3 * s2,
          -s3 * c1 - c3 * c2 * s1,
          -s3 * s1 + c3 * c2 * c1,
          c3 * s2,
          s2 * s1,
          -s2 * c1,
          c2};
}

/// The third row is the unit vector along [h k l], the first one is normal to it in the plane of x and y.
Rows of_miller_indices(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const Location where = tokens.where();
  const std::vector<double> indices = read_some(reading, 3);
  for (const double index : indices)
    if (index != std::floor(index)) tokens.refuse(where, "Miller's indices are whole numbers");
  const Vector n = unit(tokens, where, {indices[0], indices[1], indices[2]});
  const double flat = std::hypot(n[0], n[1]);
  const Vector first = flat > 0 ? Vector{n[1] / flat, -n[0] / flat, 0} : Vector{1, 0, 0};
  const double c = first[0], s = -first[1];
  return {c, -s, 0, n[2] * s, n[2] * c, -flat, n[0], n[1], n[2]};
}

Rows of_directions(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const Location where = tokens.where();
  const std::vector<double> values = read_numbers(reading);
  if (values.size() == 2 && reading.hypothesis().vector.size() == 2) {
    const Vector a = unit(tokens, where, {values[0], values[1], 0});
    return of_columns(a, {-a[1], a[0], 0}, {0, 0, 1});
  }
  if (values.size() != 6 || reading.hypothesis().vector.size() != 3)
    tokens.refuse(where, "two numbers in the plane, two vectors in space");
  const Vector a = unit(tokens, where, {values[0], values[1], values[2]});
  const Vector given{values[3], values[4], values[5]};
  const double along = dot(a, given);
  const Vector b = unit(tokens, where, {given[0] - along * a[0], given[1] - along * a[1], given[2] - along * a[2]});
  return of_columns(a, b, cross(a, b));
}

/// Throws where the columns are no orthonormal directions.
void check_rotation(MtestTokens& tokens, const Location& where, const Rows& rows) {
  constexpr double eps = 100 * std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double product = dot({rows[i], rows[3 + i], rows[6 + i]}, {rows[j], rows[3 + j], rows[6 + j]});
      if (std::abs(product - (i == j ? 1 : 0)) <= eps) continue;
      tokens.refuse(where, "no rotation: the scalar product of the columns " + std::to_string(i + 1) + " and " +
                               std::to_string(j + 1) + " is " + rounded_text(product, 6));
    }
  }
}

}  // namespace

void read_rotation(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  if (reading.out.is_rotated) tokens.refuse("the rotation is there already");
  const Location of_type = tokens.where();
  const std::string type = read_type(reading);
  const Location where = tokens.where();
  Rows rows{};
  if (type.empty() || type == "Standard") {
    const std::vector<double> values = read_some(reading, 9);
    std::copy(values.begin(), values.end(), rows.begin());
  } else if (type == "Euler") {
    rows = of_euler_angles(read_some(reading, 3));
  } else if (type == "Miller") {
    rows = of_miller_indices(reading);
  } else if (type == "Direction") {
    rows = of_directions(reading);
  } else {
    tokens.refuse(of_type, "'" + type + "' is no kind of rotation", "Standard, Euler, Miller, Direction");
  }
  check_rotation(tokens, where, rows);
  reading.out.rotation = rows;
  reading.out.is_rotated = true;
  tokens.expect(";");
}

}  // namespace assay::drivers
