// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "harness/numeric/in_pieces.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// tau(xi) of one time. Many threads may ask it.
class ResponseAtTime {
 public:
  virtual ~ResponseAtTime() = default;

  /// tau and (d tau / d xi)_t [Pa].
  virtual void at(double xi, Tensor& tau, Tensor& dtau_dxi) const = 0;

  /// tau alone at many xi, in-plane components: tau[c * n + i], c = 11, 12, 21, 22 [Pa].
  virtual void plane_tau(std::span<const double> xi, std::span<double> tau, const InPieces& pieces) const;

  /// Values of xi, ascending, at which (d tau / d xi)_t jumps: the fronts of a material with kinks.
  virtual std::vector<double> fronts() const { return {}; }
};

}  // namespace assay
