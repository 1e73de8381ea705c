// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/passes_grid.hpp"

#include "mpm/data/dimension.hpp"

namespace assay::mpm {

template <int Dim>
Pass<Dim> grid_velocity_pass(const Method& method) {
  Pass<Dim> pass;
  pass.name = "grid_velocity";
  pass.slot = {gradient_phase(method)};
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
  pass.slot = {Phase::grid};
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

template Pass<ASSAY_DIMENSION> grid_velocity_pass(const Method&);
template Pass<ASSAY_DIMENSION> grid_update_pass();

}  // namespace assay::mpm
