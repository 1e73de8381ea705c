// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_corners.hpp"

#include "mpm/bases.hpp"
#include "mpm/blocks.hpp"
#include "mpm/column_access.hpp"

namespace assay::mpm {

template <class B, int Dim>
Pass<Dim> corners_pass() {
  Pass<Dim> pass;
  pass.name = "corners";
  pass.doc = "corners of the domains by grid velocity, one by one";
  pass.called_for_by = "method.basis";
  pass.reads = {Column::weights, Column::corners};
  pass.writes = {Column::corners};
  pass.grid_fields = {"velocity"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    return [&s, &basis](const Instant& now) {
      const auto corners = components<corner_components<Dim>>(s, Column::corners);
      for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
          const auto motion = basis.template at_corners<2 * Dim>(p, s.motion);
          for (std::size_t c = 0; c < motion.size(); ++c) {
            for (std::size_t d = 0; d < Dim; ++d) corners[c * Dim + d][p] += now.dt * motion[c][d];
          }
        }
      });
    };
  };
  return pass;
}

template Pass<2> corners_pass<Cpdi2Basis<2>, 2>();
template Pass<3> corners_pass<Cpdi2Basis<3>, 3>();

}  // namespace assay::mpm
