// SPDX-License-Identifier: BSD-3-Clause
// A built-in model whose answer goes wrong in some components of the stress on its way out: for tests.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/harness/builtin_material.hpp"

namespace assay {

/// What becomes of a Cauchy stress [Pa].
using Misreport = std::function<void(Tensor& sigma)>;

/// The model of a table under another name, with the state and the flags that it has and none of its extensions. Its
/// state is right, and each stress that it gives is misreported.
inline Material misreporting_material(const assay_material* original, const std::string& name, Misreport misreport,
                                      const std::map<std::string, double>& parameters) {
  struct Table : assay_material {
    std::string called;
    const assay_material* original;
    Misreport misreport;
  };
  struct Self {
    void* original;
    const Table* table;
  };
  static std::vector<std::unique_ptr<Table>> all;
  Table& t = *all.emplace_back(std::make_unique<Table>());
  static_cast<assay_material&>(t) = *original;
  t.called = name, t.original = original, t.misreport = std::move(misreport);
  t.name = t.called.c_str();
  t.create = nullptr;
  t.create_of = [](const assay_material* table, const double* p, char* message) -> void* {
    const Table& own = *static_cast<const Table*>(table);
    void* made = create_instance(own.original, p, message);
    return made ? new Self{made, &own} : nullptr;
  };
  t.destroy = [](void* self) {
    const Self& own = *static_cast<Self*>(self);
    own.table->original->destroy(own.original);
    delete static_cast<Self*>(self);
  };
  t.extension = nullptr;
  t.extension_of = nullptr;
  if (original->initial_state) {
    t.initial_state = [](void* self, std::size_t n, const double* cauchy, double* state) {
      const Self& own = *static_cast<Self*>(self);
      return own.table->original->initial_state(own.original, n, cauchy, state);
    };
  }
  t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
                std::int32_t* status, double* dt_factor, char* message) {
    const Self& own = *static_cast<Self*>(self);
    own.table->original->update(own.original, step, n, state0, state1, cauchy, status, dt_factor, message);
    for (std::size_t p = 0; p < n; ++p) {
      Tensor sigma = tensor_at(cauchy, n, p);
      own.table->misreport(sigma);
      put_tensor(sigma, cauchy, n, p);
    }
  };
  return Material(&t, parameters);
}

}  // namespace assay
