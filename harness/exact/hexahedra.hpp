// SPDX-License-Identifier: BSD-3-Clause
// The body force averaged over hexahedral reference domains, from the stress alone: no derivative of it.
//
//   rho0 V b_avg = integral of rho0 a dV - closed integral of T.N dS
//
// A face that two domains share is integrated once, so that its force goes from one to the other without a rest. Faces
// and domains in which the solution is not smooth, at an edge of the motion or a front of the material, are divided.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/numeric/gauss.hpp"

namespace assay {

/// Domains whose edges are straight and whose faces are bilinear. Corners that are equal to the bit are one corner.
class Hexahedra {
 public:
  /// The corners of each domain in VTK's order: the lower face counterclockwise seen from above, then the upper one
  /// [m].
  explicit Hexahedra(std::span<const std::array<Vector3, 8>> domains);

  using Face = std::array<std::uint32_t, 4>;  ///< its corners
  struct Side {
    std::uint32_t face = 0;
    double sign = 1;  ///< -1: its normal points into the domain
  };
  struct Domain {
    std::array<std::uint32_t, 8> corners;
    std::array<Side, 6> sides;
  };

  const std::vector<Vector3>& corners() const { return corners_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Domain>& domains() const { return domains_; }

 private:
  std::vector<Vector3> corners_;
  std::vector<Face> faces_;
  std::vector<Domain> domains_;
};

/// Half of the longest and of the shortest edge of a face, or of a domain in VTK's order [m].
struct HalfEdges {
  /// corners: 4 or 8; directions: in which edges are measured and, of a domain, lie: 3, or 2 in the plane.
  HalfEdges(std::span<const Vector3> corners, int directions);
  double longest = 0, shortest = std::numeric_limits<double>::infinity();
};

/// The boxes around points with these half edges [m]; on a lattice neighbours share their corners to the last bit.
std::vector<std::array<Vector3, 8>> boxes_around(std::span<const Vector3> points, const Vector3& half);

struct HexahedronRule {
  int gauss = 2;              ///< points along each direction of a piece
  int divisions = 3;          ///< times that a face is halved both ways where it is not smooth; a domain half as often
  bool quasi_static = false;  ///< without inertia
  /// Half edge up to which that many points do: longer faces and domains have one more for each such length [m].
  double reach = std::numeric_limits<double>::infinity();
  int directions = 3;  ///< in which edges are measured for that

  int points_along(double half_edge) const;
};

/// What acts on a domain.
struct DomainForce {
  Vector3 b = Vector3::Zero();       ///< mean of b [m/s^2]
  Vector3 moment = Vector3::Zero();  ///< integral of x cross rho0 b dV about the origin, x the current position [N m]
};

class HexahedronAverage {
 public:
  /// density: rho0 [kg/m^3].
  HexahedronAverage(Hexahedra domains, double density, const HexahedronRule& rule = {});

  /// Of each domain, at the slice's time. Throws MaterialFailure.
  std::vector<DomainForce> at(const ExactSlice& slice, const InPieces& pieces = in_one_piece) const;

  double volume(std::size_t domain) const { return volume_[domain]; }  ///< [m^3]
  std::size_t faces() const { return domains_.faces().size(); }

 private:
  struct Flux {
    Vector3 force = Vector3::Zero(), moment = Vector3::Zero();  ///< of T.N dS [N], [N m]
  };
  Flux flux(const ExactSlice& slice, std::size_t face) const;
  Flux inertia(const ExactSlice& slice, std::size_t domain) const;
  std::uint8_t points_along(std::span<const std::uint32_t> corners);

  Hexahedra domains_;
  double density_;
  HexahedronRule rule_;
  std::vector<std::vector<GaussPoint>> gauss_;     ///< of each number of points that is needed
  std::vector<std::uint8_t> of_face_, of_domain_;  ///< numbers of points
  std::vector<double> volume_;
};

}  // namespace assay
