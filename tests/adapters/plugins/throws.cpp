// SPDX-License-Identifier: BSD-3-Clause
// A C++ model that throws where the environment says: "update runtime_error", "create int", "entry bad_alloc". It
// offers the extension whose function is named there: "rate fails" returns a failure, "rate null" has no function,
// "rate status" returns what is none of the ABI's, "rate overrun" writes beyond its results, "rate abort" ends there,
// "update waits" throws what never says what it is, "update unaligned" leaves the processor so.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include "harness/assay_material.h"

namespace {

struct Waits : std::exception {
  const char* what() const noexcept override {
    for (;;) pause();
  }
};

void act(const std::string& when) {
  const char* asked = std::getenv("ASSAY_TEST_DEED");
  if (!asked) return;
  if (asked == when + " runtime_error") throw std::runtime_error("no root\nis found");
  if (asked == when + " bad_alloc") throw std::bad_alloc();
  if (asked == when + " int") throw 7;
  if (asked == when + " abort") std::abort();
  if (asked == when + " waits") throw Waits();
#if defined(__x86_64__)
  if (asked == when + " unaligned") __asm__ volatile("pushfq; orq $0x40000, (%%rsp); popfq" ::: "cc", "memory");
#endif
}

/// Whether the environment names that function.
bool is_named(const std::string& function) {
  const char* asked = std::getenv("ASSAY_TEST_DEED");
  return asked && std::string(asked).starts_with(function + " ");
}

/// `size`: of its results.
int32_t acts_in(const std::string& function, double* results, size_t size) {
  act(function);
  const std::string asked = std::getenv("ASSAY_TEST_DEED");
  if (asked == function + " status") return 7;
  if (asked != function + " overrun") return ASSAY_FAILED;
  for (size_t k = 0; k <= size; ++k) results[k] = 0;
  return ASSAY_GOOD;
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
  if (is_named("reason")) return ASSAY_FAILED;
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

int32_t rate(void*, double, size_t n, const double*, const double*, const double*, const double*, double* found,
             double*) {
  return acts_in("rate", found, 9 * n);
}
int32_t tangent(void*, const assay_step*, size_t n, const double*, double* found) {
  return acts_in("tangent", found, 81 * n);
}
int32_t energy(void*, size_t n, const double*, const double*, double* found) { return acts_in("energy", found, n); }
int32_t wave_speed(void*, double, size_t n, const double*, const double*, const double*, double* found) {
  return acts_in("wave_speed", found, n);
}
int32_t tau(void*, int32_t, size_t n, const double*, double* found, double*) { return acts_in("tau", found, 9 * n); }
const char* reason(void*) {
  act("reason");
  return "";
}

const void* offered(const char* id) {
  static const assay_rate rates{
      sizeof rates, is_named("rate") && !std::strstr(std::getenv("ASSAY_TEST_DEED"), "null") ? rate : nullptr};
  static const assay_tangent tangents{sizeof tangents, tangent};
  static const assay_energy energies{sizeof energies, energy};
  static const assay_wave_speed speeds{sizeof speeds, wave_speed};
  static const assay_closed_form forms{sizeof forms, tau};
  static const assay_reason reasons{sizeof reasons, reason};
  const struct {
    const char *function, *id;
    const void* table;
  } all[] = {{"rate", ASSAY_EXTENSION_RATE, &rates},        {"tangent", ASSAY_EXTENSION_TANGENT, &tangents},
             {"energy", ASSAY_EXTENSION_ENERGY, &energies}, {"wave_speed", ASSAY_EXTENSION_WAVE_SPEED, &speeds},
             {"tau", ASSAY_EXTENSION_CLOSED_FORM, &forms},  {"reason", ASSAY_EXTENSION_REASON, &reasons}};
  for (const auto& each : all) {
    if (std::strcmp(id, each.id) == 0) return is_named(each.function) ? each.table : nullptr;
  }
  return nullptr;
}

const void* extension(const char* id) {
  act("extension");
  return offered(id);
}

const void* extension_of(const assay_material* /*table*/, const char* id) {
  act("extension_of");
  return offered(id);
}

void* create_of(const assay_material* /*table*/, const double* parameters, char* message) {
  act("create_of");
  return create(parameters, message);
}

assay_material table() {
  assay_material t = {};
  t.abi_major = ASSAY_ABI_MAJOR;
  t.struct_size = sizeof t;
  t.name = "throws", t.version = "0.1", t.licence = "BSD-3-Clause", t.doc = "throws exceptions";
  t.parameter_count = 1, t.parameters = parameters;
  t.state_count = 1, t.state = variables;
  t.create = create, t.destroy = destroy, t.initial_state = initial_state, t.update = update;
  t.extension = extension;
  if (is_named("extension_of")) t.extension_of = extension_of;
  if (is_named("create_of")) t.create_of = create_of;
  return t;
}

}  // namespace

extern "C" ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static const assay_material all = table();
  act("entry");
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &all : nullptr;
}
