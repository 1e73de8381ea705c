// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/nodal_loads.hpp"

#include <algorithm>
#include <cmath>

#include "harness/exact/divided_quadrature.hpp"

namespace assay {

namespace {

using ElementShape = ElementMesh::Shape;

/// The node at each corner of the square or cube of which an element is the image: of a triangle or tetrahedron, whose
/// map is collapsed, some stand at several. Their functions are linear nevertheless.
std::span<const std::size_t> nodes_at_corners(ElementShape shape) {
  static constexpr std::array<std::size_t, 8> cube{0, 1, 2, 3, 4, 5, 6, 7};
  static constexpr std::array<std::size_t, 4> triangle{0, 1, 2, 2};
  static constexpr std::array<std::size_t, 8> tetrahedron{0, 1, 2, 2, 3, 3, 3, 3};
  switch (shape) {
    case ElementShape::triangle:
      return triangle;
    case ElementShape::quadrilateral:
      return std::span(cube).first<4>();
    case ElementShape::tetrahedron:
      return tetrahedron;
    case ElementShape::hexahedron:
      break;
  }
  return cube;
}

bool is_simplex(ElementShape shape) { return shape == ElementShape::triangle || shape == ElementShape::tetrahedron; }

template <int Dim>
MultilinearMap<Dim> map_of_element(const ElementMesh& mesh, std::span<const std::int64_t> nodes) {
  MultilinearMap<Dim> map;
  const auto at_corners = nodes_at_corners(mesh.shape);
  for (std::size_t k = 0; k < map.corners.size(); ++k)
    map.corners[k] = mesh.X[static_cast<std::size_t>(nodes[at_corners[k]])];
  return map;
}

template <int Dim>
using Slopes = Eigen::Matrix<double, Dim, Dim>;

/// d X / d u.
template <int Dim>
Slopes<Dim> slopes_at(const MultilinearMap<Dim>& map, const std::array<double, Dim>& u) {
  Slopes<Dim> slopes;
  for (int d = 0; d < Dim; ++d) slopes.col(d) = map.slope(u, static_cast<std::size_t>(d)).template head<Dim>();
  return slopes;
}

/// det over the product of the lengths of the columns [1]; 0 where one has none.
template <int Dim>
double relative_volume(const Slopes<Dim>& slopes) {
  const double lengths = slopes.colwise().stableNorm().prod();
  return lengths > 0 ? slopes.determinant() / lengths : 0;
}

}  // namespace

std::size_t ElementMesh::nodes_of_element() const {
  const auto at_corners = nodes_at_corners(shape);
  return 1 + *std::max_element(at_corners.begin(), at_corners.end());
}

NodalLoads::NodalLoads(ElementMesh mesh, const ExactSolution& exact, double density, const NodalLoadRule& rule)
    : mesh_(std::move(mesh)), exact_(&exact), density_(density), rule_(rule) {
  if (!(density > 0 && std::isfinite(density))) throw MeshFault("the density must be a positive number", "density");
  if (rule_.gauss < 0 || rule_.gauss > NodalLoadRule::most_points)
    throw MeshFault("must be 0 to " + std::to_string(NodalLoadRule::most_points) + " points along each direction",
                    "gauss");
  if (rule_.gauss == 0) rule_.gauss = is_simplex(mesh_.shape) ? 3 : 2;
  gauss_ = gauss_points(rule_.gauss);
  const auto nodes = static_cast<std::int64_t>(mesh_.X.size());
  for (std::int64_t i = 0; i < nodes; ++i) {
    const Vector3& X = mesh_.X[static_cast<std::size_t>(i)];
    const std::string node = "node " + std::to_string(i);
    if (!X.allFinite()) throw MeshFault(node + " has a coordinate that is not a finite number", "X", i);
    if (mesh_.is_plane() && X.z() != 0) throw MeshFault(node + " of plane elements must have Z = 0", "X", i);
  }
  const std::size_t n = mesh_.nodes_of_element();
  if (mesh_.connectivity.size() % n != 0)
    throw MeshFault("elements of this shape have " + std::to_string(n) + " nodes each, found " +
                        std::to_string(mesh_.connectivity.size()) + " in all",
                    "connectivity");
  for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
    const std::int64_t node = mesh_.connectivity[k], element = static_cast<std::int64_t>(k / n);
    if (node < 0 || node >= nodes)
      throw MeshFault("element " + std::to_string(element) + " has node " + std::to_string(node) + " of nodes 0 to " +
                          std::to_string(nodes - 1),
                      "connectivity", element);
  }
  if (mesh_.is_plane())
    check_elements<2>();
  else
    check_elements<3>();
  places_ = exact.places(mesh_.is_plane() ? gauss_points_of_elements<2>() : gauss_points_of_elements<3>());
}

template <int Dim>
void NodalLoads::check_elements() const {
  constexpr double flat = 1e-10;  // of a cube's
  for (std::size_t e = 0; e < mesh_.elements(); ++e) {
    const auto map = map_of_element<Dim>(mesh_, nodes_of(e));
    bool is_sound = true;
    for_each_share<Dim>(gauss_.size(), [&](const std::array<std::size_t, Dim>& index) {
      std::array<double, Dim> u;
      for (std::size_t d = 0; d < Dim; ++d) u[d] = 0.5 * (1 + gauss_[index[d]].at);
      return is_sound &= relative_volume<Dim>(slopes_at<Dim>(map, u)) > flat;
    });
    for_each_share<Dim>(2, [&](const std::array<std::size_t, Dim>& index) {  // where two nodes are one it may be 0
      std::array<double, Dim> u;
      for (std::size_t d = 0; d < Dim; ++d) u[d] = static_cast<double>(index[d]);
      return is_sound &= relative_volume<Dim>(slopes_at<Dim>(map, u)) > -flat;
    });
    if (is_sound) continue;
    throw MeshFault("element " + std::to_string(e) + " is inverted or flat: its nodes must go in VTK's order" +
                        (mesh_.is_plane() ? ", counterclockwise" : ""),
                    "connectivity", static_cast<std::int64_t>(e));
  }
}

template <int Dim>
std::vector<Vector3> NodalLoads::gauss_points_of_elements() const {
  std::vector<Vector3> points;
  for (std::size_t e = 0; e < mesh_.elements(); ++e) {
    const auto map = map_of_element<Dim>(mesh_, nodes_of(e));
    for_each_share<Dim>(gauss_.size(), [&](const std::array<std::size_t, Dim>& index) {
      std::array<double, Dim> u;
      for (std::size_t d = 0; d < Dim; ++d) u[d] = 0.5 * (1 + gauss_[index[d]].at);
      points.push_back(map(u));
      return true;
    });
  }
  return points;
}

/// loads: at the Gauss points of the element, should it not be divided.
template <int Dim>
void NodalLoads::integrate(const ExactSlice& slice, std::size_t element, std::span<const PointLoad> loads,
                           std::span<Vector3> force) const {
  const auto map = map_of_element<Dim>(mesh_, nodes_of(element));
  const auto at_corners = nodes_at_corners(mesh_.shape);
  const auto add = [&](const std::array<double, Dim>& u, double weight, const Tensor& P, const Vector3& a) {
    const Slopes<Dim> slopes = slopes_at<Dim>(map, u), to_gradient = slopes.inverse().transpose();
    const double volume = weight * slopes.determinant();
    for (std::size_t k = 0; k < map.corners.size(); ++k) {
      Eigen::Matrix<double, Dim, 1> slope;
      for (int d = 0; d < Dim; ++d) slope(d) = MultilinearMap<Dim>::weight_slope(k, u, static_cast<std::size_t>(d));
      Vector3 gradient = Vector3::Zero();
      gradient.template head<Dim>() = to_gradient * slope;
      force[at_corners[k]] += volume * (density_ * MultilinearMap<Dim>::weight(k, u) * a + P * gradient);
    }
  };
  constexpr auto of = ExactSlice::Smooth::stress;
  int divisions = Dim == 3 ? rule_.divisions / 2 : rule_.divisions;
  std::vector<PointLoad> own;  // of points that are registered for this time alone
  if (is_divided(slice, of, map, divisions)) {
    std::vector<Vector3> X;
    for_each_gauss_point<Dim>(slice, of, map, gauss_, divisions, {},
                              [&](const auto& u, double) { X.push_back(map(u)); });
    own = loads_at(*exact_->places(X), slice, 0, X.size());
    loads = own;
  } else {
    divisions = 0;
  }
  std::size_t k = 0;
  for_each_gauss_point<Dim>(slice, of, map, gauss_, divisions, {}, [&](const auto& u, double weight) {
    const PointLoad& here = loads[k++];
    add(u, weight, tensor_of(here.P.data()), Eigen::Map<const Vector3>(here.a.data()));
  });
}

std::vector<NodalLoads::PointLoad> NodalLoads::loads_at(const ExactPlaces& places, const ExactSlice& slice,
                                                        std::size_t first, std::size_t count) const {
  constexpr std::ptrdiff_t stride = sizeof(PointLoad) / sizeof(double);
  std::vector<PointLoad> loads(count);
  FieldViews wanted;
  wanted.P = {loads.front().P.data(), stride, 1};
  if (!rule_.quasi_static) wanted.a = {loads.front().a.data(), stride, 1};
  places.evaluate(slice, first, count, wanted);
  return loads;
}

template <int Dim>
void NodalLoads::integrate_all(const ExactSlice& slice, std::size_t begin, std::size_t end,
                               std::span<Vector3> force) const {
  constexpr std::size_t at_once = 512;  // points
  const std::size_t n = mesh_.nodes_of_element();
  const std::size_t each = gauss_.size() * gauss_.size() * (Dim == 3 ? gauss_.size() : 1);
  const std::size_t some = std::max<std::size_t>(1, at_once / each);
  for (std::size_t first = begin; first < end; first += some) {
    const std::size_t last = std::min(first + some, end);
    const auto loads = loads_at(*places_, slice, first * each, (last - first) * each);
    for (std::size_t e = first; e < last; ++e)
      integrate<Dim>(slice, e, std::span(loads).subspan((e - first) * each, each), force.subspan(e * n, n));
  }
}

std::vector<Vector3> NodalLoads::at(const ExactSlice& slice, const InPieces& pieces) const {
  std::vector<Vector3> of_elements(mesh_.connectivity.size(), Vector3::Zero());
  pieces(mesh_.elements(), [&](std::size_t begin, std::size_t end) {
    if (mesh_.is_plane())
      integrate_all<2>(slice, begin, end, of_elements);
    else
      integrate_all<3>(slice, begin, end, of_elements);
  });
  std::vector<Vector3> force(mesh_.X.size(), Vector3::Zero());
  for (std::size_t k = 0; k < of_elements.size(); ++k)  // in the order of the elements
    force[static_cast<std::size_t>(mesh_.connectivity[k])] += of_elements[k];
  return force;
}

}  // namespace assay
