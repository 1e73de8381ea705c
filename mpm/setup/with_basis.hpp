// SPDX-License-Identifier: BSD-3-Clause
// From the name of a basis to its type.
#pragma once

#include <type_traits>

#include "mpm/basis/basis_bspline.hpp"
#include "mpm/basis/basis_cpdi.hpp"
#include "mpm/basis/basis_cpdi2.hpp"
#include "mpm/basis/basis_cpgimp.hpp"
#include "mpm/basis/basis_linear.hpp"
#include "mpm/basis/basis_ugimp.hpp"
#include "mpm/basis/corners.hpp"
#include "mpm/setup/method.hpp"

namespace assay::mpm {

/// Calls visit with the basis's type as a tag.
template <int Dim, class Visitor>
auto with_basis(Basis basis, const Visitor& visit) {
  switch (basis) {
    case Basis::linear:
      return visit(std::type_identity<LinearBasis<Dim>>());
    case Basis::ugimp:
      return visit(std::type_identity<UgimpBasis<Dim>>());
    case Basis::cpgimp:
      return visit(std::type_identity<CpgimpBasis<Dim>>());
    case Basis::bspline2:
      return visit(std::type_identity<Bspline2Basis<Dim>>());
    case Basis::bspline3:
      return visit(std::type_identity<Bspline3Basis<Dim>>());
    case Basis::bspline4:
      return visit(std::type_identity<Bspline4Basis<Dim>>());
    case Basis::cpdi2:
      return visit(std::type_identity<Cpdi2Basis<Dim>>());
    case Basis::cpdi:
      break;
  }
  return visit(std::type_identity<CpdiBasis<Dim>>());
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
