// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/surface_loads.hpp"

#include "mpm/setup/with_basis.hpp"
#include "mpm/step/state.hpp"

namespace assay::mpm {

namespace {

/// Takes the functions of the basis if it is evaluated at points, and multilinear ones otherwise.
template <class B>
void bind_points(SurfaceLoads& loads, const GridGeometry<2>& grid) {
  auto basis = std::make_shared<B>(grid, Vec<2>{}, loads.points.size());
  loads.place = [basis](std::size_t k, const Vec<2>& x) { return basis->place(k, x, {1, 0, 0, 1}); };
  loads.reach = [basis](std::size_t k) {
    NodeBox<2> nodes;
    basis->reach(k, k + 1, nodes);
    return nodes;
  };
  loads.scatter = [basis, &loads](std::size_t k, double* force) {
    basis->template scatter<2, 0>(k, loads.points[k].force, {}, force);
  };
  loads.velocity = [basis](std::size_t k, const double* motion) {
    std::array<double, 4> found;
    std::array<double, 0> none;
    basis->template gather<4, 0>(k, motion, found, none);
    return Vec<2>{found[0], found[1]};
  };
}

/// phi_ip of the particles, which the step has placed.
template <class B>
void bind_particles(SurfaceLoads& loads, const State<2>& s) {
  const auto basis = [&s]() -> const B& { return *static_cast<const B*>(s.basis.get()); };
  loads.place = [](std::size_t, const Vec<2>&) { return true; };
  loads.reach = [](std::size_t) { return NodeBox<2>(); };
  loads.scatter = [basis, &loads](std::size_t k, double* force) {
    basis().template scatter<2, 0>(loads.points[k].particle, loads.points[k].force, {}, force);
  };
  loads.velocity = [basis, &loads](std::size_t k, const double* motion) {
    std::array<double, 4> found;
    std::array<double, 0> none;
    basis().template gather<4, 0>(loads.points[k].particle, motion, found, none);
    return Vec<2>{found[0], found[1]};
  };
}

}  // namespace

void place_loads(State<2>& s, std::vector<SurfacePoint> points, bool at_particles) {
  auto& loads = s.own<SurfaceLoads>();
  loads.points = std::move(points);
  const Basis own = s.setup.method.basis;
  with_basis<2>(at_particles || traits_of<2>(own).at_points ? own : Basis::linear, [&](auto tag) {
    using B = typename decltype(tag)::type;
    if (at_particles)
      bind_particles<B>(loads, s);
    else
      bind_points<B>(loads, s.setup.grid);
  });
}

}  // namespace assay::mpm
