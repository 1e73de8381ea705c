// SPDX-License-Identifier: BSD-3-Clause
// Going over the particles block by block, on one thread or several.
//
//   passes of a step    weights   to_grid | grid_update | to_particles   gradient   stress
//                       '---- group ----'    whole        '--------- group ---------'
//   in a group          block 1: weights, to_grid; block 2: weights, to_grid; ...    what one leaves is still in cache
//   its threads         tile 1 = blocks 1 .. n --> the grid
//                       tile 2 = the next ones --> a copy --> added to the grid after tile 1
//                       tile 3                 --> a copy --> after tile 2 ...
//
// What adds to the grid does it tile by tile: the first tile to the grid itself, the others to a copy each thread has,
// which is added to the grid in the order of the tiles. So nothing depends on the number of threads.
#pragma once

#include <algorithm>
#include <span>

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// Tiles of so many particles: pieces of neighbours in their first order, few enough that adding them up costs little.
inline std::size_t tiles_of(std::size_t particles) {
  constexpr std::size_t blocks_of_tile = 16, most_tiles = 8;
  return std::clamp<std::size_t>(blocks_of(particles) / blocks_of_tile, 1, most_tiles);
}

/// Copies of inertia and force that so many threads need.
inline std::size_t tile_copies(std::size_t particles, int threads) {
  const std::size_t tiles = tiles_of(particles);
  return tiles == 1 ? 0 : std::min<std::size_t>(tiles, static_cast<std::size_t>(threads));
}

/// A tile's blocks, one after the other; each adds where `block` says.
using TileBody = std::function<void(std::size_t first_block, std::size_t end_block, double* inertia, double* force)>;

/// body for all tiles. inertia, force: where the sums go, or null; both are added to.
template <int Dim>
void for_tiles(State<Dim>& s, double* inertia, double* force, const TileBody& body);

/// The kernels in their order, those with blocks side by side together. `seconds`, of each kernel, are added to. Ends
/// where the state has a finding.
template <int Dim>
void run(State<Dim>& s, std::span<const Kernel* const> kernels, const Instant& now, std::span<double> seconds);

/// One kernel alone.
template <int Dim>
void run(State<Dim>& s, const Kernel& kernel, const Instant& now);

}  // namespace assay::mpm
