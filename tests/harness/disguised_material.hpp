// SPDX-License-Identifier: BSD-3-Clause
// J2 plasticity with kinematic hardening whose state tells less than the built-in model's: for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/harness/builtin_material.hpp"

namespace assay {

/// Its state: stress, back stress; with `clock` a time that every step changes; with `counts` the plastic strain, too.
/// An increment whose trial stress lies within (1 + tolerance) times the yield stress is elastic.
struct Disguise {
  bool clock = false, counts = false;
  double tolerance = 0;
};

/// sqrt(3/2 x : x), x the deviator of stress less back stress, of a state of the built-in model [Pa].
inline double distance_from_back_stress(const double* state) {
  double x[6], mean = 0;
  for (int c = 0; c < 6; ++c) x[c] = state[1 + c] - state[7 + c];
  for (int c = 0; c < 3; ++c) mean += x[c] / 3;
  double sum = 0;
  for (int c = 0; c < 6; ++c) sum += c < 3 ? (x[c] - mean) * (x[c] - mean) : 2 * x[c] * x[c];
  return std::sqrt(1.5 * sum);
}

/// What of n points a trial leaves below that stress [Pa]: states of one point one component after the other.
inline void take_elastic(std::size_t n, const std::vector<double>& trial, const std::vector<double>& stress,
                         double elastic_below, std::vector<double>& after, double* cauchy) {
  for (std::size_t p = 0; p < n; ++p) {
    double one[13];
    for (std::size_t c = 0; c < 13; ++c) one[c] = trial[c * n + p];
    if (distance_from_back_stress(one) > elastic_below) continue;
    for (std::size_t c = 0; c < 13; ++c) after[c * n + p] = one[c];
    for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = stress[c * n + p];
  }
}

inline std::shared_ptr<const Material> disguised_j2(Disguise disguise, double yield_stress) {
  static const assay_material* const original = assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0);
  constexpr static std::size_t inner = 13;  // p, stress, back stress
  struct Table : assay_material {
    std::array<assay_state_variable, 4> variables{};
    bool counts = false, clock = false;
    double elastic_below = 0;
  };
  struct Self {
    void *original, *elastic;
    const Table* table;
  };
  static std::vector<std::unique_ptr<Table>> all;
  Table& t = *all.emplace_back(std::make_unique<Table>());
  static_cast<assay_material&>(t) = *original;
  t.counts = disguise.counts, t.clock = disguise.clock;
  t.elastic_below = disguise.tolerance > 0 ? (1 + disguise.tolerance) * yield_stress : 0;
  t.variables[0] = original->state[1], t.variables[1] = original->state[2];
  t.state_count = 2;
  if (t.counts) t.variables[t.state_count++] = original->state[0];
  if (t.clock) t.variables[t.state_count++] = {"clock", "s", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""};
  t.state = t.variables.data();
  t.create = nullptr;
  t.create_of = [](const assay_material* table, const double* p, char* message) -> void* {
    const double never_yields[] = {p[0], p[1], 1e6 * p[2], p[3]};
    void* made = create_instance(original, p, message);
    return made ? new Self{made, create_instance(original, never_yields, message), static_cast<const Table*>(table)}
                : nullptr;
  };
  t.destroy = [](void* self) {
    original->destroy(static_cast<Self*>(self)->original);
    original->destroy(static_cast<Self*>(self)->elastic);
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
    if (table.elastic_below > 0) {
      std::vector<double> trial(inner * n), stress(9 * n);
      original->update(static_cast<Self*>(self)->elastic, step, n, before.data(), trial.data(), stress.data(), status,
                       dt_factor, message);
      take_elastic(n, trial, stress, table.elastic_below, after, cauchy);
    }
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
