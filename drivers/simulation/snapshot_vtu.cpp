// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/snapshot_vtu.hpp"

#include <span>

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

/// Rearranges a column for VTK. The components of a particle stand side by side, and vectors and tensors have three
/// dimensions. A tensor in the plane brings its component 33 with it; if it has none, 33 is 1. A symmetric one in space
/// gets its lower half.
template <int Dim>
std::vector<double> interleaved(const ColumnView& of, std::size_t particles, const ShownColumn& shown) {
  const bool is_tensor = shown.components > Dim;
  const auto width = static_cast<std::size_t>(shown.width());
  const auto places = places_in_vtk<Dim>(shown);
  std::vector<double> values(width * particles, 0.0);
  for (int c = 0; c < shown.components; ++c) {
    const double* from = of(shown.column, c);
    const std::size_t at = places[static_cast<std::size_t>(c)], mirrored = at % 3 * 3 + at / 3;
    for (std::size_t p = 0; p < particles; ++p) values[width * p + at] = from[p];
    const bool is_half = Dim == 3 && shown.components == mpm::stress_components<3> && mirrored != at;
    for (std::size_t p = 0; is_half && p < particles; ++p) values[width * p + mirrored] = from[p];
  }
  const bool has_33 = !is_tensor || Dim == 3 || shown.components > mpm::tensor_components<2>;
  for (std::size_t p = 0; !has_33 && p < particles; ++p) values[width * p + 8] = 1;  // plane strain
  return values;
}

}  // namespace

template <int Dim>
std::string particles_vtu(const std::vector<ShownColumn>& shown, const ColumnView& of, std::size_t particles,
                          const std::vector<VtuArray>& more, double t, const std::optional<double>& velocity_t) {
  std::vector<std::int64_t> id(particles);
  for (std::size_t p = 0; p < particles; ++p) id[p] = static_cast<std::int64_t>(p);
  std::vector<std::vector<double>> values;
  for (const ShownColumn& one : shown) values.push_back(interleaved<Dim>(of, particles, one));
  const std::vector<double>& position = values[1];
  std::vector<double> displacement(position);
  for (std::size_t k = 0; k < displacement.size(); ++k) displacement[k] -= values[0][k];
  std::vector<VtuArray> arrays{{"id", 1, std::span<const std::int64_t>(id)},
                               {"reference_position", 3, std::span<const double>(values[0])},
                               {"displacement", 3, std::span<const double>(displacement)}};
  for (std::size_t k = 2; k < shown.size(); ++k) {
    const std::string name(mpm::info(shown[k].column).name);
    arrays.push_back({name, shown[k].width(), std::span<const double>(values[k])});
  }
  arrays.insert(arrays.end(), more.begin(), more.end());
  return vtu_text(position, arrays, t, velocity_t);
}

template std::string particles_vtu<2>(const std::vector<ShownColumn>&, const ColumnView&, std::size_t,
                                      const std::vector<VtuArray>&, double, const std::optional<double>&);
template std::string particles_vtu<3>(const std::vector<ShownColumn>&, const ColumnView&, std::size_t,
                                      const std::vector<VtuArray>&, double, const std::optional<double>&);

}  // namespace assay::drivers
