// SPDX-License-Identifier: BSD-3-Clause
// The library knows methods by their keys and moves no particle: in place of the kernels, which are most of the
// program.
#include <stdexcept>

#include "mpm/kernels/kernels.hpp"
#include "mpm/kernels/mass_stencil.hpp"

namespace assay::mpm {

namespace {

[[noreturn]] void refuse_to_step() { throw std::logic_error("the library runs no steps"); }

}  // namespace

template <>
Kernels<2> kernels_of(Basis, Instructions) {
  refuse_to_step();
}

template <>
AdvanceDeformation<2> advance_deformation(Instructions) {
  refuse_to_step();
}

template <>
MultiplyRows multiply_rows_of<2>(Instructions) {
  refuse_to_step();
}

}  // namespace assay::mpm
