// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_state.hpp"

#include <charconv>

#include "adapters/foreign/host_values.hpp"

namespace assay::adapters {

namespace {

using Kind = ForeignVariable::Kind;

double shear_of(const StateLayout& layout, Kind kind) {
  if (kind == Kind::mandel) return mfront_shear;
  return kind == Kind::strain ? layout.strain_shear : layout.stress_shear;
}

/// Of each variable: convert(shear, from, to) where it is a symmetric tensor; all else is the same on both sides.
void convert_state(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* from,
                   double* to, const auto& convert) {
  for (const ForeignVariable& variable : variables) {
    const int n = components_of(variable.kind);
    if (abi_kind(variable.kind) == ASSAY_SYMMETRIC_TENSOR)
      convert(shear_of(layout, variable.kind), from, to);
    else
      std::copy_n(from, n, to);
    from += n, to += n;
  }
}

}  // namespace

std::int32_t abi_kind(Kind kind) {
  constexpr std::int32_t kinds[] = {ASSAY_SCALAR,           ASSAY_VECTOR, ASSAY_SYMMETRIC_TENSOR,
                                    ASSAY_SYMMETRIC_TENSOR, ASSAY_TENSOR, ASSAY_SYMMETRIC_TENSOR};
  return kinds[static_cast<std::size_t>(kind)];
}

int components_of(Kind kind) { return components_of_kind(abi_kind(kind)); }

int foreign_state_size(const std::vector<ForeignVariable>& variables) {
  int size = 0;
  for (const ForeignVariable& variable : variables) size += components_of(variable.kind);
  return size;
}

void to_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* ours,
                double* foreign) {
  convert_state(layout, variables, ours, foreign, [&](double shear, const double* from, double* to) {
    write_symmetric(read_symmetric(from, standard_order, plain_shear), layout.order, shear, to);
  });
}

void from_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* foreign,
                  double* ours) {
  convert_state(layout, variables, foreign, ours, [&](double shear, const double* from, double* to) {
    write_symmetric(read_symmetric(from, layout.order, shear), standard_order, plain_shear, to);
  });
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

std::array<char, 80> cmname_of(const ForeignModel& model) {
  std::array<char, 80> name;
  name.fill(' ');
  model.material_name.copy(name.data(), name.size());
  return name;
}

int components_served(const ForeignModel& model) { return std::ranges::max(model.components); }

bool is_of_plane_stress(const ForeignModel& model) { return components_served(model) == 3; }

bool serves_all_components(const ForeignModel& model) { return components_served(model) == 6; }

void require_served(const ForeignModel& model, const Tensor& F0, const Tensor& F1) {
  if (serves_all_components(model)) return;
  constexpr double nothing = 1e-13;
  const auto out_of_plane = [](const Tensor& F) {
    return std::max({std::abs(F(0, 2)), std::abs(F(1, 2)), std::abs(F(2, 0)), std::abs(F(2, 1))});
  };
  if (std::max(out_of_plane(F0), out_of_plane(F1)) > nothing) {
    const char* served = is_of_plane_stress(model)                     ? "plane stress alone (NTENS = 3)"
                         : model.interface == ForeignInterface::mfront ? "deformations in the plane alone"
                                                                       : "plane strain alone (NTENS = 4)";
    throw PointFailure(std::string("the model serves ") + served + ", and this step shears out of the plane");
  }
}

std::string shortest_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

HostValues host_values_of(const ForeignModel& model) {
  HostValues values;
  values.element = model.element;
  values.point = model.point;
  values.step = model.step;
  values.temperature = model.temperature;
  values.length = model.characteristic_length;
  for (const ForeignField& field : model.fields) values.fields.push_back(field.value);
  return values;
}

void Surroundings::take_back(GuardedArrays& arrays) {
  for (const std::size_t word : arrays.take_back(words)) {
    const auto at = std::lower_bound(written.begin(), written.end(), word);
    if (at == written.end() || *at != word) written.insert(at, word);
  }
}

std::vector<std::size_t> Surroundings::left_at_times() const {
  std::vector<std::size_t> components;
  for (std::size_t k = 0; k < state_left.size(); ++k) {
    if (state_left[k] && state_written[k]) components.push_back(k + 1);
  }
  return components;
}

}  // namespace assay::adapters
