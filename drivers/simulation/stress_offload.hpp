// SPDX-License-Identifier: BSD-3-Clause
// The stress pass of a run in workers, one a thread: columns in memory that all share, one hand-over a worker a step.
#pragma once

#include <memory>
#include <string>

#include "adapters/process/private_files.hpp"
#include "adapters/worker/worker.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/material/stress_blocks.hpp"

namespace assay::drivers {

template <int Dim>
class StressOffload {
 public:
  /// For a material whose table is remote. Throws SystemError where workers or memory cannot be had.
  explicit StressOffload(const mpm::Setup<Dim>& setup);
  ~StressOffload();
  StressOffload(const StressOffload&) = delete;
  StressOffload& operator=(const StressOffload&) = delete;

  /// As the particle method takes it; keeps this alive.
  static std::shared_ptr<const mpm::Offload<Dim>> offload_of(const std::shared_ptr<StressOffload>& workers);

  /// Between handing over and coming back, beside the time that the slowest worker was busy [s].
  double hand_over_s() const;

 private:
  struct Worker;
  double* allocate(std::size_t n);
  void place(const mpm::StressColumns<Dim>& columns);
  mpm::BlockOutcome update(std::size_t thread, std::size_t begin, std::size_t end, const mpm::Instant& now);
  mpm::BlockOutcome death_of(Worker& worker, std::size_t begin, std::size_t end, const mpm::Instant& now);

  std::shared_ptr<const Material> material_;
  std::size_t state_size_;
  adapters::SharedMemory columns_;
  std::size_t used_ = 0;
  mpm::StressColumns<Dim> placed_;
  std::vector<std::unique_ptr<Worker>> workers_;
};

/// Tasks of workers that begin with these words serve one thread of a run, in the plane and in space.
inline constexpr const char *stress_task = "stress", *space_stress_task = "stress_in_space";

/// What such a worker does.
template <int Dim>
void serve_stress(adapters::WorkerFloor& floor, const std::string& task);

}  // namespace assay::drivers
