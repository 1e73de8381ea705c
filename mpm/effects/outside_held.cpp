// SPDX-License-Identifier: BSD-3-Clause
// Nodes outside the vortex stand still, and particles that never move give the grid their mass.
#include <array>
#include <cmath>
#include <functional>

#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/setup/with_basis.hpp"
#include "mpm/step/effect.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

namespace {

/// Whether a place is outside the vortex or on its edge, which stands still.
std::function<bool(const Vector3&)> outside_of(const Motion& motion) {
  if (const auto ring = ring_of(motion)) {
    return [ring = *ring](const Vector3& x) {
      const double R = std::sqrt(x.x() * x.x() + x.y() * x.y());
      return R <= ring.inner || R >= ring.outer;
    };
  }
  return [finder = VortexFinder(*motion.as<Vortex3d>())](const Vector3& x) {
    const auto place = finder.place(x);
    return !place || place->profile.h == 0;
  };
}

template <int Dim>
std::vector<std::uint32_t> held_nodes(const Setup<Dim>& setup) {
  const auto outside = outside_of(*setup.motion);
  const GridGeometry<Dim>& grid = setup.grid;
  std::vector<std::uint32_t> nodes;
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    std::size_t rest = i;
    Vector3 x = Vector3::Zero();
    for (int d = 0; d < Dim; ++d) {
      const auto count = static_cast<std::size_t>(grid.count[static_cast<std::size_t>(d)]);
      x(d) = grid.coordinate(d, static_cast<std::int32_t>(rest % count));
      rest /= count;
    }
    if (Dim == 3 && setup.frame) x = setup.frame->body_point(x);
    if (outside(x)) nodes.push_back(static_cast<std::uint32_t>(i));
  }
  return nodes;
}

/// Particles that never move give the grid their mass and, where they are stressed, their internal force once. Their
/// domains are turned as a rigid motion would.
template <int Dim>
Held held_in(const Setup<Dim>& setup) {
  const Seeds<Dim>& seeds = setup.seeds;
  Mat<Dim> F{};
  for (std::size_t d = 0; d < Dim; ++d) F[d * Dim + d] = 1;
  F[0] = F[Dim + 1] = std::cos(seeds.angle);
  F[Dim] = std::sin(seeds.angle);
  F[1] = -F[Dim];
  Held held{std::vector<double>(setup.grid.nodes(), 0.0), {}, held_nodes(setup)};
  if (setup.is_stressed()) held.force.assign(Dim * setup.grid.nodes(), 0.0);
  with_basis<Dim>(setup.method.basis, [&](auto tag) {
    typename decltype(tag)::type basis(setup.grid, seeds.half_size, 1);
    for (std::size_t k = 0; k < seeds.held.size(); ++k) {
      const double volume = seeds.held_volume(k), m = setup.density * volume;
      if (!basis.place(0, seeds.held[k], F)) continue;
      basis.template scatter<1, 0>(0, {m}, {}, held.mass.data());
      if (held.force.empty()) continue;
      Mat<Dim> of_stress{};
      for (int i = 0; i < Dim; ++i) {
        for (int j = 0; j < Dim; ++j)
          of_stress[static_cast<std::size_t>(i * Dim + j)] = -volume * setup.initial_cauchy(i, j);
      }
      basis.template scatter<Dim, Dim>(0, {}, of_stress, held.force.data());
    }
  });
  return held;
}

template <int Dim>
void hold_nodes(State<Dim>& s, const Held& held, Reaction reaction, double kick) {
  std::array<double, Dim> taken{};
  const auto gained = [&](const double* motion, std::size_t d) {
    return reaction.of_velocity * motion[d] + reaction.of_acceleration * kick * motion[Dim + d];
  };
  for (const std::uint32_t i : held.nodes) {
    double* motion = s.motion.node(i);
    for (std::size_t d = 0; d < Dim; ++d) {
      taken[d] += s.inertia.node(i)[0] * gained(motion, d);
      motion[d] = motion[Dim + d] = 0;
    }
  }
  if (!held.mass.empty()) {
    s.live.each([&](std::size_t i) {
      for (std::size_t d = 0; d < Dim; ++d) taken[d] += held.mass[i] * gained(s.motion.node(i), d);
    });
  }
  for (std::size_t d = 0; d < Dim; ++d) s.ledger.impulse[d] -= taken[d];
}

/// v_i = a_i = 0 on nodes outside the vortex; the reaction enters the momentum account.
template <int Dim>
Pass<Dim> hold_nodes_pass(Phase phase, Reaction reaction) {
  return {{.name = "hold_nodes",
           .slot = {phase, Part::hold},
           .doc = "nodes outside the vortex stand still",
           .grid_fields = {"mass", "velocity", "acceleration"}},
          [reaction](State<Dim>& s) -> Kernel {
            return [&s, &held = s.template own<Held>(), reaction](const Instant& now) {
              hold_nodes(s, held, reaction, now.kick);
            };
          }};
}

/// Mass matrices leave held nodes out themselves.
template <int Dim>
std::vector<Pass<Dim>> holding_passes(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> passes;
  for (const GridPhase& grid : grid_phases(setup.method)) {
    if (grid.phase == Phase::grid && !setup.method.is_lumped()) continue;
    passes.push_back(hold_nodes_pass<Dim>(grid.phase, grid.reaction));
  }
  return passes;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> outside_held_effect() {
  EffectRecord<Dim> effect{100, "nodes and particles outside the vortex are fixed", "body.outside"};
  effect.called_for = [](const Setup<Dim>& s) { return s.hold_outside; };
  effect.passes = holding_passes<Dim>;
  effect.grid_fields = [](const Setup<Dim>& s) {
    std::vector<GridFieldUse> fields{{"held_mass", "of the particles that never move", doubles(1)}};
    if (s.is_stressed()) fields.push_back({"held_force", "of their initial stress", doubles(Dim)});
    return fields;
  };
  effect.prepare = [](State<Dim>& s) {
    auto& held = s.template own<Held>();
    held = held_in(s.setup);
    for (std::size_t i = 0; i < held.mass.size(); ++i) {
      if (held.mass[i] > 0) s.live.keep(i);
    }
    s.live.merge();
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> outside_held_effect();

}  // namespace assay::mpm
