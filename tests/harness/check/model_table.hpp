// SPDX-License-Identifier: BSD-3-Clause
// What the models of these tests share: tensors in arrays, the table of a model of single points, and what a library
// keeps in statics.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "harness/check/stiffness.hpp"
#include "harness/material/state_variable.hpp"
#include "tests/harness/check/mutants.hpp"

namespace assay::check_tests {

using assay::sheared;

/// 13 and 23 in each other's place.
inline Tensor exchanged(const Tensor& A) { return check::in_order({0, 2, 1}, A); }

/// Nine components of point p of n.
inline Tensor read(const double* a, std::size_t n, std::size_t p, std::size_t first = 0) {
  Tensor A;
  for (std::size_t c = 0; c < 9; ++c) component(A, static_cast<int>(c)) = a[(first + c) * n + p];
  return A;
}

inline void write(const Tensor& A, double* a, std::size_t n, std::size_t p, std::size_t first = 0) {
  for (std::size_t c = 0; c < 9; ++c) a[(first + c) * n + p] = component(A, static_cast<int>(c));
}

/// A symmetric tensor of the state of a single point.
inline Tensor read_symmetric(const double* six) { return Variable(ASSAY_SYMMETRIC_TENSOR, six).value(); }

inline void write_symmetric(const Tensor& A, double* six) {
  constexpr int places[] = {0, 4, 8, 1, 2, 5};
  for (int c = 0; c < 6; ++c) six[c] = component(A, places[c]);
}

inline Tensor deviator(const Tensor& A) { return A - A.trace() / 3 * Tensor::Identity(); }
inline Tensor sphere(const Tensor& A) { return A.trace() / 3 * Tensor::Identity(); }

/// The rotation of F, by Newton's iteration with Higham's scaling.
inline Tensor polar(const Tensor& F) {
  constexpr int always_enough = 30;
  Tensor R = F;
  for (int k = 0; k < always_enough; ++k) {
    const Tensor S = R.inverse().transpose();
    const double scale = std::sqrt(S.norm() / R.norm());
    const Tensor next = 0.5 * (scale * R + S / scale);
    const double change = (next - R).norm();
    R = next;
    if (change < 1e-8) break;  // squared by the step just taken
  }
  return R;
}

/// Of the symmetric part of a positive definite tensor.
inline Tensor logarithm(const Tensor& A) {
  const Eigen::SelfAdjointEigenSolver<Tensor> eigen(0.5 * (A + A.transpose()));
  return eigen.eigenvectors() * eigen.eigenvalues().array().log().matrix().asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Rotations by a skew tensor.
inline Tensor cayley(const Tensor& w) {
  const Tensor I = Tensor::Identity();
  return (I - 0.5 * w).inverse() * (I + 0.5 * w);
}

inline Tensor exponential(const Tensor& w) {
  const Vector3 axis(w(2, 1), w(0, 2), w(1, 0));
  const double angle = axis.norm();
  return angle > 0 ? Tensor(Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix()) : Tensor(Tensor::Identity());
}

/// What the mutants of these tests keep in statics. A test begins with none of it: `as_in_a_new_process`.
struct Statics {
  bool called = false;
  double largest = 0;
  std::map<std::size_t, Tensor> of_point;
};
inline Statics statics;

/// A step of one point.
struct PointStep {
  double t, dt;
  Tensor F0, F1;
};

/// The functions of a Model that knows single points:
///   static constexpr std::size_t state_size;
///   std::optional<Tensor> take(const PointStep&, const double* state0, double* state1);   none: failed
///   bool rest(const Tensor& cauchy, double* state);
///   void misbehave(std::size_t n, double* state1, double* cauchy);                         after each batch
template <class Model>
struct Calls {
  static constexpr std::size_t size = Model::state_size;
  using State = std::array<double, size + 1>;  // one more: none is no array

  static PointStep step_of(const assay_step& step, std::size_t n, std::size_t p) {
    return {step.t, step.dt, read(step.F0, n, p), read(step.F1, n, p)};
  }

  static State state_of(const double* state, std::size_t n, std::size_t p) {
    State own{};
    for (std::size_t c = 0; c < size; ++c) own[c] = state[c * n + p];
    return own;
  }

  static void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                     double* cauchy, std::int32_t* status, double*, char*) {
    auto& model = *static_cast<Model*>(self);
    for (std::size_t p = 0; p < n; ++p) {
      const State before = state_of(state0, n, p);
      State after = before;
      const std::optional<Tensor> sigma = model.take(step_of(*step, n, p), before.data(), after.data());
      status[p] = sigma ? ASSAY_GOOD : ASSAY_FAILED;
      write(sigma.value_or(Tensor::Zero()), cauchy, n, p);
      for (std::size_t c = 0; c < size; ++c) state1[c * n + p] = after[c];
    }
    model.misbehave(n, state1, cauchy);
  }

  static std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
    std::int32_t all = ASSAY_GOOD;
    for (std::size_t p = 0; p < n; ++p) {
      State own{};
      if (!static_cast<Model*>(self)->rest(read(cauchy, n, p), own.data())) all = ASSAY_FAILED;
      for (std::size_t c = 0; c < size; ++c) state[c * n + p] = own[c];
    }
    return all;
  }
};

/// A table without functions.
inline assay_material named_table(const char* name, std::uint32_t flags, std::span<const assay_parameter> parameters,
                                  std::span<const assay_state_variable> state) {
  assay_material t{};
  t.abi_major = ASSAY_ABI_MAJOR;
  t.struct_size = sizeof t;
  t.name = name;
  t.version = t.licence = t.doc = "";
  t.symmetry = ASSAY_ISOTROPIC;
  t.flags = flags;
  t.parameter_count = static_cast<std::uint32_t>(parameters.size());
  t.parameters = parameters.data();
  t.state_count = static_cast<std::uint32_t>(state.size());
  t.state = state.data();
  return t;
}

template <class Model>
assay_material table_of(const char* name, std::uint32_t flags, std::span<const assay_parameter> parameters,
                        std::span<const assay_state_variable> state) {
  assay_material t = named_table(name, flags, parameters, state);
  t.create = [](const double* values, char*) -> void* { return new Model(values); };
  t.destroy = [](void* self) { delete static_cast<Model*>(self); };
  if (Model::state_size > 0) t.initial_state = Calls<Model>::initial_state;
  t.update = Calls<Model>::update;
  return t;
}

/// Name, value of the parameter `defect`, and what the battery must say.
using Planted = std::vector<std::tuple<const char*, int, std::string>>;

/// One subject each.
inline void add(std::vector<Subject>& subjects, const assay_material* table, const Planted& planted,
                const std::map<std::string, double>& parameters = {}) {
  for (const auto& [name, defect, cause] : planted) {
    std::map<std::string, double> values = parameters;
    values["defect"] = defect;
    subjects.push_back({name, Material(table, values), cause});
  }
}

}  // namespace assay::check_tests
