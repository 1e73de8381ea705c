// SPDX-License-Identifier: BSD-3-Clause
// A polytropic gas as a plug-in in C++: sigma = -(p0 J^-gamma - p0) I, stress-free at rest.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>

#include "harness/assay_material.h"

namespace {

struct Gas {
  double pressure, exponent;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
const assay_parameter parameters[] = {
    {"p0", "Pa", 1e5, 0.0, infinity, "pressure at rest"},
    {"gamma", "1", 1.4, 1.0, 10.0, "exponent"},
};

void* create(const double* p, char*) { return new (std::nothrow) Gas{p[0], p[1]}; }

void destroy(void* self) { delete static_cast<Gas*>(self); }

double determinant(const double* F, std::size_t n) {
  const auto f = [=](int i, int j) { return F[static_cast<std::size_t>(3 * i + j) * n]; };
  return f(0, 0) * (f(1, 1) * f(2, 2) - f(1, 2) * f(2, 1)) - f(0, 1) * (f(1, 0) * f(2, 2) - f(1, 2) * f(2, 0)) +
         f(0, 2) * (f(1, 0) * f(2, 1) - f(1, 1) * f(2, 0));
}

void update(void* self, const assay_step* step, std::size_t n, const double*, double*, double* cauchy,
            std::int32_t* status, double*, char*) {
  const Gas& gas = *static_cast<const Gas*>(self);
  std::memset(cauchy, 0, 9 * n * sizeof *cauchy);
  for (std::size_t p = 0; p < n; ++p) {
    const double J = determinant(step->F1 + p, n);
    const double excess = gas.pressure * (std::pow(J, -gas.exponent) - 1);
    for (std::size_t c = 0; c < 9; c += 4) cauchy[c * n + p] = -excess;
    status[p] = J > 0 ? ASSAY_GOOD : ASSAY_FAILED;
  }
}

const assay_material table = [] {
  assay_material m{};
  m.abi_major = ASSAY_ABI_MAJOR;
  m.struct_size = sizeof m;
  m.name = "downstream_ideal_gas";
  m.version = "1.0";
  m.licence = "BSD-3-Clause";
  m.doc = "polytropic gas";
  m.symmetry = ASSAY_ISOTROPIC;
  m.flags = ASSAY_THREAD_SAFE;
  m.parameter_count = 2;
  m.parameters = parameters;
  m.create = create;
  m.destroy = destroy;
  m.update = update;
  return m;
}();

}  // namespace

extern "C" ASSAY_EXPORT const assay_material* assay_material_entry(std::uint32_t host_major, std::uint32_t index) {
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : nullptr;
}
