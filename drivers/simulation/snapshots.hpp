// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of a run: VTU files for ParaView, frames for the pictures.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/output_folder.hpp"
#include "drivers/output/vtu.hpp"
#include "drivers/picture/particle_picture.hpp"
#include "drivers/simulation/error_sampler.hpp"

namespace assay::drivers {

class Snapshots {
 public:
  /// Nothing is written for a part that the scene does not ask for.
  Snapshots(const Problem& problem, OutputFolder& folder) : problem_(&problem), folder_(&folder) {}

  /// One more snapshot at time t. `sampler`: null where there is no exact solution to compare with, else just sampled.
  void add(const mpm::State<2>& state, const ErrorSampler* sampler, double t);

  /// particles.pvd, and the pictures of the frames kept: name and caption of each written PNG.
  struct Written {
    std::string name, caption, png;
  };
  std::vector<Written> finish();

 private:
  void write_vtu(const mpm::State<2>& state, const ErrorSampler* sampler, double t);
  ParticleFrame frame_of(const mpm::State<2>& state, double t) const;

  const Problem* problem_;
  OutputFolder* folder_;
  std::vector<PvdEntry> entries_;
  struct Frame {
    double t = 0;
    ParticleFrame shape;
    std::vector<double> error, measure;
  };
  std::vector<Frame> frames_;  ///< nearest to T/2, and the last
};

}  // namespace assay::drivers
