// SPDX-License-Identifier: BSD-3-Clause
// From the name of a basis to its type.
#pragma once

#include <stdexcept>
#include <type_traits>

#include "all_bases.inc"
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

}  // namespace assay::mpm
