// SPDX-License-Identifier: BSD-3-Clause
// The exact fields at the particles of a frame, time after time.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/exact/places.hpp"

namespace assay::drivers {

/// Points that are asked for again and again are kept.
class ExactParticles {
 public:
  /// As the scene's frame sees it. dimension: of the scene.
  ExactParticles(ExactSolutionPtr solution, int dimension) : solution_(std::move(solution)), dimension_(dimension) {}

  /// x, v, F, and sigma where `stress`, at time t [s]; lives until the next call.
  const std::vector<PointFields>& at(const std::vector<Vector3>& X, double t, bool stress);
  /// Velocities at another time [m/s]; likewise, apart from the others.
  const std::vector<PointFields>& velocities(const std::vector<Vector3>& X, double t);
  /// The fields of a stretch of the points, of which the first one has this number; and their velocities.
  using TakeStretch = std::function<void(std::size_t first, std::span<const PointFields> fields,
                                         std::span<const PointFields> velocities)>;
  /// The same of a million points without the room for all of them: some thousand after the other.
  void in_stretches(const std::vector<Vector3>& X, double t, double t_velocity, bool stress, const TakeStretch& take);
  /// Whether the exact motion moves each point; lives until the next call.
  const std::vector<char>& moving(const std::vector<Vector3>& X);
  /// The reference point at x; NaN where there is none.
  Vector3 reference_of(const Vector3& x, double t) const;
  const ExactSolution& solution() const { return *solution_; }
  int dimension() const { return dimension_; }

 private:
  const ExactPlaces& places(const std::vector<Vector3>& X);
  void set_plane_stress(double t);
  void take_plane_stress(std::size_t first, std::span<PointFields> fields) const;

  ExactSolutionPtr solution_;
  int dimension_;
  std::vector<Vector3> X_;
  std::vector<char> moving_;
  std::unique_ptr<const ExactPlaces> places_;
  std::unique_ptr<ExactInstant> stress_;  ///< in the plane
  std::vector<PointFields> now_, of_velocity_;
};

}  // namespace assay::drivers
