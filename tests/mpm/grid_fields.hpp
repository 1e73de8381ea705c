// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/grid/grid_field.hpp"

namespace assay::mpm {

/// Another field of the same values.
template <int Components>
GridField<Components> copied(const GridField<Components>& field) {
  GridField<Components> copy;
  copy.allocate(field.nodes());
  const NodeRange all{0, field.nodes()};
  copy.copy(field, std::span(&all, 1));
  return copy;
}

}  // namespace assay::mpm
