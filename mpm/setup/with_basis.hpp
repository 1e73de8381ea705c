// SPDX-License-Identifier: BSD-3-Clause
// From the name of a basis to its type.
#pragma once

#include <stdexcept>
#include <type_traits>

#include "all_bases.inc"
#include "mpm/basis/corners.hpp"
#include "mpm/setup/method.hpp"

namespace assay::mpm {

/// Calls visit with the basis's type as a tag.
template <int Dim, class Visitor>
auto with_basis(Basis basis, const Visitor& visit) {
  switch (basis) {
#define ASSAY_BASIS(word, type, header) \
  case Basis::word:                     \
    return visit(std::type_identity<type<Dim>>());
#include "mpm/basis/bases.inc"
#undef ASSAY_BASIS
  }
  throw std::invalid_argument("no basis");
}

/// What a step needs to know of a basis.
struct BasisTraits {
  bool moves_corners = false, uses_deformation = false;
  std::size_t domain_components = 0, bytes = 0;  ///< of a domain of one's own; of the weights a particle
  int nodes_across = 0;                          ///< over which a particle reaches; 0 where that is not fixed
};

template <int Dim>
BasisTraits traits_of(Basis basis) {
  return with_basis<Dim>(basis, [](auto tag) {
    using B = typename decltype(tag)::type;
    return BasisTraits{MovesCorners<B>, B::uses_deformation, B::domain_components, B::bytes, B::nodes_across};
  });
}

}  // namespace assay::mpm
