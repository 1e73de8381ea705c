// SPDX-License-Identifier: BSD-3-Clause
// The exact fields at fixed points of space, at one time after another: what ExactInstant is in the plane. Any solution
// has them, by its places and slices. Some points at a time are asked for, so that no field of all points is kept.
//
//   SpaceInstant --set_time(t)--> --window(begin, end)--> Window --state(p), inertia(p), ...--> of points begin .. end
//   - 1
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/exact/places.hpp"

namespace assay {

/// What is const may be asked by many threads.
class SpaceInstant {
 public:
  using Points = std::array<std::span<const double>, 3>;  ///< X, Y, Z [m]

  /// points: live as long as this. Without stress and force the motion alone is asked for.
  SpaceInstant(ExactSolutionPtr solution, const Points& points, const Asked& asked)
      : solution_(std::move(solution)), points_(points), asked_(asked) {}

  /// To any time until the end of the solution. Throws MaterialFailure.
  void set_time(double t) { now_ = solution_->slice(t); }

  /// The fields of some points, by their own numbers.
  class Window {
   public:
    SpaceState state(std::size_t point) const;                                       ///< of motion, or of stress
    std::array<double, 3> velocity(std::size_t point) const { return at(point).v; }  ///< of motion [m/s]
    std::array<double, 9> first_piola_kirchhoff(std::size_t point) const { return at(point).P; }  ///< of stress [Pa]
    SpaceInertia inertia(std::size_t point) const;                                                ///< of inertia
    std::array<double, 3> acceleration(std::size_t point) const { return at(point).a; }  ///< of inertia [m/s^2]
    std::array<double, 3> displacement(std::size_t point) const;  ///< in the body's own frame [m]
    bool moves(std::size_t point) const { return places_->moves(*now_, point - begin_); }
    double measure(std::size_t point, const std::array<double, 9>& F) const;  ///< ExactSlice::measure

   private:
    friend class SpaceInstant;
    const PointFields& at(std::size_t point) const { return fields_[point - begin_]; }
    const Vector3& X(std::size_t point) const { return places_->X(point - begin_); }

    const ExactSlice* now_ = nullptr;
    std::shared_ptr<const ExactPlaces> places_;
    std::size_t begin_ = 0;
    std::vector<PointFields> fields_;
  };
  Window window(std::size_t begin, std::size_t end) const;
  /// Of the same points, and of an instant of the same solution at another time.
  Window window(const Window& same) const;

  /// b of points begin .. end - 1: component d of point p at b[d][p] [m/s^2].
  void body_force(std::size_t begin, std::size_t end, const std::array<double*, 3>& b) const;

  const ExactSlice& slice() const { return *now_; }

 private:
  std::vector<Vector3> some(std::size_t begin, std::size_t end) const;
  Window window_of(std::size_t begin, std::shared_ptr<const ExactPlaces> places) const;

  ExactSolutionPtr solution_;
  Points points_;
  Asked asked_;
  std::unique_ptr<const ExactSlice> now_;
};

template <int Dim>
using InstantOf = std::conditional_t<Dim == 2, ExactInstant, SpaceInstant>;

}  // namespace assay
