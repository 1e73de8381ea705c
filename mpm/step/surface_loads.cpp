// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/surface_loads.hpp"

#include <algorithm>

#include "mpm/setup/with_basis.hpp"
#include "mpm/step/state.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
Vec<Dim> first_components(const std::array<double, 2 * Dim>& motion) {
  Vec<Dim> v;
  std::copy_n(motion.begin(), Dim, v.begin());
  return v;
}

/// Takes the functions of the basis if it is evaluated at points, and multilinear ones otherwise.
template <class B, int Dim>
void bind_points(SurfaceLoads<Dim>& loads, const GridGeometry<Dim>& grid) {
  auto basis = std::make_shared<B>(grid, Vec<Dim>{}, loads.points.size());
  loads.place = [basis](std::size_t k, const Vec<Dim>& x) {
    Mat<Dim> undeformed{};
    for (std::size_t d = 0; d < Dim; ++d) undeformed[d * (Dim + 1)] = 1;
    return basis->place(k, x, undeformed);
  };
  loads.reach = [basis](std::size_t k) {
    NodeBox<Dim> nodes;
    basis->reach(k, k + 1, nodes);
    return nodes;
  };
  loads.scatter = [basis, &loads](std::size_t k, double* force) {
    basis->template scatter<Dim, 0>(k, loads.points[k].force, {}, force);
  };
  loads.velocity = [basis](std::size_t k, const double* motion) {
    std::array<double, 2 * Dim> found;
    std::array<double, 0> none;
    basis->template gather<2 * Dim, 0>(k, motion, found, none);
    return first_components<Dim>(found);
  };
}

/// phi_ip of the particles, which the step has placed.
template <class B, int Dim>
void bind_particles(SurfaceLoads<Dim>& loads, const State<Dim>& s) {
  const auto basis = [&s]() -> const B& { return *static_cast<const B*>(s.basis.get()); };
  loads.place = [](std::size_t, const Vec<Dim>&) { return true; };
  loads.reach = [](std::size_t) { return NodeBox<Dim>(); };
  loads.scatter = [basis, &loads](std::size_t k, double* force) {
    basis().template scatter<Dim, 0>(loads.points[k].particle, loads.points[k].force, {}, force);
  };
  loads.velocity = [basis, &loads](std::size_t k, const double* motion) {
    std::array<double, 2 * Dim> found;
    std::array<double, 0> none;
    basis().template gather<2 * Dim, 0>(loads.points[k].particle, motion, found, none);
    return first_components<Dim>(found);
  };
}

}  // namespace

template <int Dim>
void place_loads(State<Dim>& s, std::vector<SurfacePoint<Dim>> points, bool at_particles) {
  auto& loads = s.template own<SurfaceLoads<Dim>>();
  loads.points = std::move(points);
  const Basis own = s.setup.method.basis;
  with_basis<Dim>(at_particles || traits_of<Dim>(own).at_points ? own : Basis::linear, [&](auto tag) {
    using B = typename decltype(tag)::type;
    if (at_particles)
      bind_particles<B>(loads, s);
    else
      bind_points<B>(loads, s.setup.grid);
  });
}

template void place_loads(State<ASSAY_DIMENSION>&, std::vector<SurfacePoint<ASSAY_DIMENSION>>, bool);

}  // namespace assay::mpm
