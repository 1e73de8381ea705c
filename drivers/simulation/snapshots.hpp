// SPDX-License-Identifier: BSD-3-Clause
// Snapshots of a run: VTU files for ParaView, frames for the pictures.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/output_folder.hpp"
#include "drivers/picture/value_pictures.hpp"
#include "drivers/simulation/error_sampler.hpp"
#include "drivers/simulation/kept_numbers.hpp"
#include "drivers/simulation/snapshot_vtu.hpp"
#include "drivers/simulation/space_drawing.hpp"

namespace assay::drivers {

template <int Dim>
class Snapshots {
 public:
  /// Nothing is written for a part that the scene does not ask for.
  Snapshots(const ProblemIn<Dim>& problem, OutputFolder& folder);

  /// One more snapshot at time t. `sampler`: null where there is no exact solution to compare with, else just sampled.
  /// velocity_t: of the particles' velocities [s].
  void add(const mpm::State<Dim>& state, const ErrorSampler<Dim>* sampler, double t, double velocity_t);

  /// Keeps the picture of a moment that is sampled, in place of the one before: it is shown where the run ends there.
  void remember(const mpm::State<Dim>& state, const ErrorSampler<Dim>& sampler, double t);

  /// Keeps what a snapshot shows of a state that is well, in place of the one before.
  void keep_good(const mpm::State<Dim>& state, double t);
  /// Writes it, with what `add` writes of it; `exact` may be null. Returns the name of the file.
  std::string leave_last_good(const ExactSolutionPtr& exact) const;

  /// particles.pvd, and the pictures of the frames kept: name and caption of each written PNG.
  struct Written {
    std::string name, caption, png;
  };
  std::vector<Written> finish();

 private:
  void write_vtu(const mpm::State<Dim>& state, const ErrorSampler<Dim>* sampler, double t, double velocity_t);
  /// is_state: whether the columns are all those of the state, else those that are shown.
  void write_particles(const std::string& name, const ColumnView& of, std::size_t particles,
                       const std::vector<VtuArray>& more, double t, const std::optional<double>& velocity_t,
                       bool is_state) const;

  /// kept(column, where its numbers begin among those of a state that is kept) for each that changes.
  std::size_t each_that_changes(std::size_t particles, const auto& kept) const;

  const ProblemIn<Dim>* problem_;
  OutputFolder* folder_;
  std::vector<ShownColumn> shown_;  ///< first the positions, in the reference configuration and now
  std::vector<PvdEntry> entries_;
  double good_t_ = 0;
  std::size_t good_particles_ = 0;
  KeptNumbers good_{Dim == 3};  ///< columns that a snapshot shows and that change, one after the other
  /// A body in one of the ways in which pictures show it: in the plane one, in space a cut and a view.
  struct Drawn {
    ParticleFrame shape;
    std::vector<double> error, measure;
  };
  struct Frame {
    double t = 0;
    std::vector<Drawn> drawn;
    double largest_error = 0, farthest_measure = 0;  ///< of all particles; the latter from its value at rest
  };
  Frame frame_of(const mpm::State<Dim>& state, const ErrorSampler<Dim>& sampler, double t) const;
  void show(Frame frame);
  /// The pictures of one way, with names that begin so.
  void draw(std::size_t way, const std::string& prefix, ParticlePicture picture, const std::string& seen,
            std::vector<Written>& written);
  std::vector<Frame> frames_;          ///< nearest to T/2, and the last
  Frame latest_;                       ///< of `remember`; nothing drawn: none
  std::optional<SpaceDrawing> space_;  ///< of bodies in space that are shown
};

}  // namespace assay::drivers
