// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/passes_affine.hpp"

#include "mpm/data/dimension.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernels.hpp"

namespace assay::mpm {

template <int Dim>
Pass<Dim> affine_pass(const Method& method) {
  Pass<Dim> pass;
  const bool moment = method.affine == Affine::moment, total = method.is_total(), fits = fits_gradient(method);
  pass.name = "affine";
  pass.doc = moment  ? "first moment of the grid velocity around the particles"
             : total ? "gradient of the grid velocity"
             : fits  ? "gradient fitted to the grid velocity around the particles, convected"
                     : "gradient of the grid velocity, convected";
  pass.called_for_by = "method.transfer";
  pass.effects = {Effect::affine_velocity};
  pass.reads = {Column::weights};
  pass.grid_fields = {"velocity"};
  pass.writes = {Column::affine};
  pass.bind = [=](State<Dim>& s) -> Kernel {
    const Kernels<Dim>& kernels = s.kernels;
    const auto carry = moment ? kernels.moment : total ? kernels.gradient : fits ? kernels.fitted : kernels.convected;
    Kernel kernel;
    kernel.block = [&s, carry](const Instant& now, const Block& block) { return carry(s, block, now); };
    return kernel;
  };
  return pass;
}

template <int Dim>
Pass<Dim> first_affine_moment_pass() {
  Pass<Dim> pass;
  pass.name = "first_affine_moment";
  pass.doc = "first moment of the initial velocity around the particles";
  pass.called_for_by = "method.affine";
  pass.effects = {Effect::affine_velocity};
  pass.once = true;
  pass.reads = {Column::weights, Column::affine};
  pass.writes = {Column::affine};
  pass.bind = [](State<Dim>& s) -> Kernel {
    Kernel kernel;
    const auto first = s.kernels.first_moment;
    kernel.block = [&s, first](const Instant& now, const Block& block) { return first(s, block, now); };
    return kernel;
  };
  return pass;
}

template Pass<ASSAY_DIMENSION> affine_pass(const Method&);
template Pass<ASSAY_DIMENSION> first_affine_moment_pass();

}  // namespace assay::mpm
