// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/passes_grid.hpp"

#include <array>

#include "mpm/data/dimension.hpp"

namespace assay::mpm {

template <int Dim>
Pass<Dim> grid_velocity_pass() {
  Pass<Dim> pass;
  pass.name = "grid_velocity";
  pass.doc = "nodal velocity from momentum";
  pass.called_for_by = "method.update";
  pass.grid_fields = {"mass", "momentum", "velocity"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    return [&s](const Instant&) {
      s.live.each([&](std::size_t i) {
        const double* inertia = s.inertia.node(i);
        double* motion = s.motion.node(i);
        for (std::size_t d = 0; d < Dim; ++d) {
          motion[d] = inertia[0] > 0 ? inertia[1 + d] / inertia[0] : 0;
          motion[Dim + d] = 0;
        }
      });
    };
  };
  return pass;
}

template <int Dim>
Pass<Dim> grid_update_pass() {
  Pass<Dim> pass;
  pass.name = "grid_update";
  pass.doc = "nodal acceleration and velocity";
  pass.called_for_by = "method";
  pass.grid_fields = {"mass", "momentum", "force", "velocity", "acceleration"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    return [&s](const Instant& now) {
      s.live.each([&](std::size_t i) {
        const double* inertia = s.inertia.node(i);
        const double* force = s.force.node(i);
        double* motion = s.motion.node(i);
        if (!(inertia[0] > 0)) {
          for (std::size_t d = 0; d < 2 * Dim; ++d) motion[d] = 0;
          return;
        }
        const double inverse = 1 / inertia[0];
        for (std::size_t d = 0; d < Dim; ++d) {
          motion[Dim + d] = force[d] * inverse;
          motion[d] = inertia[1 + d] * inverse + now.kick * motion[Dim + d];
        }
      });
    };
  };
  return pass;
}

template <int Dim>
void hold_nodes(State<Dim>& s, Reaction reaction, double kick) {
  std::array<double, Dim> taken{};
  const auto gained = [&](const double* motion, std::size_t d) {
    return reaction.of_velocity * motion[d] + reaction.of_acceleration * kick * motion[Dim + d];
  };
  for (const std::uint32_t i : s.held_nodes) {
    double* motion = s.motion.node(i);
    for (std::size_t d = 0; d < Dim; ++d) {
      taken[d] += s.inertia.node(i)[0] * gained(motion, d);
      motion[d] = motion[Dim + d] = 0;
    }
  }
  if (!s.held_mass.empty()) {
    s.live.each([&](std::size_t i) {
      for (std::size_t d = 0; d < Dim; ++d) taken[d] += s.held_mass[i] * gained(s.motion.node(i), d);
    });
  }
  for (std::size_t d = 0; d < Dim; ++d) s.ledger.impulse[d] -= taken[d];
}

template <int Dim>
Pass<Dim> hold_nodes_pass(Reaction reaction) {
  Pass<Dim> pass;
  pass.name = "hold_nodes";
  pass.doc = "nodes outside the ring stand still";
  pass.called_for_by = "body.outside";
  pass.effects = {Effect::outside_held};
  pass.grid_fields = {"mass", "velocity", "acceleration"};
  pass.bind = [reaction](State<Dim>& s) -> Kernel {
    return [&s, reaction](const Instant& now) { hold_nodes(s, reaction, now.kick); };
  };
  return pass;
}

template Pass<ASSAY_DIMENSION> grid_velocity_pass();
template Pass<ASSAY_DIMENSION> grid_update_pass();
template Pass<ASSAY_DIMENSION> hold_nodes_pass(Reaction);

}  // namespace assay::mpm
