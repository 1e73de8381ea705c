// SPDX-License-Identifier: BSD-3-Clause
// How kernels reach the weights and the columns.
#pragma once

#include "mpm/basis.hpp"
#include "mpm/column_access.hpp"
#include "mpm/kernels.hpp"

// Each set of instructions has kernels in a namespace of its own.
#ifndef ASSAY_INSTRUCTIONS
#define ASSAY_INSTRUCTIONS baseline
#endif

namespace assay::mpm::ASSAY_INSTRUCTIONS {

template <class B, int Dim>
ASSAY_INLINE B& basis_of(KernelState<Dim>& s) {
  return *static_cast<B*>(s.basis.get());
}
template <class B, int Dim>
ASSAY_INLINE const B& basis_of(const KernelState<Dim>& s) {
  return *static_cast<const B*>(s.basis.get());
}

/// Particles from `begin` that are worked on together.
ASSAY_INLINE std::size_t count_at(std::size_t begin, const Block& block) {
  return block.end - begin < particles_at_once ? block.end - begin : particles_at_once;
}

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
