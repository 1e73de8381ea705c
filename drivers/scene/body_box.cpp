// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/body_box.hpp"

#include <cmath>

namespace assay::drivers {

namespace {

/// Of the body turned by the frame: a ring stays itself, and what spins sweeps the circle of its farthest corner.
Box turned_box(const Scene& scene, const Frame& frame) {
  const Box own = body_box(scene);
  if (scene.body.domain == Body::Domain::ring || (frame.angle == 0 && frame.spin == 0)) return own;
  Box box;
  double farthest = 0;
  for (const double x : {own.lower[0], own.upper[0]}) {
    for (const double y : {own.lower[1], own.upper[1]}) {
      farthest = std::max(farthest, std::hypot(x, y));
      box.hold(frame.rotation(0) * Vector3(x, y, 0));  // the ring around the origin is inside
    }
  }
  if (frame.spin != 0) box.lower.fill(-farthest), box.upper.fill(farthest);
  return box;
}

constexpr int looks = 400;  ///< over the time of a run

/// Of a box whose faces stay straight: of the corners, at many times.
Box corner_swept_box(const Scene& scene) {
  Box box = body_box(scene);
  const Box own = box;
  for (int k = 0; k <= looks; ++k) {
    for (const double X : {own.lower[0], own.upper[0]}) {
      for (const double Y : {own.lower[1], own.upper[1]})
        box.hold(scene.motion->at({X, Y, 0}, scene.time.end * k / looks).x);
    }
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

}  // namespace

Box body_box(const Scene& scene) {
  if (scene.body.domain != Body::Domain::ring) return {scene.body.lower, scene.body.upper};
  const double outer = ring_of(scene.motion)->outer;
  return {{-outer, -outer}, {outer, outer}};
}

Box swept_box(const Scene& scene) {
  if (scene.body.initial_velocity) return flight_box(scene, *scene.body.initial_velocity);
  if (!ring_of(scene.motion)) return corner_swept_box(scene);
  if (!is_vortex(scene.motion)) {
    const double face = ring_of(scene.motion)->outer;
    double outer = face;
    for (int k = 0; k <= looks; ++k) {
      outer = std::max(outer, ring_kinematics(scene.motion, face, scene.time.end * k / looks).rho);
    }
    return {{-outer, -outer}, {outer, outer}};
  }
  if (!scene.frame) return body_box(scene);
  Box box = turned_box(scene, *scene.frame);
  box.move({scene.frame->velocity.x(), scene.frame->velocity.y()}, scene.time.end);
  return box;
}

}  // namespace assay::drivers
