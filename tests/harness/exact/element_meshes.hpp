// SPDX-License-Identifier: BSD-3-Clause
// Meshes of linear elements, and integrals over them and their outer faces by formulas of their own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "harness/exact/nodal_loads.hpp"

namespace assay::element_meshes {

inline bool is_plane(ElementMesh::Shape shape) { return ElementMesh{shape, {}, {}}.is_plane(); }

/// n cells along each direction, each an element, two triangles or six tetrahedra.
inline ElementMesh lattice(ElementMesh::Shape shape, const Vector3& lower, const Vector3& upper, int n) {
  using Shape = ElementMesh::Shape;
  const bool plane = is_plane(shape);
  ElementMesh mesh{shape, {}, {}};
  for (int k = 0; k <= (plane ? 0 : n); ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) mesh.X.emplace_back(lower + (upper - lower).cwiseProduct(Vector3(i, j, k)) / n);
    }
  }
  const auto node = [&](int i, int j, int k) { return static_cast<std::int64_t>(i + (n + 1) * (j + (n + 1) * k)); };
  const auto add = [&](std::initializer_list<std::int64_t> nodes) {
    mesh.connectivity.insert(mesh.connectivity.end(), nodes);
  };
  for (int k = 0; k < (plane ? 1 : n); ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const auto at = [&](int a, int b, int c) { return node(i + a, j + b, k + c); };
        if (shape == Shape::quadrilateral) add({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)});
        if (shape == Shape::triangle) {
          add({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0)});
          add({at(0, 0, 0), at(1, 1, 0), at(0, 1, 0)});
        }
        if (shape == Shape::hexahedron) {
          add({at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
        }
        if (shape != Shape::tetrahedron) continue;
        std::array<int, 3> axes{0, 1, 2};
        do {  // from corner to corner along the axes in this order
          std::array<std::array<int, 3>, 4> way{};
          for (std::size_t s = 0; s < 3; ++s) {
            way[s + 1] = way[s];
            way[s + 1][static_cast<std::size_t>(axes[s])] = 1;
          }
          const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
          if (!even) std::swap(way[1], way[2]);
          for (const auto& [a, b, c] : way) mesh.connectivity.push_back(at(a, b, c));
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  return mesh;
}

/// With inner nodes somewhere else; the box is from 0 to upper.
inline ElementMesh distorted(ElementMesh mesh, const Vector3& upper) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> off(-0.03, 0.03);
  for (Vector3& X : mesh.X) {
    bool inner = true;
    for (int d = 0; d < (mesh.is_plane() ? 2 : 3); ++d) inner &= X(d) > 1e-9 && X(d) < upper(d) - 1e-9;
    if (inner) X += Vector3(off(generator), off(generator), mesh.is_plane() ? 0 : off(generator));
  }
  return mesh;
}

/// A node and the value of its function at a point.
using NodeShare = std::pair<std::size_t, double>;

/// visit(at, weight) over [0, 1]^dimension.
inline void over_cube(int dimension, int points, const auto& visit) {
  const auto rule = gauss_points(points);
  const int count = static_cast<int>(std::pow(points, dimension) + 0.5);
  for (int k = 0; k < count; ++k) {
    Vector3 at = Vector3::Zero();
    double weight = 1;
    for (int d = 0, rest = k; d < dimension; ++d, rest /= points) {
      const GaussPoint& point = rule[static_cast<std::size_t>(rest % points)];
      at(d) = 0.5 * (1 + point.at), weight *= 0.5 * point.weight;
    }
    visit(at, weight);
  }
}

/// Bilinear and trilinear functions, for s from -1 to 1.
inline double corner_function(std::size_t corner, const Vector3& u, int dimension) {
  constexpr int signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                               {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  double N = 1;
  for (int d = 0; d < dimension; ++d) N *= 0.5 * (1 + signs[corner][d] * (2 * u(d) - 1));
  return N;
}

/// The values of the functions at u in the unit cube or square, which is mapped to a simplex along the ways from its
/// first node.
inline std::vector<double> functions_at(std::size_t nodes, int dimension, const Vector3& u) {
  const double s = u(0), r = u(1), q = u(2);
  if (dimension == 1) return {1 - s, s};
  if (nodes == 3) return {1 - s, s * (1 - r), s * r};
  if (dimension == 3 && nodes == 4) return {1 - s, s * (1 - r), s * r * (1 - q), s * r * q};
  std::vector<double> N(nodes);
  for (std::size_t k = 0; k < nodes; ++k) N[k] = corner_function(k, u, dimension);
  return N;
}

/// visit(X, shares, slopes d X / d u, weight) at points of what the nodes span.
inline void over_nodes(const ElementMesh& mesh, const std::vector<std::size_t>& nodes, int dimension, int points,
                       const auto& visit) {
  const auto at = [&](const Vector3& u) {
    Vector3 X = Vector3::Zero();
    const auto N = functions_at(nodes.size(), dimension, u);
    for (std::size_t k = 0; k < nodes.size(); ++k) X += N[k] * mesh.X[nodes[k]];
    return X;
  };
  over_cube(dimension, points, [&](const Vector3& u, double weight) {
    const auto N = functions_at(nodes.size(), dimension, u);
    std::vector<NodeShare> shares;
    for (std::size_t k = 0; k < nodes.size(); ++k) shares.emplace_back(nodes[k], N[k]);
    Tensor slopes = Tensor::Zero();  // of functions that are linear along each direction
    for (int d = 0; d < dimension; ++d) {
      Vector3 low = u, high = u;
      low(d) = 0, high(d) = 1;
      slopes.col(d) = at(high) - at(low);
    }
    visit(at(u), shares, slopes, weight);
  });
}

/// visit(X, shares, dV) over all elements.
inline void for_each_point(const ElementMesh& mesh, int points, const auto& visit) {
  const std::size_t n = mesh.nodes_of_element();
  const int dimension = mesh.is_plane() ? 2 : 3;
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    std::vector<std::size_t> nodes;
    for (std::size_t k = 0; k < n; ++k) nodes.push_back(static_cast<std::size_t>(mesh.connectivity[e * n + k]));
    over_nodes(mesh, nodes, dimension, points,
               [&](const Vector3& X, const std::vector<NodeShare>& shares, Tensor slopes, double weight) {
                 if (dimension == 2) slopes(2, 2) = 1;
                 visit(X, shares, weight * slopes.determinant());
               });
  }
}

/// Faces of an element, whose nodes go round the outward normal; of plane ones the edges, counterclockwise.
inline std::vector<std::vector<std::size_t>> faces_of(ElementMesh::Shape shape) {
  switch (shape) {
    case ElementMesh::Shape::triangle:
      return {{0, 1}, {1, 2}, {2, 0}};
    case ElementMesh::Shape::quadrilateral:
      return {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    case ElementMesh::Shape::tetrahedron:
      return {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    case ElementMesh::Shape::hexahedron:
      break;
  }
  return {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {1, 2, 6, 5}, {3, 0, 4, 7}};
}

/// visit(nodes) of the faces that belong to one element.
inline void for_each_outer_face(const ElementMesh& mesh, const auto& visit) {
  std::map<std::vector<std::size_t>, std::pair<int, std::vector<std::size_t>>> faces;
  const std::size_t n = mesh.nodes_of_element();
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    for (std::vector<std::size_t> face : faces_of(mesh.shape)) {
      for (std::size_t& node : face) node = static_cast<std::size_t>(mesh.connectivity[e * n + node]);
      std::vector<std::size_t> sorted = face;
      std::sort(sorted.begin(), sorted.end());
      auto& [times, nodes] = faces[sorted];
      ++times, nodes = face;
    }
  }
  for (const auto& [sorted, face] : faces) {
    if (face.first == 1) visit(face.second);
  }
}

/// Of a plane face, with its outward normal [m^2]; of an edge [m].
inline Vector3 area_of(const ElementMesh& mesh, const std::vector<std::size_t>& nodes) {
  const auto X = [&](std::size_t k) -> const Vector3& { return mesh.X[nodes[k]]; };
  if (nodes.size() == 2) return (X(1) - X(0)).cross(Vector3::UnitZ());
  const Vector3 first = (X(1) - X(0)).cross(X(2) - X(0)) / 2;
  return nodes.size() == 3 ? first : Vector3(first + (X(2) - X(0)).cross(X(3) - X(0)) / 2);
}

/// visit(X, shares, N dS) over all outer faces.
inline void for_each_face_point(const ElementMesh& mesh, int points, const auto& visit) {
  for_each_outer_face(mesh, [&](const std::vector<std::size_t>& nodes) {
    const int dimension = mesh.is_plane() ? 1 : 2;
    over_nodes(mesh, nodes, dimension, points,
               [&](const Vector3& X, const std::vector<NodeShare>& shares, const Tensor& slopes, double weight) {
                 const Vector3 along = slopes.col(0),
                               across = mesh.is_plane() ? Vector3::UnitZ() : Vector3(slopes.col(1));
                 visit(X, shares, Vector3(weight * along.cross(across)));
               });
  });
}

}  // namespace assay::element_meshes
