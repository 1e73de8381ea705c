// SPDX-License-Identifier: BSD-3-Clause
// How kernels reach the weights and the columns.
#pragma once

#include "mpm/basis/basis.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/kernels/kernels.hpp"

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

/// body(begin, n, nodes) for neighbouring particles of the block, a few at a time, with their weights.
template <class B, class Body>
ASSAY_INLINE void for_chunks(const B& basis, const Block& block, const Body& body) {
  typename B::Nodes nodes;
  for (std::size_t begin = block.begin; begin < block.end; begin += particles_at_once) {
    const std::size_t n = count_at(begin, block);
    basis.expand(begin, n, nodes);
    body(begin, n, nodes);
  }
}

}  // namespace assay::mpm::ASSAY_INSTRUCTIONS
