// SPDX-License-Identifier: BSD-3-Clause
// A setup brought to life: columns allocated, passes bound, one step at a time.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mpm/compose.hpp"
#include "mpm/step/stages.hpp"

namespace assay::mpm {

/// Seconds spent in one pass so far.
struct PassTime {
  std::string name;
  double seconds = 0;
  std::size_t bytes_per_particle = 0;  ///< of the columns that it reads and writes
  bool updates_material = false;       ///< of all particles
};

template <int Dim>
class Simulation {
 public:
  explicit Simulation(Setup<Dim> setup);
  /// The same with a list of passes of one's own: those of compose(setup), more or others.
  Simulation(Setup<Dim> setup, const std::vector<Pass<Dim>>& passes);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// One step from t to t + dt. A finding ends the run, in the middle of a step.
  const std::optional<Finding>& step(double t, double dt);

  /// To which the particles' velocities belong after the last step [s].
  double velocity_time() const { return velocity_time_; }

  State<Dim>& state() { return state_; }
  const State<Dim>& state() const { return state_; }
  const std::vector<PassTime>& times() const { return times_; }

 private:
  void allocate(const std::vector<Pass<Dim>>& passes);
  void fill();
  void plan(const std::vector<Pass<Dim>>& passes);

  State<Dim> state_;
  std::vector<Kernel> kernels_;
  struct Stage {
    SymplecticStage part;
    std::vector<const Kernel*> kernels;
    std::vector<std::size_t> passes;
    std::vector<double> seconds;
  };
  std::array<std::vector<Stage>, 2> steps_;  ///< the first step, and those after it
  double last_dt_ = 0;                       ///< of the step before; 0 of the first [s]
  bool begun_ = false;
  double velocity_time_ = 0;
  std::vector<PassTime> times_;
};

}  // namespace assay::mpm
