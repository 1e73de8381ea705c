// SPDX-License-Identifier: BSD-3-Clause
// The material's border: columns of particles, wherever they lie, to batches of the ABI and back.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"
#include "mpm/data/blocks.hpp"
#include "mpm/data/columns.hpp"

namespace assay::mpm {

/// State of the material by block, [c * n + p]: at the begin and the end of the step.
struct MaterialHistory {
  ColumnData begin, end;
};

/// Row of the ABI's nine components for component c of the stress column.
template <int Dim>
constexpr std::size_t stress_row(int c) {
  constexpr std::size_t in_space[] = {0, 4, 8, 1, 2, 5};
  if constexpr (Dim == 3) return in_space[c];
  return c < Dim * Dim ? static_cast<std::size_t>(3 * (c / Dim) + c % Dim) : 8;  // 33 comes last in plane strain
}

/// What the stress pass reads and writes: component c of particle p at [c][p]; history by block, [c * n + p] of n
/// points.
template <int Dim>
struct StressColumns {
  std::array<double*, tensor_components<Dim>> deformation_gradient{}, velocity_gradient{};
  std::array<double*, stress_components<Dim>> stress{};
  std::array<double*, 2> history{};       ///< begin and end of the step; null of a material without state
  double* volume_scale = nullptr;         ///< of F at the end of the step; null: 1
  double* volume_scale_before = nullptr;  ///< at its begin, where the material alone sees F scaled; null: F keeps it
  bool rate_of_F = false;                 ///< what velocity_gradient holds: dF/dt in place of L
};

/// Batches of one thread: F0, F1 and Cauchy stress of a block, nine components each.
template <int Dim>
class BlockScratch {
 public:
  static constexpr std::size_t doubles = 27 * block_size;
  /// In memory of its own, or in that of `doubles` somewhere else.
  explicit BlockScratch(double* memory = nullptr);
  BlockScratch(BlockScratch&&) noexcept = default;
  BlockScratch(const BlockScratch&) = delete;

  /// For blocks of n points, the components of plane strain that never change filled in.
  void resize(std::size_t n);

  double* F0() { return memory_; }
  double* F1() { return memory_ + 9 * block_size; }
  double* cauchy() { return memory_ + 18 * block_size; }

 private:
  std::vector<double> own_;
  double* memory_;
  std::size_t points_ = 0;
};

/// What became of a block of particles.
struct BlockOutcome {
  std::optional<std::size_t> inverted;  ///< first particle with det F <= 0 (or no number)
  std::optional<std::size_t> refused;   ///< first particle that the material refused
  std::string message;
  std::optional<FailedStep> step;  ///< with which it was refused
};

/// F <- (I + dt L) F, or F + dt dF/dt, and the stress of particles [begin, end) of one block.
template <int Dim>
BlockOutcome update_block(const StressColumns<Dim>& columns, const Material& material, std::size_t begin,
                          std::size_t end, const Instant& now, BlockScratch<Dim>& scratch);

template <int Dim>
struct Offload {
  /// Memory of n doubles, zero, that the others see; it lives as long as this.
  std::function<double*(std::size_t n)> allocate;
  /// Where the columns lie: once, before the first step.
  std::function<void(const StressColumns<Dim>& columns)> place;
  /// All blocks of particles [begin, end), which one thread would do. Safe for different threads at once.
  std::function<BlockOutcome(std::size_t thread, std::size_t begin, std::size_t end, const Instant& now)> update;
};

}  // namespace assay::mpm
