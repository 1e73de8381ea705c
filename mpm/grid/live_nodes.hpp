// SPDX-License-Identifier: BSD-3-Clause
// The tiles of the grid that particles reach. Only these are cleared and worked on in a step, and the memory of tiles
// that no particle ever reached is never touched.
#pragma once

#include <span>
#include <vector>

#include "mpm/grid/grid_geometry.hpp"
#include "mpm/grid/images.hpp"

namespace assay::mpm {

/// Nodes of a tile: neighbours along the first direction.
inline constexpr std::int32_t nodes_of_tile = 8;

template <int Dim>
class LiveNodes {
 public:
  LiveNodes() = default;
  explicit LiveNodes(const GridGeometry<Dim>& grid);

  /// The tile of this node is live in every step.
  void keep(std::size_t node);

  /// Only the tiles kept are live, then those marked, too, as soon as they are merged.
  void forget();
  void mark(const NodeBox<Dim>& box);
  void mark(std::size_t node);
  void merge();

  bool holds(std::size_t node) const { return marks_[tile_of(node)] != 0; }
  /// In the order of the grid; they do not touch one another.
  std::span<const NodeRange> runs() const { return runs_; }
  std::size_t count() const;

  /// body(i) for each of the nodes.
  void each(const auto& body) const {
    for (const NodeRange& run : runs_) {
      for (std::size_t i = run.first; i < run.end; ++i) body(i);
    }
  }

 private:
  std::size_t tile_of(std::size_t node) const;
  NodeBox<Dim> box_of(std::size_t node) const;

  std::array<std::int32_t, Dim> count_{};
  std::size_t tiles_across_ = 0;      ///< of a line
  std::vector<unsigned char> marks_;  ///< a tile
  std::vector<std::size_t> kept_;     ///< a node of each tile kept
  NodeBox<Dim> hull_;                 ///< of all tiles marked
  std::vector<NodeRange> runs_;
};

/// Marks the nodes of which those marked are images, and all images of these.
template <int Dim>
void mark_images(LiveNodes<Dim>& live, const Images<Dim>& images);

}  // namespace assay::mpm
