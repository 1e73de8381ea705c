// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/snapshot_vtu.hpp"

#include <algorithm>
#include <span>

#include "drivers/output/vtu_cells.hpp"
#include "mpm/compose.hpp"

namespace assay::drivers {

namespace {

/// Where each component of a column stands in VTK's vector or tensor.
template <int Dim>
std::span<const std::size_t> places_in_vtk(const ShownColumn& shown) {
  static constexpr std::size_t in_vector[] = {0, 1, 2}, plane_tensor[] = {0, 1, 3, 4, 8},
                               tensor[] = {0, 1, 2, 3, 4, 5, 6, 7, 8}, symmetric[] = {0, 4, 8, 1, 2, 5};
  if (shown.components <= Dim) return in_vector;
  if (Dim == 2) return plane_tensor;
  return shown.components == mpm::stress_components<3> ? std::span<const std::size_t>(symmetric) : tensor;
}

/// Rearranges a part of a column for VTK. The components of a particle stand side by side, and vectors and tensors have
/// three dimensions. A tensor in the plane brings its component 33 with it; if it has none, 33 is 1. A symmetric one in
/// space gets its lower half. values: zero.
template <int Dim>
void interleave(const ColumnView& of, const ShownColumn& shown, std::size_t first, std::size_t count, double* values) {
  const bool is_tensor = shown.components > Dim;
  const auto width = static_cast<std::size_t>(shown.width());
  const auto places = places_in_vtk<Dim>(shown);
  for (int c = 0; c < shown.components; ++c) {
    const double* from = of(shown.column, c) + first;
    const std::size_t at = places[static_cast<std::size_t>(c)], mirrored = at % 3 * 3 + at / 3;
    for (std::size_t p = 0; p < count; ++p) values[width * p + at] = from[p];
    const bool is_half = Dim == 3 && shown.components == mpm::stress_components<3> && mirrored != at;
    for (std::size_t p = 0; is_half && p < count; ++p) values[width * p + mirrored] = from[p];
  }
  const bool has_33 = !is_tensor || Dim == 3 || shown.components > mpm::tensor_components<2>;
  for (std::size_t p = 0; !has_33 && p < count; ++p) values[width * p + 8] = 1;  // plane strain
}

std::string name_of(const ShownColumn& shown) { return std::string(mpm::info(shown.column).name); }

}  // namespace

std::string particles_vtu(const std::vector<ShownColumn>& shown, const ColumnView& of, std::size_t particles,
                          const std::vector<VtuArray>& more, double t, const std::optional<double>& velocity_t) {
  std::vector<std::int64_t> id(particles);
  for (std::size_t p = 0; p < particles; ++p) id[p] = static_cast<std::int64_t>(p);
  std::vector<std::vector<double>> values;
  for (const ShownColumn& one : shown) {
    auto& array = values.emplace_back(static_cast<std::size_t>(one.width()) * particles, 0.0);
    interleave<2>(of, one, 0, particles, array.data());
  }
  const std::vector<double>& position = values[1];
  std::vector<double> displacement(position);
  for (std::size_t k = 0; k < displacement.size(); ++k) displacement[k] -= values[0][k];
  std::vector<VtuArray> arrays{{"id", 1, std::span<const std::int64_t>(id)},
                               {"reference_position", 3, std::span<const double>(values[0])},
                               {"displacement", 3, std::span<const double>(displacement)}};
  for (std::size_t k = 2; k < shown.size(); ++k)
    arrays.push_back({name_of(shown[k]), shown[k].width(), std::span<const double>(values[k])});
  arrays.insert(arrays.end(), more.begin(), more.end());
  return vtu_text(position, arrays, t, velocity_t);
}

void put_particles(const PutBytes& put, const std::vector<ShownColumn>& shown, const ColumnView& of,
                   const SpaceDomains::Now& domains, std::size_t particles, const std::vector<VtuArray>& more, double t,
                   const std::optional<double>& velocity_t) {
  std::vector<MadeArray<double>> arrays;
  for (const ShownColumn& one : shown) {
    arrays.push_back({name_of(one), one.width(), [&](std::size_t first, std::size_t count, double* out) {
                        std::fill_n(out, count * static_cast<std::size_t>(one.width()), 0.0);
                        interleave<3>(of, one, first, count, out);
                      }});
  }
  const auto displacement = [&](std::size_t first, std::size_t count, double* out) {
    for (int d = 0; d < 3; ++d) {
      const double *X = of(shown[0].column, d) + first, *x = of(shown[1].column, d) + first;
      for (std::size_t p = 0; p < count; ++p) out[3 * p + static_cast<std::size_t>(d)] = x[p] - X[p];
    }
  };
  arrays.insert(arrays.begin() + 2, {"displacement", 3, displacement});
  for (const VtuArray& one : more) {
    const double* from = std::get<std::span<const double>>(one.values).data();
    arrays.push_back({one.name, 1, [from](std::size_t first, std::size_t count, double* out) {
                        std::copy_n(from + first, count, out);
                      }});
  }
  const MadeArray<double> corners{"", 24, [&](std::size_t first, std::size_t count, double* out) {
                                    for (std::size_t p = 0; p < count; ++p) {
                                      const SpaceDomains::Corners x = domains.corners(first + p);
                                      for (const std::size_t corner : corners_in_vtk)
                                        for (int d = 0; d < 3; ++d) *out++ = x[corner](d);
                                    }
                                  }};
  write_cells(put, particles, arrays, corners, t, velocity_t);
}

}  // namespace assay::drivers
