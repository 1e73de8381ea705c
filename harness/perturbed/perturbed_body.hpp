// SPDX-License-Identifier: BSD-3-Clause
// Meshes of the perturbed problem: what is known of a body's elements.
#pragma once

#include <memory>
#include <vector>

#include "harness/motion/motion.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// Gauss's two points in (0, 1), each of weight 1/2.
inline constexpr std::array<double, 2> middle_points{0.21132486540518713, 0.78867513459481287};  // (1 -+ 1/sqrt 3)/2

/// A point with its share of the nodes; at most four have one.
struct MeshPoint {
  Vector3 X = Vector3::Zero();  ///< [m]
  double weight = 0;            ///< its part of the volume, or of the surface [m^2], [m]; of a ring per radian
  std::array<std::size_t, 4> node{};
  std::array<double, 4> share{};
  Vector3 normal = Vector3::Zero();  ///< on the surface, outward
};

/// Nodes that move in the plane, and elements between them. A ring has the symmetry of its motion: its nodes lie along
/// the ray Theta = 0, and stand for all others at their radius.
class PerturbedBody {
 public:
  virtual ~PerturbedBody() = default;

  std::vector<Vector3> nodes;             ///< reference positions [m]
  std::vector<std::array<bool, 2>> held;  ///< of each node, along x and y
  std::vector<MeshPoint> loads;           ///< where the body force is integrated
  std::vector<MeshPoint> surface;         ///< where tractions are
  std::vector<Vector3> samples;           ///< where the exact force is tabulated
  std::vector<double> weights;            ///< of the points of stress
  double edge = 0;                        ///< shortest edge of an element [m]

  /// F at the points of stress.
  virtual void deformation(const std::vector<Vector3>& x, std::vector<Tensor>& F) const = 0;
  /// Adds the forces of the stresses P at these points to those of the nodes.
  virtual void add_stress(const std::vector<Vector3>& x, const std::vector<Tensor>& P,
                          std::vector<Vector3>& force) const = 0;
  /// Where a point is now.
  virtual Vector3 position(const std::vector<Vector3>& x, const MeshPoint& point) const = 0;
  /// Adds a force at a point to those of its nodes.
  virtual void add_load(const std::vector<Vector3>& x, const MeshPoint& point, const Vector3& load,
                        std::vector<Vector3>& force) const = 0;
  /// Samples around X and their shares; vectors of them are turned by `turn` about E_z to be those at X.
  struct Around {
    std::array<std::size_t, 4> sample{};
    std::array<double, 4> share{};
    double turn = 0;  ///< [rad]
  };
  virtual Around around(const Vector3& X) const = 0;

  /// A value of the nodes at X.
  virtual Vector3 value_at(const std::vector<Vector3>& nodal, const Vector3& X) const = 0;
};

/// What holds the ring of a polar motion.
enum class RingSupport {
  free,          ///< its faces bear the exact tractions, or none
  held,          ///< its faces do not move
  free_outside,  ///< the body goes on to both sides
};

/// Elements of equal width along the radius. outside: radius at which the body ends, for free_outside [m].
std::unique_ptr<PerturbedBody> perturbed_ring(const Motion& motion, RingSupport support, int elements, double outside);

/// Elements of a box in the plane; faces that are symmetry planes of the motion do not move along their normals.
std::unique_ptr<PerturbedBody> perturbed_box(const Motion& motion, const std::array<double, 2>& lower,
                                             const std::array<double, 2>& upper, int elements);

}  // namespace assay
