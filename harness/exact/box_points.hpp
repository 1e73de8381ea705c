// SPDX-License-Identifier: BSD-3-Clause
// Single points of the axis-aligned motion: stress, and b = a - DIV(P)/rho0, as functions of place and time alone. The
// gradient of P is taken by differences of fourth order between neighbouring cos(pi X_i): some 10 digits, fewer where a
// front runs between them.
#pragma once

#include <mutex>

#include "harness/exact/places.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"

namespace assay {

/// What a point's stress and its gradient need: P in its own cosines, and in those of its neighbours.
class BoxStencil {
 public:
  BoxStencil(const AxisAligned& motion, const Vector3& X);

  std::size_t size() const { return cosines_.size(); }
  const Vector3& cosines(std::size_t k) const { return cosines_[k]; }

  /// P: of each member of the stencil [Pa]; state: of the point at the time.
  ExactStress stress(std::span<const Tensor> P, const ExactState& state, double density) const;

 private:
  std::vector<Vector3> cosines_;  ///< of the point, then four along each axis that moves
  std::vector<int> axes_;
  Vector3 slope_;  ///< d cos(pi X_d) / d X_d [1/m]
};

struct BoxModel {
  AxisAligned motion;
  double density = 0;  ///< rho0 [kg/m^3]
  std::shared_ptr<const Material> material;
  BoxOptions options;
  std::shared_ptr<std::mutex> one_at_a_time = std::make_shared<std::mutex>();  ///< calls of a material that asks for it

  std::unique_lock<std::mutex> lock() const {
    return material->has(ASSAY_THREAD_SAFE) ? std::unique_lock<std::mutex>() : std::unique_lock(*one_at_a_time);
  }
};

/// The slice of a box, and its places: of a stress that is a function of F one update a member of a stencil, of many
/// points at once; else a history each, which goes on in time. Going back begins them anew.
std::unique_ptr<const ExactSlice> slice_of_box(const BoxModel& model, double t);
std::unique_ptr<const ExactPlaces> places_of_box(const BoxModel& model, std::vector<Vector3> X);

}  // namespace assay
