// SPDX-License-Identifier: BSD-3-Clause
// The Jaumann material of jaumann_material.hpp with what foreign code may do to a history.
#pragma once

#include <atomic>
#include <bit>

#include "tests/harness/jaumann_material.hpp"

namespace assay {

/// `noise`: relative error of the stress, a function of the step's own bits. `restless`: relative error of the stress,
/// another one at each call. `flickers`: not 0, the regime changes with the step's own bits.
namespace disturbed_detail {

struct Model {
  JaumannModel jaumann;
  double noise, restless, flickers;
};

/// In [-1, 1), by Knuth's multiplicative hash.
inline double scrambled(std::uint64_t bits) {
  bits = (bits ^ (bits >> 29)) * 0x9e3779b97f4a7c15ULL;
  bits = (bits ^ (bits >> 32)) * 0xbf58476d1ce4e5b9ULL;
  return static_cast<double>(bits >> 11) / 4503599627370496.0 - 1;
}

inline void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
  static std::atomic<std::uint64_t> calls{0};
  auto& m = *static_cast<Model*>(self);
  jaumann_detail::update(&m.jaumann, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (std::size_t p = 0; p < n; ++p) {
    const double own = scrambled(std::bit_cast<std::uint64_t>(step->F1[3 * n + p]));
    const double factor = 1 + m.noise * own + m.restless * scrambled(++calls);
    for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = state1[c * n + p] *= factor;
    state1[9 * n + p] = m.flickers != 0 && own > 0 ? 1 : 0;
  }
}

}  // namespace disturbed_detail

inline const assay_material* disturbed_table() {
  static const assay_parameter parameters[] = {{"E", "Pa", 1e3, 0, 1e12, "Young's modulus"},
                                               {"nu", "1", 0.3, -1, 0.5, "Poisson's ratio"},
                                               {"noise", "1", 0, 0, 1, "of the stress, by the step's bits"},
                                               {"restless", "1", 0, 0, 1, "of the stress, by the call"},
                                               {"flickers", "1", 0, 0, 1, "whether the regime does"}};
  static const assay_state_variable state[] = {
      {"stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress at the beginning of the step"},
      {"branch", "regime", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "0 or 1"}};
  static const assay_material table = [] {
    assay_material t = *jaumann_table();
    t.name = "disturbed_for_tests";
    t.flags |= ASSAY_NON_SMOOTH;
    t.parameter_count = 5;
    t.parameters = parameters;
    t.state_count = 2;
    t.state = state;
    t.create = [](const double* p, char*) -> void* {
      return new disturbed_detail::Model{
          {p[0] * p[1] / ((1 + p[1]) * (1 - 2 * p[1])), p[0] / (2 * (1 + p[1])), 1e9}, p[2], p[3], p[4]};
    };
    t.destroy = [](void* self) { delete static_cast<disturbed_detail::Model*>(self); };
    t.initial_state = [](void*, std::size_t n, const double* cauchy, double* out) -> std::int32_t {
      std::memcpy(out, cauchy, 9 * n * sizeof(double));
      std::memset(out + 9 * n, 0, n * sizeof(double));
      return ASSAY_GOOD;
    };
    t.update = disturbed_detail::update;
    return t;
  }();
  return &table;
}

inline std::shared_ptr<const Material> disturbed_material(const std::map<std::string, double>& parameters) {
  return std::make_shared<Material>(disturbed_table(), parameters);
}

}  // namespace assay
