// SPDX-License-Identifier: BSD-3-Clause
// The generalized vortex in three dimensions: a body of revolution whose points turn about its axis by an angle that
// varies in the meridian plane. Every point is in simple shear with rotation, as in the plane.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "harness/motion/common_point.hpp"
#include "harness/motion/motion_kind.hpp"
#include "harness/motion/revolution.hpp"

namespace assay {

/// A point of a vortex, in the meridian plane through it.
struct MeridianPoint {
  MeridianProfile profile;
  std::size_t vortex = 0;  ///< that holds it
  double R = 0;            ///< distance from the axis [m]
  double G = 0;            ///< |k|, k = Grad h = G N [1/m]
  double c = 1, s = 0;     ///< N = c E_R + s E_Z; where G = 0, E_R
  double xi = 0;           ///< R G/2 [1]
  Vector3 center, E_Z;     ///< of the vortex [m], [1]
  double Z = 0;            ///< along the axis, from the centre [m]
  Vector3 radial;          ///< R E_R [m]

  Vector3 around() const { return E_Z.cross(radial); }                                ///< R E_Theta [m]
  Vector3 gradient() const { return profile.h_R_by_R * radial + profile.h_Z * E_Z; }  ///< k [1/m]
  Tensor rotation(double alpha) const;                                                ///< Q, about the axis
  Tensor axes() const;  ///< columns N, E_Theta, M = -s E_R + c E_Z
};

/// a of it [m/s^2]. Q: its rotation by g(t) h.
Vector3 acceleration_of(const MeridianPoint& point, const AmplitudeValue& g, const Tensor& Q);

/// x, v, a and F of it. g: of the time.
ExactState state_of(const MeridianPoint& point, const AmplitudeValue& g);

/// x = C + Q(alpha) (X - C) about the axis through C, alpha = g(t) h(R, Z), in one vortex or in several that have no
/// point in common.
struct Vortex3d {
  Revolution one;                         ///< where no list is given
  std::vector<Revolution> vortices = {};  ///< in place of it
  Amplitude amplitude;

  std::span<const Revolution> all() const {
    return vortices.empty() ? std::span(&one, 1) : std::span<const Revolution>(vortices);
  }

  /// Where X lies in the vortex that holds it; absent outside all. On an edge it lies inside.
  std::optional<MeridianPoint> place(const Vector3& X) const;

  ExactState at(const Vector3& X, double t) const;

  /// Two vortices with points in common, and one of these points; absent where all are disjoint.
  struct Overlap {
    std::size_t first = 0, second = 0;
    Vector3 X = Vector3::Zero();  ///< [m]
  };
  std::optional<Overlap> overlap() const;

  /// The largest xi of all vortices.
  double largest_xi() const;

  /// The baseline F = I + 2 g(t) xi E2 E1 (16) with parameter xi >= 0; E1, E2, E3 are N, E_Theta, M of the point.
  Path baseline() const;
};

/// Places points in the vortices of a motion as Vortex3d::place does, in a time that hardly grows with their number.
class VortexFinder {
 public:
  explicit VortexFinder(const Vortex3d& motion);
  std::optional<MeridianPoint> place(const Vector3& X) const;

 private:
  std::vector<Revolution> vortices_;
  std::vector<Vector3> along_;  ///< their axes [1]
  BodyBoxes boxes_;
};

void fields(auto& archive, Vortex3d& m) { archive(m.one, m.vortices, m.amplitude); }

std::unique_ptr<MotionKind> kind_of(const Vortex3d& motion);

}  // namespace assay
