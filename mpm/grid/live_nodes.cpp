// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/grid/live_nodes.hpp"

namespace assay::mpm {

template <int Dim>
LiveNodes<Dim>::LiveNodes(const GridGeometry<Dim>& grid)
    : count_(grid.count), tiles_across_(static_cast<std::size_t>((grid.count[0] + nodes_of_tile - 1) / nodes_of_tile)) {
  const std::size_t lines = grid.nodes() / static_cast<std::size_t>(grid.count[0]);
  marks_.assign(lines * tiles_across_, 0);
  runs_.reserve(lines * (tiles_across_ + 1) / 2);
}

template <int Dim>
std::size_t LiveNodes<Dim>::tile_of(std::size_t node) const {
  const auto across = static_cast<std::size_t>(count_[0]);
  return node / across * tiles_across_ + node % across / nodes_of_tile;
}

template <int Dim>
NodeBox<Dim> LiveNodes<Dim>::box_of(std::size_t node) const {
  NodeBox<Dim> box;
  for (std::size_t d = 0; d < Dim; ++d) {
    box.first[d] = static_cast<std::int32_t>(node % static_cast<std::size_t>(count_[d]));
    box.end[d] = box.first[d] + 1;
    node /= static_cast<std::size_t>(count_[d]);
  }
  return box;
}

template <int Dim>
void LiveNodes<Dim>::keep(std::size_t node) {
  if (holds(node)) return;
  kept_.push_back(node);
  mark(box_of(node));
}

template <int Dim>
void LiveNodes<Dim>::mark(const NodeBox<Dim>& box) {
  const auto first = static_cast<std::size_t>(box.first[0] / nodes_of_tile);
  const auto end = static_cast<std::size_t>((box.end[0] + nodes_of_tile - 1) / nodes_of_tile);
  for_lines<Dim>(box, count_, [&](std::size_t line) {
    unsigned char* marks = marks_.data() + line * tiles_across_;
    std::fill(marks + first, marks + end, static_cast<unsigned char>(1));
  });
  hull_.include(box);
}

template <int Dim>
void LiveNodes<Dim>::mark(std::size_t node) {
  if (!holds(node)) mark(box_of(node));
}

template <int Dim>
void LiveNodes<Dim>::forget() {
  for (const NodeRange& run : runs_) {
    for (std::size_t t = tile_of(run.first); t <= tile_of(run.end - 1); ++t) marks_[t] = 0;
  }
  runs_.clear();
  hull_ = {};
  for (const std::size_t node : kept_) mark(box_of(node));
}

template <int Dim>
void LiveNodes<Dim>::merge() {
  runs_.clear();
  const auto across = static_cast<std::size_t>(count_[0]);
  const auto first = static_cast<std::size_t>(hull_.first[0] / nodes_of_tile);
  const auto end = static_cast<std::size_t>((hull_.end[0] + nodes_of_tile - 1) / nodes_of_tile);
  for_lines<Dim>(hull_, count_, [&](std::size_t line) {
    for (std::size_t t = first; t < end; ++t) {
      if (marks_[line * tiles_across_ + t] == 0) continue;
      const std::size_t begin = line * across + t * nodes_of_tile;
      const std::size_t stop = std::min(begin + nodes_of_tile, (line + 1) * across);
      if (!runs_.empty() && runs_.back().end == begin) {
        runs_.back().end = stop;
      } else {
        runs_.push_back({begin, stop});
      }
    }
  });
}

template <int Dim>
std::size_t LiveNodes<Dim>::count() const {
  std::size_t nodes = 0;
  for (const NodeRange& run : runs_) nodes += run.end - run.first;
  return nodes;
}

template <int Dim>
void mark_images(LiveNodes<Dim>& live, const Images<Dim>& images) {
  for (const auto& image : images.list()) {
    if (live.holds(image.node)) live.mark(image.of);
  }
  for (const auto& image : images.list()) {
    if (live.holds(image.of)) live.mark(image.node);
  }
}

template class LiveNodes<ASSAY_DIMENSION>;
template void mark_images(LiveNodes<ASSAY_DIMENSION>&, const Images<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
