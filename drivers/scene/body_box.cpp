// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/body_box.hpp"

#include <cmath>

#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

namespace {

/// Of the body turned by the frame: a ring stays itself, and what spins sweeps the circle of its farthest corner, or
/// the ball.
template <int Dim>
BoxOf<Dim> turned_box(const Scene& scene, const Frame& frame) {
  const BoxOf<Dim> own = body_box<Dim>(scene);
  if (scene.body.domain == Body::Domain::ring || (frame.angle == 0 && frame.spin == 0)) return own;
  BoxOf<Dim> box;
  double farthest = 0;
  for (const Vector3& corner : own.corners()) {
    farthest = std::max(farthest, Dim == 2 ? std::hypot(corner.x(), corner.y()) : corner.norm());
    box.hold(frame.rotation(0) * corner);  // the origin, around which the ring is, is inside
  }
  if (frame.spin != 0) box.lower.fill(-farthest), box.upper.fill(farthest);
  return box;
}

constexpr int looks = 400;  ///< over the time of a run

/// Of a box whose faces stay straight: of the corners, at many times.
template <int Dim>
BoxOf<Dim> corner_swept_box(const Scene& scene) {
  BoxOf<Dim> box = body_box<Dim>(scene);
  const auto corners = box.corners();
  for (int k = 0; k <= looks; ++k) {
    for (const Vector3& corner : corners) box.hold(scene.motion->at(corner, scene.time.end * k / looks).x);
  }
  return box;
}

/// Of a body that is left to itself: its circle where it spins, and its flight. How far it vibrates is not known.
Box flight_box(const Scene& scene, const InitialVelocity& v) {
  Box box = body_box(scene);
  if (v.spin != 0) {
    const std::array<double, 2> middle{0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])};
    const double radius = 0.5 * std::hypot(box.upper[0] - box.lower[0], box.upper[1] - box.lower[1]);
    for (std::size_t d = 0; d < 2; ++d) box.lower[d] = middle[d] - radius, box.upper[d] = middle[d] + radius;
  }
  box.move(v.at(0.5 * (box.lower[0] + box.upper[0]), 0.5 * (box.lower[1] + box.upper[1])), scene.time.end);
  return box;
}

/// Of the vortex in the plane, and in space of what the motion sweeps.
template <int Dim>
BoxOf<Dim> box_around_turns(const Scene& scene) {
  if (!scene.frame) return body_box<Dim>(scene);
  BoxOf<Dim> box = turned_box<Dim>(scene, *scene.frame);
  std::array<double, Dim> velocity;
  for (std::size_t d = 0; d < Dim; ++d) velocity[d] = scene.frame->velocity(static_cast<int>(d));
  box.move(velocity, scene.time.end);
  return box;
}

}  // namespace

template <int Dim>
BoxOf<Dim> body_box(const Scene& scene) {
  if constexpr (Dim == 3) {
    if (scene.body.domain != Body::Domain::vortex) return {scene.body.lower, scene.body.upper};
    BoxOf<3> box;
    box.lower.fill(HUGE_VAL), box.upper.fill(-HUGE_VAL);
    for (const Revolution& vortex : scene.motion.as<Vortex3d>()->all()) {
      box.hold(vortex.center - vortex.half_box());
      box.hold(vortex.center + vortex.half_box());
    }
    return box;
  } else {
    if (scene.body.domain != Body::Domain::ring) return {scene.body.lower, scene.body.upper};
    const double outer = ring_of(scene.motion)->outer;
    return {{-outer, -outer}, {outer, outer}};
  }
}

template <int Dim>
BoxOf<Dim> swept_box(const Scene& scene) {
  if constexpr (Dim == 3) {
    const bool stays = scene.motion.as<Vortex3d>() || is_vortex(scene.motion);
    if (stays) return box_around_turns<3>(scene);
    BoxOf<3> box = corner_swept_box<3>(scene);
    if (!scene.frame) return box;
    BoxOf<3> seen = box;
    const auto corners = body_box<3>(scene).corners();
    for (int k = 0; k <= looks; ++k) {
      const double t = scene.time.end * k / looks;
      for (const Vector3& corner : corners) seen.hold(scene.frame->seen(scene.motion->at(corner, t), t).x);
    }
    return seen;
  } else {
    if (scene.body.initial_velocity) return flight_box(scene, *scene.body.initial_velocity);
    if (!ring_of(scene.motion)) return corner_swept_box<2>(scene);
    if (is_vortex(scene.motion)) return box_around_turns<2>(scene);
    const double face = ring_of(scene.motion)->outer;
    double outer = face;
    for (int k = 0; k <= looks; ++k) {
      outer = std::max(outer, ring_kinematics(scene.motion, face, scene.time.end * k / looks).rho);
    }
    return {{-outer, -outer}, {outer, outer}};
  }
}

template BoxOf<2> body_box<2>(const Scene&);
template BoxOf<3> body_box<3>(const Scene&);
template BoxOf<2> swept_box<2>(const Scene&);
template BoxOf<3> swept_box<3>(const Scene&);

}  // namespace assay::drivers
