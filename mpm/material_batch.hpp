// SPDX-License-Identifier: BSD-3-Clause
// The particles' side of the stress pass: instances of the material, its state at rest, blocks on several threads.
#pragma once

#include <vector>

#include "mpm/pass.hpp"
#include "mpm/stress_blocks.hpp"

namespace assay::mpm {

/// One instance of the material a thread where the model needs it, scratch a thread, history by block.
template <int Dim>
class MaterialBatches {
 public:
  explicit MaterialBatches(State<Dim>& state);

  /// F <- (I + dt L) F and the stress of the particles of one block. Safe for different blocks at once.
  BlockOutcome update(std::size_t begin, std::size_t end, const Instant& now);

  /// The same of all particles, by the setup's offload where it has one: what went wrong first, if anything did.
  BlockOutcome update_all(const Instant& now);

 private:
  std::vector<double> directions(std::size_t begin, std::size_t n) const;

  State<Dim>* state_;
  StressColumns<Dim> columns_;
  std::vector<Material> instances_;         ///< one, or one a thread
  std::vector<BlockScratch<Dim>> scratch_;  ///< one a thread
};

/// Bytes of history a particle: begin and end of the step.
inline std::size_t history_bytes(std::size_t state_size) { return 2 * state_size * sizeof(double); }

}  // namespace assay::mpm
