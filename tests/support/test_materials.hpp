// SPDX-License-Identifier: BSD-3-Clause
// Materials as ABI tables, for tests of whatever drives a material.
#pragma once

#include <Eigen/LU>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <set>
#include <thread>

#include "harness/assay_material.h"
#include "harness/numeric/tensor.hpp"

namespace assay::test_materials {

inline Tensor tensor_at(const double* a, std::size_t n, std::size_t p) {
  Tensor tensor;
  for (int c = 0; c < 9; ++c) component(tensor, c) = a[static_cast<std::size_t>(c) * n + p];
  return tensor;
}

/// Hypoelastic, Hughes-Winget: sigma <- Q sigma Q^T + lambda tr(D dt) I + 2 mu D dt at the mid-step configuration,
/// Q = (I - W dt/2)^-1 (I + W dt/2). Keeps its stress in the state, reads F0 and F1.
namespace hypoelastic {

inline constexpr double lambda = 400, mu = 300;
inline constexpr int places[6] = {0, 4, 8, 1, 2, 5};  // of 11, 22, 33, 12, 13, 23 among the nine components

inline Tensor stress_of(const double* state, std::size_t n, std::size_t p) {
  Tensor sigma;
  for (int k = 0; k < 6; ++k) {
    const int c = places[k];
    sigma(c / 3, c % 3) = sigma(c % 3, c / 3) = state[static_cast<std::size_t>(k) * n + p];
  }
  return sigma;
}

inline Tensor advanced(const Tensor& sigma, const Tensor& F0, const Tensor& F1) {
  const Tensor increment = (F1 - F0) * (0.5 * (F0 + F1)).inverse();
  const Tensor D = 0.5 * (increment + increment.transpose()), W = 0.5 * (increment - increment.transpose());
  const Tensor one = Tensor::Identity();
  const Tensor Q = (one - 0.5 * W).inverse() * (one + 0.5 * W);
  return Q * sigma * Q.transpose() + lambda * D.trace() * one + 2 * mu * D;
}

inline void update(void*, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
                   std::int32_t* status, double*, char*) {
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor sigma = advanced(stress_of(state0, n, p), tensor_at(step->F0, n, p), tensor_at(step->F1, n, p));
    for (int c = 0; c < 9; ++c) cauchy[static_cast<std::size_t>(c) * n + p] = component(sigma, c);
    for (int k = 0; k < 6; ++k) state1[static_cast<std::size_t>(k) * n + p] = component(sigma, places[k]);
    status[p] = ASSAY_GOOD;
  }
}

inline std::int32_t initial_state(void*, std::size_t n, const double* cauchy, double* state) {
  for (int k = 0; k < 6; ++k) {
    std::memcpy(state + static_cast<std::size_t>(k) * n, cauchy + static_cast<std::size_t>(places[k]) * n,
                n * sizeof(double));
  }
  return ASSAY_GOOD;
}

inline const assay_state_variable state[] = {
    {"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress"}};

}  // namespace hypoelastic

/// sigma = F - I; where F11 exceeds a limit, the point misbehaves in its own way. Counts its instances and which
/// threads come to each of them.
namespace moody {

enum class Mood { good, refuses, not_finite };
inline std::atomic<Mood> mood{Mood::good};
inline constexpr double limit = 2;  ///< of F11

struct Visit {
  void* self;
  std::thread::id thread;
  auto operator<=>(const Visit&) const = default;
};
inline std::mutex guard;
inline std::set<Visit> visits;
inline std::atomic<int> created{0};

inline void reset(Mood now) {
  mood = now;
  created = 0;
  visits.clear();
}

inline void* create(const double*, char*) {
  ++created;
  return new char;
}
inline void destroy(void* self) { delete static_cast<char*>(self); }

inline void update(void* self, const assay_step* step, std::size_t n, const double*, double*, double* cauchy,
                   std::int32_t* status, double*, char* message) {
  {
    const std::lock_guard lock(guard);
    visits.insert({self, std::this_thread::get_id()});
  }
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = step->F1[c * n + p] - (c % 4 == 0 ? 1 : 0);
    status[p] = ASSAY_GOOD;
    if (!(step->F1[p] > limit)) continue;
    if (mood == Mood::not_finite) cauchy[4 * n + p] = std::numeric_limits<double>::quiet_NaN();
    if (mood == Mood::refuses) {
      status[p] = ASSAY_FAILED;
      std::strcpy(message, "stretched too far");
    }
  }
}

}  // namespace moody

namespace detail {

inline assay_material table(const char* name) {
  assay_material t{};
  t.abi_major = ASSAY_ABI_MAJOR;
  t.struct_size = sizeof(assay_material);
  t.name = name;
  t.version = "0.1";
  t.licence = "BSD-3-Clause";
  t.doc = "test model";
  t.create = [](const double*, char*) -> void* { return new char; };
  t.destroy = [](void* self) { delete static_cast<char*>(self); };
  return t;
}

}  // namespace detail

inline const assay_material* hypoelastic_table() {
  static const assay_material table = [] {
    assay_material t = detail::table("hypoelastic");
    t.flags = ASSAY_THREAD_SAFE | ASSAY_USES_INCREMENT;
    t.state_count = 1;
    t.state = hypoelastic::state;
    t.initial_state = hypoelastic::initial_state;
    t.update = hypoelastic::update;
    return t;
  }();
  return &table;
}

/// Not thread-safe unless asked for.
inline const assay_material* moody_table(bool thread_safe = false) {
  static const auto make = [](std::uint32_t flags) {
    assay_material t = detail::table("moody");
    t.flags = flags;
    t.create = moody::create;
    t.destroy = moody::destroy;
    t.update = moody::update;
    return t;
  };
  static const assay_material plain = make(0), safe = make(ASSAY_THREAD_SAFE);
  return thread_safe ? &safe : &plain;
}

}  // namespace assay::test_materials
