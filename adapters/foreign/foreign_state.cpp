// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_state.hpp"

#include <algorithm>
#include <charconv>

namespace assay::adapters {

namespace {

using Kind = ForeignVariable::Kind;

double shear_of(const StateLayout& layout, Kind kind) {
  if (kind == Kind::mandel) return mfront_shear;
  return kind == Kind::strain ? layout.strain_shear : layout.stress_shear;
}

bool is_symmetric(Kind kind) { return kind == Kind::symmetric_tensor || kind == Kind::strain || kind == Kind::mandel; }

}  // namespace

int components_of(Kind kind) {
  switch (kind) {
    case Kind::scalar:
      return 1;
    case Kind::vector:
      return 3;
    case Kind::symmetric_tensor:
    case Kind::strain:
    case Kind::mandel:
      return 6;
    case Kind::tensor:
      return 9;
  }
  return 0;
}

int foreign_state_size(const std::vector<ForeignVariable>& variables) {
  int size = 0;
  for (const ForeignVariable& variable : variables) size += components_of(variable.kind);
  return size;
}

void to_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* ours,
                double* foreign) {
  for (const ForeignVariable& variable : variables) {
    const int n = components_of(variable.kind);
    if (is_symmetric(variable.kind)) {
      write_symmetric(read_symmetric(ours, standard_order, plain_shear), layout.order, shear_of(layout, variable.kind),
                      foreign);
    } else {
      std::copy_n(ours, n, foreign);
    }
    ours += n, foreign += n;
  }
}

void from_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* foreign,
                  double* ours) {
  for (const ForeignVariable& variable : variables) {
    const int n = components_of(variable.kind);
    if (is_symmetric(variable.kind)) {
      write_symmetric(read_symmetric(foreign, layout.order, shear_of(layout, variable.kind)), standard_order,
                      plain_shear, ours);
    } else {
      std::copy_n(foreign, n, ours);
    }
    ours += n, foreign += n;
  }
}

void write_initial(const std::vector<ForeignVariable>& variables, double* ours) {
  for (const ForeignVariable& variable : variables) {
    const auto n = static_cast<std::size_t>(components_of(variable.kind));
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t given = variable.initial.size();
      ours[k] = given == 0 ? 0 : variable.initial[given == 1 ? 0 : k];
    }
    ours += n;
  }
}

bool serves_all_components(const ForeignModel& model) {
  return std::find(model.components.begin(), model.components.end(), 6) != model.components.end();
}

void require_served(const ForeignModel& model, const Tensor& F0, const Tensor& F1) {
  if (serves_all_components(model)) return;
  constexpr double nothing = 1e-13;
  const auto out_of_plane = [](const Tensor& F) {
    return std::max({std::abs(F(0, 2)), std::abs(F(1, 2)), std::abs(F(2, 0)), std::abs(F(2, 1))});
  };
  if (std::max(out_of_plane(F0), out_of_plane(F1)) > nothing) {
    throw PointFailure("the model serves plane strain alone (NTENS = 4), and this step shears out of the plane");
  }
}

std::string shortest_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

}  // namespace assay::adapters
