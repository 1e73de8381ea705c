// SPDX-License-Identifier: BSD-3-Clause
// The particles' side of the stress pass: instances of the material, its state at rest, blocks on several threads.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "mpm/material/stress_blocks.hpp"
#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// Of the outcomes of blocks that of the smallest particle that went wrong. Safe for several threads.
class FirstOutcome {
 public:
  void note(BlockOutcome outcome) {
    const std::size_t at = place(outcome);
    if (at == none_bad) return;
    const std::lock_guard lock(guard_);
    if (at < place(first_)) first_ = std::move(outcome);
  }
  BlockOutcome take() { return std::exchange(first_, {}); }

  /// The particle that went wrong, or none_bad.
  static std::size_t place(const BlockOutcome& outcome) {
    return std::min(outcome.inverted.value_or(none_bad), outcome.refused.value_or(none_bad));
  }

 private:
  std::mutex guard_;
  BlockOutcome first_;
};

/// One instance of the material a thread where the model needs it, scratch a thread, history by block.
template <int Dim>
class MaterialBatches {
 public:
  explicit MaterialBatches(State<Dim>& state);

  /// F <- (I + dt L) F and the stress of the particles of one block. Safe for different blocks at once. The first
  /// particle with which something went wrong, or none_bad.
  std::size_t update(std::size_t begin, std::size_t end, const Instant& now);

  /// Of all blocks since the last time: what went wrong first, if anything did.
  BlockOutcome take_first() { return first_.take(); }

  /// All particles, by the setup's offload: what went wrong first, if anything did.
  BlockOutcome update_elsewhere(const Instant& now);

 private:
  std::vector<double> directions(std::size_t begin, std::size_t n) const;

  State<Dim>* state_;
  StressColumns<Dim> columns_;
  std::vector<Material> instances_;         ///< one, or one a thread
  std::vector<BlockScratch<Dim>> scratch_;  ///< one a thread
  FirstOutcome first_;
};

/// F <- (I + dt L) F, then the material's update in batches; finds det F <= 0 and failed points.
template <int Dim>
Pass<Dim> stress_pass(bool with_history);

}  // namespace assay::mpm
