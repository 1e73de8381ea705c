// SPDX-License-Identifier: BSD-3-Clause
// The material's border: columns of particles to batches of the ABI and back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mpm/pass.hpp"

namespace assay::mpm {

/// One instance of the material a thread where the model needs it, scratch a thread, history by block.
template <int Dim>
class MaterialBatches {
 public:
  MaterialBatches(State<Dim>& state, bool reads_increment);

  struct Outcome {
    std::optional<std::size_t> inverted;  ///< first particle with det F <= 0 (or no number)
    std::optional<std::size_t> refused;   ///< first particle that the material refused
    std::string message;
    std::optional<FailedStep> step;  ///< with which it was refused
  };

  /// F <- (I + dt L) F and the stress of the particles of one block. Safe for different blocks at once.
  Outcome update(std::size_t begin, std::size_t end, const Instant& now);

 private:
  struct Scratch {
    std::vector<double> F0, F1, cauchy;
    std::size_t points = 0;
    void resize(std::size_t n);
  };
  std::vector<double> directions(std::size_t begin, std::size_t n) const;
  std::optional<std::size_t> advance_deformation(std::size_t begin, std::size_t n, double dt, Scratch& scratch);

  State<Dim>* state_;
  bool reads_increment_;
  std::vector<Material> instances_;  ///< one, or one a thread
  std::vector<Scratch> scratch_;     ///< one a thread
  std::size_t state_size_ = 0;
};

/// Bytes of history a particle: begin and end of the step.
inline std::size_t history_bytes(std::size_t state_size) { return 2 * state_size * sizeof(double); }

}  // namespace assay::mpm
