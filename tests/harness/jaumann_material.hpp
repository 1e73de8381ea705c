// SPDX-License-Identifier: BSD-3-Clause
// A hypoelastic material with the Jaumann rate for tests: it has history, its increments converge at a known order.
#pragma once

#include <cmath>
#include <cstring>
#include <memory>

#include "harness/material/material.hpp"

namespace assay {

/// sigma is the state. Each step: half rotation, sigma += lambda tr(d) I + 2 mu d at mid step, half rotation, with the
/// exact rotation exp(w dt) in the plane. `sticky`: fails where |gamma| exceeds it.
struct JaumannModel {
  double lambda, mu, breaks_at;
};

namespace jaumann_detail {

inline Tensor tensor_at(const double* a, std::size_t n, std::size_t p) {
  Tensor tensor;
  for (int c = 0; c < 9; ++c) component(tensor, c) = a[static_cast<std::size_t>(c) * n + p];
  return tensor;
}

inline void put(const Tensor& tensor, double* a, std::size_t n, std::size_t p) {
  for (int c = 0; c < 9; ++c) a[static_cast<std::size_t>(c) * n + p] = component(tensor, c);
}

inline void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                   double* cauchy, std::int32_t* status, double*, char* message) {
  const auto& m = *static_cast<const JaumannModel*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F0 = tensor_at(step->F0, n, p), F1 = tensor_at(step->F1, n, p);
    const Tensor increment = (F1 - F0) * (0.5 * (F0 + F1)).inverse();  // l dt at mid step
    const Tensor d = 0.5 * (increment + increment.transpose()), w = 0.5 * (increment - increment.transpose());
    const Tensor half = (Tensor::Identity() - 0.25 * w).inverse() * (Tensor::Identity() + 0.25 * w);
    Tensor sigma = half * tensor_at(state0, n, p) * half.transpose();
    sigma += m.lambda * d.trace() * Tensor::Identity() + 2 * m.mu * d;
    sigma = half * sigma * half.transpose();
    put(sigma, state1, n, p);
    put(sigma, cauchy, n, p);
    status[p] = std::abs(F1(1, 0)) > m.breaks_at ? ASSAY_FAILED : ASSAY_GOOD;
    if (status[p] == ASSAY_FAILED) std::strcpy(message, "sheared too far");
  }
}

}  // namespace jaumann_detail

inline const assay_material* jaumann_table() {
  static const assay_parameter parameters[] = {{"E", "Pa", 1e3, 0, 1e12, "Young's modulus"},
                                               {"nu", "1", 0.3, -1, 0.5, "Poisson's ratio"},
                                               {"breaks_at", "1", 1e9, 0, 1e9, "shear beyond which it fails"}};
  static const assay_state_variable state[] = {
      {"stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress at the beginning of the step"}};
  static const assay_material table = [] {
    assay_material t{};
    t.abi_major = ASSAY_ABI_MAJOR;
    t.struct_size = sizeof(assay_material);
    t.name = "jaumann_for_tests";
    t.flags = ASSAY_THREAD_SAFE | ASSAY_USES_INCREMENT;
    t.parameter_count = 3;
    t.parameters = parameters;
    t.state_count = 1;
    t.state = state;
    t.create = [](const double* p, char*) -> void* {
      return new JaumannModel{p[0] * p[1] / ((1 + p[1]) * (1 - 2 * p[1])), p[0] / (2 * (1 + p[1])), p[2]};
    };
    t.destroy = [](void* self) { delete static_cast<JaumannModel*>(self); };
    t.initial_state = [](void*, std::size_t n, const double* cauchy, double* out) -> std::int32_t {
      std::memcpy(out, cauchy, 9 * n * sizeof(double));
      return ASSAY_GOOD;
    };
    t.update = jaumann_detail::update;
    return t;
  }();
  return &table;
}

inline std::shared_ptr<const Material> jaumann_material(double breaks_at = 1e9) {
  return std::make_shared<const Material>(jaumann_table(), std::map<std::string, double>{{"breaks_at", breaks_at}});
}

}  // namespace assay
