// SPDX-License-Identifier: BSD-3-Clause
// From a C++ class to an ABI table. A model of this folder is a class with
//
//   static constexpr const char *name, *doc;                 static constexpr int symmetry;   (default: isotropic)
//   static constexpr std::uint32_t flags;   (default: none)
//   static constexpr assay_parameter parameters[];          static constexpr assay_state_variable state[];  (optional)
//   explicit Model(const double* parameters);                                     throws Failure where they do not fit
//   template <class S> TensorOf<S> update(const IncrementOf<S>&, const double* state0, S* state1) const;
//                                                            Cauchy stress [Pa]; throws Failure where it cannot go on
// and, where they exist,
//   void initial_state(const Tensor& cauchy, double* state) const;                                  default: all zero
//   void rate(double t, const Tensor& F, const Tensor& l, const Tensor& cauchy, const double* state,
//             Tensor& cauchy_rate, double* state_rate) const;
//   double energy(const Tensor& F, const double* state) const;
//   double wave_speed(double density, const Tensor& F, const Tensor& cauchy, const double* state) const;
//   bool closed_form(int baseline, double eps, Tensor& tau, Tensor& dtau_deps) const;
//
// The tangent d cauchy / d F1 comes from `update` itself by automatic differentiation.
#pragma once

#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>

#include "adapters/models/tensor_functions.hpp"
#include "harness/assay_material.h"

namespace assay::models {

/// Why a model cannot go on, in a few words.
struct Failure {
  const char* reason;
};

/// Of a model that cannot begin otherwise.
inline void require_stress_free(const Tensor& cauchy) {
  if (!cauchy.isZero(0)) throw Failure{"this model starts free of stress"};
}

/// One step of one point.
template <class S>
struct IncrementOf {
  double t, dt;
  Tensor F0;
  TensorOf<S> F1;
};

inline constexpr int components_of_kind[] = {1, 3, 6, 9};

template <class Model>
constexpr int state_components() {
  int sum = 0;
  if constexpr (requires { Model::state; }) {
    for (const assay_state_variable& variable : Model::state) sum += components_of_kind[variable.kind];
  }
  return sum;
}

namespace detail {

inline Tensor tensor_at(const double* a, std::size_t n, std::size_t p) {
  Tensor A;
  for (std::size_t c = 0; c < 9; ++c) A(static_cast<int>(c / 3), static_cast<int>(c % 3)) = a[c * n + p];
  return A;
}

inline void put_tensor(const Tensor& A, double* a, std::size_t n, std::size_t p) {
  for (std::size_t c = 0; c < 9; ++c) a[c * n + p] = A(static_cast<int>(c / 3), static_cast<int>(c % 3));
}

/// Calls `body`; a failure becomes a status and, where there is room for one, a message.
std::int32_t guarded(char* message, const auto& body) noexcept {
  try {
    body();
    return ASSAY_GOOD;
  } catch (const Failure& failure) {
    if (message) std::snprintf(message, ASSAY_MESSAGE_SIZE, "%s", failure.reason);
  } catch (const std::exception& error) {
    if (message) std::snprintf(message, ASSAY_MESSAGE_SIZE, "%s", error.what());
  }
  return ASSAY_FAILED;
}

/// body(p) for each of n points; without a message.
std::int32_t each_point(std::size_t n, const auto& body) noexcept {
  return guarded(nullptr, [&] {
    for (std::size_t p = 0; p < n; ++p) body(p);
  });
}

template <class Model>
struct Functions {
  static constexpr std::size_t states = static_cast<std::size_t>(state_components<Model>());
  using State = std::array<double, states + 1>;  // one more: never empty

  static State state_at(const double* a, std::size_t n, std::size_t p) {
    State state{};
    for (std::size_t c = 0; c < states; ++c) state[c] = a[c * n + p];
    return state;
  }

  static void put_state(const State& state, double* a, std::size_t n, std::size_t p) {
    for (std::size_t c = 0; c < states; ++c) a[c * n + p] = state[c];
  }

  static const Model& model(void* self) { return *static_cast<const Model*>(self); }

  static void* create(const double* parameters, char* message) {
    Model* made = nullptr;
    guarded(message, [&] { made = new Model(parameters); });
    return made;
  }

  static void destroy(void* self) { delete static_cast<Model*>(self); }

  static std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
    return each_point(n, [&](std::size_t p) {
      State point{};
      const Tensor sigma = tensor_at(cauchy, n, p);
      if constexpr (requires { model(self).initial_state(sigma, point.data()); }) {
        model(self).initial_state(sigma, point.data());
      } else {
        require_stress_free(sigma);
      }
      put_state(point, state, n, p);
    });
  }

  static void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                     double* cauchy, std::int32_t* status, double*, char* message) {
    bool failed = false;  // the message is the first failed point's
    for (std::size_t p = 0; p < n; ++p) {
      const State before = state_at(state0, n, p);
      State after = before;
      Tensor sigma = Tensor::Zero();
      status[p] = guarded(failed ? nullptr : message, [&] {
        const IncrementOf<double> increment{step->t, step->dt, tensor_at(step->F0, n, p), tensor_at(step->F1, n, p)};
        if (!(determinant(increment.F1) > 0)) throw Failure{"det F <= 0"};
        sigma = model(self).template update<double>(increment, before.data(), after.data());
      });
      failed = failed || status[p] == ASSAY_FAILED;
      put_tensor(sigma, cauchy, n, p);
      put_state(after, state1, n, p);
    }
  }

  static std::int32_t tangent(void* self, const assay_step* step, std::size_t n, const double* state0, double* out) {
    using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 9, 1>>;
    return each_point(n, [&](std::size_t p) {
      const State before = state_at(state0, n, p);
      std::array<Dual, states + 1> after;
      for (std::size_t c = 0; c < states; ++c) after[c] = Dual(before[c]);
      IncrementOf<Dual> increment{step->t, step->dt, tensor_at(step->F0, n, p), {}};
      const Tensor F1 = tensor_at(step->F1, n, p);
      for (int j = 0; j < 9; ++j) increment.F1(j / 3, j % 3) = Dual(F1(j / 3, j % 3), 9, j);
      const TensorOf<Dual> sigma = model(self).template update<Dual>(increment, before.data(), after.data());
      for (std::size_t i = 0; i < 9; ++i) {
        const auto& slope = sigma(static_cast<int>(i / 3), static_cast<int>(i % 3)).derivatives();
        for (std::size_t j = 0; j < 9; ++j) out[(9 * i + j) * n + p] = slope(static_cast<int>(j));
      }
    });
  }

  static std::int32_t rate(void* self, double t, std::size_t n, const double* F, const double* l, const double* cauchy,
                           const double* state, double* cauchy_rate, double* state_rate) {
    return each_point(n, [&](std::size_t p) {
      const State now = state_at(state, n, p);
      State slope{};
      Tensor sigma_rate = Tensor::Zero();
      model(self).rate(t, tensor_at(F, n, p), tensor_at(l, n, p), tensor_at(cauchy, n, p), now.data(), sigma_rate,
                       slope.data());
      put_tensor(sigma_rate, cauchy_rate, n, p);
      put_state(slope, state_rate, n, p);
    });
  }

  static std::int32_t energy(void* self, std::size_t n, const double* F, const double* state, double* W) {
    return each_point(
        n, [&](std::size_t p) { W[p] = model(self).energy(tensor_at(F, n, p), state_at(state, n, p).data()); });
  }

  static std::int32_t wave_speed(void* self, double density, std::size_t n, const double* F, const double* cauchy,
                                 const double* state, double* speed) {
    return each_point(n, [&](std::size_t p) {
      speed[p] =
          model(self).wave_speed(density, tensor_at(F, n, p), tensor_at(cauchy, n, p), state_at(state, n, p).data());
    });
  }

  static std::int32_t closed_form(void* self, std::int32_t baseline, std::size_t n, const double* eps, double* tau,
                                  double* dtau) {
    bool exists = true;
    const std::int32_t status = each_point(n, [&](std::size_t p) {
      Tensor value = Tensor::Zero(), slope = Tensor::Zero();
      exists = exists && model(self).closed_form(baseline, eps[p], value, slope);
      put_tensor(value, tau, n, p);
      put_tensor(slope, dtau, n, p);
    });
    return exists ? status : ASSAY_FAILED;
  }

  static const void* extension(const char* id) {
    const auto is = [&](const char* known) { return std::strcmp(id, known) == 0; };
    static const assay_tangent tangent_table{sizeof(assay_tangent), tangent};
    if (is(ASSAY_EXTENSION_TANGENT)) return &tangent_table;
    if constexpr (requires { &Model::rate; }) {
      static const assay_rate rate_table{sizeof(assay_rate), rate};
      if (is(ASSAY_EXTENSION_RATE)) return &rate_table;
    }
    if constexpr (requires { &Model::energy; }) {
      static const assay_energy energy_table{sizeof(assay_energy), energy};
      if (is(ASSAY_EXTENSION_ENERGY)) return &energy_table;
    }
    if constexpr (requires { &Model::wave_speed; }) {
      static const assay_wave_speed speed_table{sizeof(assay_wave_speed), wave_speed};
      if (is(ASSAY_EXTENSION_WAVE_SPEED)) return &speed_table;
    }
    if constexpr (requires { Model::example; }) {
      static_assert(std::size(Model::example) == std::size(Model::parameters));
      static const assay_example example_table{sizeof(assay_example), Model::example};
      if (is(ASSAY_EXTENSION_EXAMPLE)) return &example_table;
    }
    if constexpr (requires { Model::material_class; }) {
      static const assay_symmetry symmetry_table{sizeof(assay_symmetry), Model::material_class};
      if (is(ASSAY_EXTENSION_SYMMETRY)) return &symmetry_table;
    }
    if constexpr (requires { &Model::closed_form; }) {
      static const assay_closed_form form_table{sizeof(assay_closed_form), closed_form};
      if (is(ASSAY_EXTENSION_CLOSED_FORM)) return &form_table;
    }
    return nullptr;
  }
};

}  // namespace detail

/// The table of a model.
template <class Model>
const assay_material& table_of() {
  using Functions = detail::Functions<Model>;
  static const assay_material table = [] {
    assay_material t{};
    t.abi_major = ASSAY_ABI_MAJOR;
    t.struct_size = sizeof(assay_material);
    t.name = Model::name;
    t.version = "1.0";
    t.licence = "BSD-3-Clause";
    t.doc = Model::doc;
    t.symmetry = ASSAY_ISOTROPIC;
    if constexpr (requires { Model::symmetry; }) t.symmetry = Model::symmetry;
    t.flags = ASSAY_THREAD_SAFE;
    if constexpr (requires { Model::flags; }) t.flags |= Model::flags;
    t.parameter_count = static_cast<std::uint32_t>(std::size(Model::parameters));
    t.parameters = Model::parameters;
    if constexpr (requires { Model::state; }) {
      t.state_count = static_cast<std::uint32_t>(std::size(Model::state));
      t.state = Model::state;
      t.initial_state = Functions::initial_state;
    }
    t.create = Functions::create;
    t.destroy = Functions::destroy;
    t.update = Functions::update;
    t.extension = Functions::extension;
    return t;
  }();
  return table;
}

}  // namespace assay::models

/// The entry assay_builtin_NAME of one model, by which the program and the library of this one model find it.
#define ASSAY_MODEL(MODEL, NAME)                                                                        \
  extern "C" const assay_material* assay_builtin_##NAME(std::uint32_t host_major, std::uint32_t index); \
  const assay_material* assay_builtin_##NAME(std::uint32_t host_major, std::uint32_t index) {           \
    return host_major == ASSAY_ABI_MAJOR && index == 0 ? &assay::models::table_of<MODEL>() : nullptr;   \
  }
