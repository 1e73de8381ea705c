// SPDX-License-Identifier: BSD-3-Clause
// J2 plasticity with kinematic hardening whose state tells less than the built-in model's: for tests.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "tests/harness/builtin_material.hpp"

namespace assay {

/// Its state: stress, back stress; with `clock` a time that every step changes; with `counts` the plastic strain, too.
struct Disguise {
  bool clock = false, counts = false;
};

inline std::shared_ptr<const Material> disguised_j2(Disguise disguise, double yield_stress) {
  static const assay_material* const original = assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0);
  constexpr static std::size_t inner = 13;  // p, stress, back stress
  struct Table : assay_material {
    std::array<assay_state_variable, 4> variables{};
    bool counts = false, clock = false;
  };
  struct Self {
    void* original;
    const Table* table;
  };
  static std::vector<std::unique_ptr<Table>> all;
  Table& t = *all.emplace_back(std::make_unique<Table>());
  static_cast<assay_material&>(t) = *original;
  t.counts = disguise.counts, t.clock = disguise.clock;
  t.variables[0] = original->state[1], t.variables[1] = original->state[2];
  t.state_count = 2;
  if (t.counts) t.variables[t.state_count++] = original->state[0];
  if (t.clock) t.variables[t.state_count++] = {"clock", "s", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""};
  t.state = t.variables.data();
  t.create = nullptr;
  t.create_of = [](const assay_material* table, const double* p, char* message) -> void* {
    void* made = create_instance(original, p, message);
    return made ? new Self{made, static_cast<const Table*>(table)} : nullptr;
  };
  t.destroy = [](void* self) {
    original->destroy(static_cast<Self*>(self)->original);
    delete static_cast<Self*>(self);
  };
  t.extension = nullptr;
  t.extension_of = nullptr;
  t.initial_state = [](void* self, std::size_t n, const double*, double* state) -> std::int32_t {
    const Table& table = *static_cast<Self*>(self)->table;
    std::fill_n(state, n * (12 + (table.counts ? 1u : 0u) + (table.clock ? 1u : 0u)), 0.0);
    return ASSAY_GOOD;
  };
  t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
                std::int32_t* status, double* dt_factor, char* message) {
    const Table& table = *static_cast<Self*>(self)->table;
    std::vector<double> before(inner * n), after(inner * n);
    std::copy_n(state0, 12 * n, before.begin() + static_cast<std::ptrdiff_t>(n));
    if (table.counts) std::copy_n(state0 + 12 * n, n, before.begin());
    original->update(static_cast<Self*>(self)->original, step, n, before.data(), after.data(), cauchy, status,
                     dt_factor, message);
    std::copy_n(after.begin() + static_cast<std::ptrdiff_t>(n), 12 * n, state1);
    double* next = state1 + 12 * n;
    if (table.counts) next = std::copy_n(after.begin(), n, next);
    for (std::size_t p = 0; table.clock && p < n; ++p) next[p] = state0[(next - state1) + p] + step->dt;
  };
  return std::make_shared<const Material>(
      &t, std::map<std::string, double>{
              {"E", 1000}, {"nu", 0.3}, {"yield_stress", yield_stress}, {"kinematic_modulus", 50}});
}

}  // namespace assay
