// SPDX-License-Identifier: BSD-3-Clause
// Consistent nodal forces of a finite element mesh, which make it follow the exact solution.
//
// The balance of momentum, rho0 b = rho0 a - DIV(P), times a node's function N_I, by parts: the body force and the
// tractions P N on all outer faces together do the work of
//
//   f_I = integral of rho0 b N_I dV + integral of P N N_I dS = integral of (rho0 a N_I + P Grad N_I) dV
//
// which asks for no derivative of P, and for no list of faces. Without inertia rho0 a is left out.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "harness/exact/places.hpp"
#include "harness/numeric/gauss.hpp"

namespace assay {

/// Linear elements of one shape. Nodes of an element go in VTK's order: in the plane counterclockwise.
struct ElementMesh {
  enum class Shape { triangle, quadrilateral, tetrahedron, hexahedron };
  Shape shape = Shape::hexahedron;
  std::vector<Vector3> X;                  ///< reference positions of the nodes; in the plane Z = 0 [m]
  std::vector<std::int64_t> connectivity;  ///< node k of element e, from 0, is [e * nodes_of_element() + k]

  bool is_plane() const { return shape == Shape::triangle || shape == Shape::quadrilateral; }
  std::size_t nodes_of_element() const;
  std::size_t elements() const { return connectivity.size() / nodes_of_element(); }
};

/// What is wrong with a mesh, in a sentence.
class MeshFault : public std::invalid_argument {
 public:
  MeshFault(const std::string& what, std::string of, std::int64_t at = -1)
      : std::invalid_argument(what), argument(std::move(of)), index(at) {}
  std::string argument;     ///< "X", "connectivity", "density" or "gauss"
  std::int64_t index = -1;  ///< of the node or element, from 0; -1: of none
};

struct NodalLoadRule {
  static constexpr int most_points = 16;
  /// Gauss points along each direction of an element. 0: two of quadrilaterals and hexahedra, which leave an error of
  /// fourth order in the size of an element; three of triangles and tetrahedra, exact where P is cubic and a quadratic.
  int gauss = 0;
  /// Times that an element is halved in all directions where it is not smooth; in space half as often.
  int divisions = 3;
  bool quasi_static = false;  ///< without inertia
};

class NodalLoads {
 public:
  /// What is integrated, at a point: P, row-major [Pa], and a, 0 without inertia [m/s^2].
  struct PointLoad {
    std::array<double, 9> P{};
    std::array<double, 3> a{};
  };

  /// Lives no longer than the solution. density: rho0 [kg/m^3]. Throws MeshFault: numbers that are not finite, nodes
  /// that are not there, elements that are inverted or flat.
  NodalLoads(ElementMesh mesh, const ExactSolution& exact, double density, const NodalLoadRule& rule = {});

  /// The force on each node at the time of a slice of that solution [N], of plane elements per metre of thickness
  /// [N/m]; a node of no element has none. The same to the last bit in any number of pieces. Elements should lie in the
  /// body: elsewhere the motion goes on by its formula. Throws MaterialFailure.
  std::vector<Vector3> at(const ExactSlice& slice, const InPieces& pieces = in_one_piece) const;

  const ElementMesh& mesh() const { return mesh_; }

 private:
  template <int Dim>
  void check_elements() const;
  template <int Dim>
  std::vector<Vector3> gauss_points_of_elements() const;
  /// At places first .. first + count - 1.
  std::vector<PointLoad> loads_at(const ExactPlaces& places, const ExactSlice& slice, std::size_t first,
                                  std::size_t count) const;
  template <int Dim>
  void integrate(const ExactSlice& slice, std::size_t element, std::span<const PointLoad> loads,
                 std::span<Vector3> force) const;
  template <int Dim>
  void integrate_all(const ExactSlice& slice, std::size_t begin, std::size_t end, std::span<Vector3> force) const;

  std::span<const std::int64_t> nodes_of(std::size_t element) const {
    const std::size_t n = mesh_.nodes_of_element();
    return std::span(mesh_.connectivity).subspan(element * n, n);
  }

  ElementMesh mesh_;
  const ExactSolution* exact_;
  double density_;
  NodalLoadRule rule_;
  std::vector<GaussPoint> gauss_;
  std::unique_ptr<const ExactPlaces> places_;  ///< the Gauss points of all elements that are not divided
};

}  // namespace assay
