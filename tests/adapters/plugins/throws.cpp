// SPDX-License-Identifier: BSD-3-Clause
// A C++ model that throws where the environment says: "update runtime_error", "create int", "entry bad_alloc".
#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

#include "harness/assay_material.h"

namespace {

void act(const std::string& when) {
  const char* asked = std::getenv("ASSAY_TEST_DEED");
  if (!asked) return;
  if (asked == when + " runtime_error") throw std::runtime_error("no root\nis found");
  if (asked == when + " bad_alloc") throw std::bad_alloc();
  if (asked == when + " int") throw 7;
}

const assay_parameter parameters[] = {{"K", "Pa", 1e3, 0, 1e12, "stiffness"}};
const assay_state_variable variables[] = {{"count", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};

void* create(const double* values, char* /*message*/) {
  act("create");
  return new double(values[0]);
}

void destroy(void* self) { delete static_cast<double*>(self); }

int32_t initial_state(void* /*self*/, size_t n, const double* /*cauchy*/, double* state) {
  act("begin");
  for (size_t p = 0; p < n; ++p) state[p] = 0;
  return ASSAY_GOOD;
}

/// K (b - I) / J.
void update(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
            int32_t* status, double* /*dt_factor*/, char* /*message*/) {
  static int calls = 0;
  if (++calls > 5) act("update");
  for (size_t p = 0; p < n; ++p) {
    const auto F = [&](int i, int j) { return step->F1[static_cast<size_t>(3 * i + j) * n + p]; };
    const double J = F(0, 0) * (F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)) -
                     F(0, 1) * (F(1, 0) * F(2, 2) - F(1, 2) * F(2, 0)) +
                     F(0, 2) * (F(1, 0) * F(2, 1) - F(1, 1) * F(2, 0));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        double b = i == j ? -1.0 : 0.0;
        for (int k = 0; k < 3; ++k) b += F(i, k) * F(j, k);
        cauchy[static_cast<size_t>(3 * i + j) * n + p] = *static_cast<double*>(self) * b / J;
      }
    }
    state1[p] = state0[p];
    status[p] = J > 0 ? ASSAY_GOOD : ASSAY_FAILED;
  }
}

assay_material table() {
  assay_material t = {};
  t.abi_major = ASSAY_ABI_MAJOR;
  t.struct_size = sizeof t;
  t.name = "throws", t.version = "0.1", t.licence = "BSD-3-Clause", t.doc = "throws exceptions";
  t.parameter_count = 1, t.parameters = parameters;
  t.state_count = 1, t.state = variables;
  t.create = create, t.destroy = destroy, t.initial_state = initial_state, t.update = update;
  return t;
}

}  // namespace

extern "C" ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static const assay_material all = table();
  act("entry");
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &all : nullptr;
}
