// SPDX-License-Identifier: BSD-3-Clause
// From a C++ class to an ABI table. A model of this folder is a class with
//
//   static constexpr const char *name, *doc;   static constexpr int symmetry;   static constexpr std::uint32_t flags;
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

#include <iterator>

#include "adapters/models/plugin_functions.hpp"

namespace assay::models {

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
    t.symmetry = Model::symmetry;
    t.flags = Model::flags | ASSAY_THREAD_SAFE;
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
