// SPDX-License-Identifier: BSD-3-Clause
// The declared state of one point between a foreign array and the state of our ABI.
#pragma once

#include "adapters/foreign/component_order.hpp"
#include "adapters/foreign/foreign_point.hpp"

namespace assay::adapters {

/// How an interface keeps symmetric tensors.
struct StateLayout {
  const std::array<Pair, 6>& order;
  double stress_shear, strain_shear;
};

/// Components of the declared variables of a point.
int foreign_state_size(const std::vector<ForeignVariable>& variables);
int components_of(ForeignVariable::Kind kind);

/// ours -> foreign and back; both contiguous, in declared order. Scalars, vectors and tensors are the same in both.
void to_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* ours,
                double* foreign);
void from_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* foreign,
                  double* ours);

/// Initial values of the declared variables: of a tensor as the description gives them, in our order.
void write_initial(const std::vector<ForeignVariable>& variables, double* ours);

/// Whether NTENS = 6 is served; else plane strain alone.
bool serves_all_components(const ForeignModel& model);

/// Throws PointFailure where a model of plane strain is to shear out of the plane.
void require_served(const ForeignModel& model, const Tensor& F0, const Tensor& F1);

/// "0.25": for messages.
std::string shortest_text(double value);

}  // namespace assay::adapters
