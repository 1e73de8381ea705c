// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of a run: VTU files for ParaView, frames for the pictures.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/output_folder.hpp"
#include "drivers/output/vtu.hpp"
#include "drivers/picture/value_pictures.hpp"
#include "drivers/simulation/error_sampler.hpp"

namespace assay::drivers {

/// A column that snapshots show. It holds a number, a vector or a tensor of each particle.
struct ShownColumn {
  mpm::Column column;
  int components;
  int width() const { return components == 1 ? 1 : components == 2 ? 3 : 9; }  ///< in three dimensions
};

class Snapshots {
 public:
  /// Nothing is written for a part that the scene does not ask for.
  Snapshots(const Problem& problem, OutputFolder& folder);

  /// One more snapshot at time t. `sampler`: null where there is no exact solution to compare with, else just sampled.
  /// velocity_t: of the particles' velocities [s].
  void add(const mpm::State<2>& state, const ErrorSampler* sampler, double t, double velocity_t);

  /// Keeps the picture of a moment that is sampled, in place of the one before: it is shown where the run ends there.
  void remember(const mpm::State<2>& state, const ErrorSampler& sampler, double t);

  /// Keeps what a snapshot shows of a state that is well, in place of the one before.
  void keep_good(const mpm::State<2>& state, double t);
  /// Writes it, with what `add` writes of it; `exact` may be null. Returns the name of the file.
  std::string leave_last_good(const ExactSolutionPtr& exact) const;

  /// particles.pvd, and the pictures of the frames kept: name and caption of each written PNG.
  struct Written {
    std::string name, caption, png;
  };
  std::vector<Written> finish();

 private:
  void write_vtu(const mpm::State<2>& state, const ErrorSampler* sampler, double t, double velocity_t);
  ParticleFrame frame_of(const mpm::State<2>& state, double t) const;

  const Problem* problem_;
  OutputFolder* folder_;
  std::vector<ShownColumn> shown_;  ///< first the positions, in the reference configuration and now
  std::vector<PvdEntry> entries_;
  double good_t_ = 0;
  std::size_t good_particles_ = 0;
  std::vector<double> good_;  ///< of the columns that a snapshot shows, one after the other
  struct Frame {
    double t = 0;
    ParticleFrame shape;
    std::vector<double> error, measure;
  };
  void show(Frame frame);
  std::vector<Frame> frames_;  ///< nearest to T/2, and the last
  Frame latest_;               ///< of `remember`; no shape: none
};

}  // namespace assay::drivers
