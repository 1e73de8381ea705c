// SPDX-License-Identifier: BSD-3-Clause
// Gauss points of squares and cubes with straight edges, which are divided where a solution is not smooth: at an edge
// of the motion or a front of the material.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "harness/exact/exact_fields.hpp"
#include "harness/numeric/gauss.hpp"

namespace assay {

/// Of corners in the order of a square's, or in VTK's of a cube: the place at u in [0, 1]^Dim, and its derivatives.
template <int Dim>
struct MultilinearMap {
  std::array<Vector3, 1 << Dim> corners;

  Vector3 operator()(const std::array<double, Dim>& u) const {
    Vector3 x = Vector3::Zero();
    for (std::size_t k = 0; k < corners.size(); ++k) x += weight(k, u) * corners[k];
    return x;
  }
  Vector3 slope(const std::array<double, Dim>& u, std::size_t along) const {
    Vector3 x = Vector3::Zero();
    for (std::size_t k = 0; k < corners.size(); ++k) x += weight_slope(k, u, along) * corners[k];
    return x;
  }
  /// Of a corner's function: its value and its derivative along a direction.
  static double weight(std::size_t corner, const std::array<double, Dim>& u) { return weight(corner, u, Dim); }
  static double weight_slope(std::size_t corner, const std::array<double, Dim>& u, std::size_t along) {
    return (upper(corner, along) ? 1 : -1) * weight(corner, u, along);
  }

 private:
  static bool upper(std::size_t corner, std::size_t d) {
    return d == 0 ? (corner % 4 == 1 || corner % 4 == 2) : d == 1 ? corner % 4 >= 2 : corner >= 4;
  }
  /// Product of the linear functions of all directions but one.
  static double weight(std::size_t corner, const std::array<double, Dim>& u, std::size_t without) {
    double w = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      if (d != without) w *= upper(corner, d) ? u[d] : 1 - u[d];
    }
    return w;
  }
};

/// A box in [0, 1]^Dim.
template <int Dim>
struct PieceOfCube {
  std::array<double, Dim> lower{};
  double size = 1;

  std::array<double, Dim> at(const std::array<double, Dim>& share) const {
    std::array<double, Dim> u;
    for (std::size_t d = 0; d < Dim; ++d) u[d] = lower[d] + size * share[d];
    return u;
  }
};

/// visit(shares in [0, 1]^Dim) for all of a lattice of n^Dim.
template <int Dim>
void for_each_share(std::size_t n, const auto& visit) {
  std::size_t count = 1;
  for (int d = 0; d < Dim; ++d) count *= n;
  for (std::size_t k = 0; k < count; ++k) {
    std::array<std::size_t, Dim> index;
    for (std::size_t d = 0, rest = k; d < Dim; ++d, rest /= n) index[d] = rest % n;
    if (!visit(index)) return;
  }
}

/// Whether all of the piece seems to lie in one smooth part: as n^Dim of its points do.
template <int Dim>
bool is_smooth(const ExactSlice& slice, ExactSlice::Smooth of, const MultilinearMap<Dim>& map,
               const PieceOfCube<Dim>& piece, std::size_t n) {
  std::optional<std::size_t> part;
  bool one = true;
  for_each_share<Dim>(n, [&](const std::array<std::size_t, Dim>& index) {
    std::array<double, Dim> share;
    for (std::size_t d = 0; d < Dim; ++d) share[d] = static_cast<double>(index[d]) / static_cast<double>(n - 1);
    const std::size_t here = slice.part(map(piece.at(share)), of);
    one = !part || here == *part;
    part = here;
    return one;
  });
  return one;
}

/// Whether a piece is to be divided, which may be done so many times.
template <int Dim>
bool is_divided(const ExactSlice& slice, ExactSlice::Smooth of, const MultilinearMap<Dim>& map, int divisions,
                const PieceOfCube<Dim>& piece = {}) {
  constexpr std::size_t looks_first = 4, looks = 3;  // along each direction; of a whole face, and of its pieces
  return divisions > 0 && slice.has_parts(of) &&
         !is_smooth(slice, of, map, piece, piece.size == 1 ? looks_first : looks);
}

/// visit(u, weight) at Gauss points, of pieces that are halved in all directions where what is integrated is not
/// smooth.
template <int Dim>
void for_each_gauss_point(const ExactSlice& slice, ExactSlice::Smooth of, const MultilinearMap<Dim>& map,
                          std::span<const GaussPoint> gauss, int divisions, const PieceOfCube<Dim>& piece,
                          const auto& visit) {
  if (is_divided(slice, of, map, divisions, piece)) {
    for_each_share<Dim>(2, [&](const std::array<std::size_t, Dim>& index) {
      PieceOfCube<Dim> half{piece.lower, 0.5 * piece.size};
      for (std::size_t d = 0; d < Dim; ++d) half.lower[d] += half.size * static_cast<double>(index[d]);
      for_each_gauss_point(slice, of, map, gauss, divisions - 1, half, visit);
      return true;
    });
    return;
  }
  for_each_share<Dim>(gauss.size(), [&](const std::array<std::size_t, Dim>& index) {
    std::array<double, Dim> share;
    double weight = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      share[d] = 0.5 * (1 + gauss[index[d]].at);
      weight *= 0.5 * piece.size * gauss[index[d]].weight;
    }
    visit(piece.at(share), weight);
    return true;
  });
}

}  // namespace assay
