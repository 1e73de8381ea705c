// SPDX-License-Identifier: BSD-3-Clause
// Nodes beyond symmetry planes and periodic ends are images of nodes of the body: what particles give to them belongs
// to those, and they move as those do.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mpm/grid/grid_field.hpp"
#include "mpm/grid/grid_geometry.hpp"

namespace assay::mpm {

/// The body's ends along one axis; planes lie on nodes.
struct AxisEnds {
  std::optional<double> lower, upper;  ///< of planes that are not free ends [m]
  bool periodic = false;               ///< both are one; else each is a symmetry plane, along which the body slides
  bool any() const { return lower || upper; }
};

template <int Dim>
class Images {
 public:
  struct Image {
    std::uint32_t node = 0, of = 0;
    std::array<double, Dim> sign{};  ///< of vectors
  };

  Images() = default;
  Images(const GridGeometry<Dim>& grid, const std::array<AxisEnds, Dim>& ends);

  bool empty() const { return images_.empty() && fixed_.empty(); }
  const std::vector<Image>& list() const { return images_; }

  /// Share of its cells that a node has in the body, were it in the middle of one: 1/2 on a symmetry plane.
  double share(std::size_t node) const { return share_.empty() ? 1 : share_[node]; }

  /// The cell, by its lowest node, that a cell beyond a periodic end is the same as; no body reaches beyond planes.
  std::size_t cell(std::size_t lowest) const { return cell_of_.empty() ? lowest : cell_of_[lowest]; }

  /// Adds what images have to their nodes and leaves zero there; nothing is left across symmetry planes. Components
  /// before `first` are scalars, Dim from there on those of a vector; so are the next Dim, if there are any.
  template <int K>
  void fold(GridField<K>& field, int first = 0) const;

  /// Gives images what their nodes have.
  template <int K>
  void unfold(GridField<K>& field, int first = 0) const;

 private:
  struct Fixed {
    std::uint32_t node = 0;
    std::uint8_t direction = 0;
  };
  template <int K>
  void clear_fixed(GridField<K>& field, int first) const {
    for (const Fixed& fixed : fixed_) {
      for (int c = first + fixed.direction; c < K; c += Dim) field.node(fixed.node)[c] = 0;
    }
  }

  std::vector<Image> images_;
  std::vector<Fixed> fixed_;            ///< components of vectors that are zero: across symmetry planes
  std::vector<double> share_;           ///< of each node
  std::vector<std::uint32_t> cell_of_;  ///< of each node; empty without periodic ends
};

template <int Dim>
template <int K>
void Images<Dim>::fold(GridField<K>& field, int first) const {
  for (const Image& image : images_) {
    double *from = field.node(image.node), *to = field.node(image.of);
    for (int c = 0; c < K; ++c) {
      to[c] += (c < first ? 1 : image.sign[static_cast<std::size_t>((c - first) % Dim)]) * from[c];
      from[c] = 0;
    }
  }
  clear_fixed(field, first);
}

template <int Dim>
template <int K>
void Images<Dim>::unfold(GridField<K>& field, int first) const {
  clear_fixed(field, first);
  for (const Image& image : images_) {
    const double* from = field.node(image.of);
    double* to = field.node(image.node);
    for (int c = 0; c < K; ++c) {
      to[c] = (c < first ? 1 : image.sign[static_cast<std::size_t>((c - first) % Dim)]) * from[c];
    }
  }
}

}  // namespace assay::mpm
