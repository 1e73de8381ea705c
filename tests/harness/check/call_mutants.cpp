// SPDX-License-Identifier: BSD-3-Clause
// Two good models, and what goes wrong around their equations: in batches, by addresses, by chance, in the last digits.
#include <time.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <deque>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::call_mutants {

namespace {

struct Call;
using Deed = void (*)(const Call& call);

/// A good model's table, and what is done to the answers of its update.
struct Disturbed : assay_material {
  const assay_material* inner = nullptr;
  Deed deed = nullptr;
};

struct Self {
  const Disturbed* table;
  void* inner;
  long calls = 0;
};

/// An answer that is given already.
struct Call {
  Self& self;
  const assay_step& step;
  std::size_t n;
  const double *state0, *state1;
  double* cauchy;

  void multiply(std::size_t p, double factor) const {
    for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] *= factor;
  }
  void multiply_all(double factor) const {
    for (std::size_t p = 0; p < n; ++p) multiply(p, factor);
  }
  void add_to_12(std::size_t p, double share) const {
    double largest = 0;
    for (std::size_t c = 0; c < 9; ++c) largest = std::max(largest, std::abs(cauchy[c * n + p]));
    cauchy[n + p] += share * largest;
  }
};

void* create(const assay_material* table, const double* parameters, char* message) {
  const auto* own = static_cast<const Disturbed*>(table);
  return new Self{own, create_instance(own->inner, parameters, message)};
}

void destroy(void* self) {
  auto* own = static_cast<Self*>(self);
  own->table->inner->destroy(own->inner);
  delete own;
}

std::int32_t initial_state(void* self, std::size_t n, const double* cauchy, double* state) {
  const auto* own = static_cast<Self*>(self);
  return own->table->inner->initial_state(own->inner, n, cauchy, state);
}

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double* dt_factor, char* message) {
  auto& own = *static_cast<Self*>(self);
  ++own.calls;
  own.table->inner->update(own.inner, step, n, state0, state1, cauchy, status, dt_factor, message);
  own.table->deed({own, *step, n, state0, state1, cauchy});
}

constexpr double one_per_cent = 1.01, last_digit = 1 + 2.3e-16;

std::uintptr_t address(const void* at) { return reinterpret_cast<std::uintptr_t>(at); }

// In batches.
void points_beyond_1500(const Call& c) {
  for (std::size_t p = 1500; p < c.n; ++p) c.multiply(p, one_per_cent);
}
void batches_beyond_2000(const Call& c) {
  if (c.n > 2000) c.multiply_all(one_per_cent);
}
void last_of_large_batches(const Call& c) {
  if (c.n > 3000) c.multiply(c.n - 1, one_per_cent);
}
void odd_batches(const Call& c) {
  if (c.n > 1 && c.n % 2 == 1) c.multiply_all(1 + 1e-10);
}
void neighbour_in_a_group(const Call& c) {
  for (std::size_t p = 3; p < c.n; p += 4) c.cauchy[p] = c.cauchy[p - 1];
}

/// Right: all but the points that are left are worked on by vectors of four.
void digits_of_vector_code(const Call& c) {
  for (std::size_t p = 0; p + 4 <= c.n; ++p) c.multiply(p, last_digit);
}

// By where arrays lie.
/// Right: likewise, from the first address that is a multiple of 32.
void digits_by_alignment(const Call& c) {
  if (address(c.step.F1) % 32 != 0) c.multiply_all(last_digit);
}
void arrays_of_16(const Call& c) {
  if (address(c.cauchy) % 16 != 0) c.multiply_all(one_per_cent);
}
void arrays_of_32(const Call& c) {
  if (address(c.step.F1) % 32 != 0) c.multiply_all(1 + 1e-10);
}
void states_of_64(const Call& c) {
  if (address(c.state0) % 64 == 0) c.multiply_all(one_per_cent);
}

// In the last digits.
void random_digit(const Call& c) {
  static std::uint32_t seed = 1;
  seed = seed * 1664525u + 1013904223u;
  if ((seed >> 30) == 0) c.multiply_all(last_digit);
}
void digit_of_the_clock(const Call& c) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  if ((now.tv_nsec >> 10) % 2 == 0) c.multiply_all(last_digit);
}
void digit_of_an_array_s_address(const Call& c) {
  if ((address(c.step.F1) >> 6) % 2 == 0) c.multiply_all(last_digit);
}
void digit_of_the_stack(const Call& c) {
  volatile char here = 0;
  if ((address(const_cast<const char*>(&here)) >> 6) % 2 == 0) c.multiply_all(last_digit);
}
void digit_of_the_instance(const Call& c) {
  if ((address(&c.self) >> 4) % 3 == 0) c.multiply_all(last_digit);
}
void digit_of_the_hundredth_call(const Call& c) {
  if (c.self.calls % 100 == 0) c.multiply_all(last_digit);
}
void digit_of_the_last_answer(const Call& c) {
  static double last = 0;
  if (last > 0) c.multiply_all(last_digit);
  last = c.cauchy[0];
}
void memory_that_was_never_set(const Call& c) {
  static void* (*volatile const allocate)(std::size_t) = std::malloc;
  auto* unset = static_cast<double*>(allocate(9 * sizeof(double)));
  if (unset[5] > 1e-6) c.multiply_all(last_digit);
  std::free(unset);
}

// Of one component of the deformation, whatever the frame.
void stiffer_in_shear_12(const Call& c) {
  for (std::size_t p = 0; p < c.n; ++p) c.multiply(p, 1 + 0.2 * std::abs(c.step.F1[c.n + p] + c.step.F1[3 * c.n + p]));
}

// Not symmetric.
void little_skew(const Call& c) {
  for (std::size_t p = 0; p < c.n; ++p) c.add_to_12(p, 1e-7);
}
void skew_in_unloading(const Call& c) {
  constexpr std::size_t p_at = 18;
  for (std::size_t p = 0; p < c.n; ++p) {
    const double flow = c.state1[p_at * c.n + p];
    if (flow > 0 && flow == c.state0[p_at * c.n + p]) c.add_to_12(p, 1e-6);
  }
}

const Subject& named(const std::vector<Subject>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Subject& subject) { return subject.name == name; });
}

/// Tables live as long as the process.
Subject disturbed(const Subject& good, const char* name, Deed deed, const std::string& cause) {
  static auto* const tables = new std::deque<Disturbed>;
  Disturbed* table = &tables->emplace_back();
  const assay_material& inner = good.material.table();
  static_cast<assay_material&>(*table) = inner;
  table->inner = &inner;
  table->deed = deed;
  table->create = nullptr;
  table->create_of = create;
  table->extension = nullptr;
  table->extension_of = nullptr;
  table->destroy = destroy;
  table->initial_state = initial_state;
  table->update = update;
  return {name, Material(table, good.material.named_parameters()), cause};
}

struct Planted {
  const char* name;
  Deed deed;
  std::string cause;
};

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  static const std::vector<Subject> totals = total_mutants::subjects(), increments = incremental_mutants::subjects();
  const std::vector<Planted> of_totals{{"digits_of_vector_code", digits_of_vector_code, ""},
                                       {"points_beyond_1500", points_beyond_1500, of_batch},
                                       {"last_of_large_batches", last_of_large_batches, of_batch},
                                       {"neighbour_in_a_group", neighbour_in_a_group, of_batch},
                                       {"arrays_of_16", arrays_of_16, of_alignment},
                                       {"states_of_64", states_of_64, of_alignment},
                                       {"random_digit", random_digit, not_reproducible},
                                       {"digit_of_an_array_s_address", digit_of_an_array_s_address, not_reproducible},
                                       {"digit_of_the_instance", digit_of_the_instance, not_reproducible},
                                       {"digit_of_the_last_answer", digit_of_the_last_answer, not_reproducible},
                                       {"memory_that_was_never_set", memory_that_was_never_set, not_reproducible},
                                       {"stiffer_in_shear_12", stiffer_in_shear_12, not_indifferent},
                                       {"little_skew", little_skew, not_symmetric}};
  const std::vector<Planted> of_increments{
      {"digits_by_alignment", digits_by_alignment, ""},
      {"batches_beyond_2000", batches_beyond_2000, of_batch},
      {"odd_batches", odd_batches, of_batch},
      {"arrays_of_32", arrays_of_32, of_alignment},
      {"digit_of_the_clock", digit_of_the_clock, not_reproducible},
      {"digit_of_the_stack", digit_of_the_stack, not_reproducible},
      {"digit_of_the_hundredth_call", digit_of_the_hundredth_call, not_reproducible},
      {"skew_in_unloading", skew_in_unloading, not_symmetric}};
  std::vector<Subject> all;
  for (const Planted& p : of_totals) all.push_back(disturbed(named(totals, "neo_hookean"), p.name, p.deed, p.cause));
  for (const Planted& p : of_increments) {
    all.push_back(disturbed(named(increments, "hughes_winget"), p.name, p.deed, p.cause));
  }
  return all;
}

}  // namespace assay::check_tests::call_mutants
