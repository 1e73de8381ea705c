// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_corners.hpp"

#include "mpm/kernels.hpp"

namespace assay::mpm {

template <int Dim>
Pass<Dim> corners_pass() {
  Pass<Dim> pass;
  pass.name = "corners";
  pass.doc = "corners of the domains by grid velocity, one by one";
  pass.called_for_by = "method.basis";
  pass.reads = {Column::weights, Column::corners};
  pass.writes = {Column::corners};
  pass.grid_fields = {"velocity"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    Kernel kernel;
    const auto move = s.kernels.corners;
    kernel.block = [&s, move](const Instant& now, const Block& block) { return move(s, block, now); };
    return kernel;
  };
  return pass;
}

template Pass<2> corners_pass();
template Pass<3> corners_pass();

}  // namespace assay::mpm
