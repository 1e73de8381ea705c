// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/arrays.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/harness/check/mutants.hpp"

namespace assay::check::test_arrays {
namespace {

const assay_material* inner = nullptr;
int calls = 0, better_aligned = 0;

void note(const void* array) {
  if (reinterpret_cast<std::uintptr_t>(array) % 16 != 8) ++better_aligned;
}

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double* factor, char* message) {
  ++calls;
  for (const void* array :
       {static_cast<const void*>(step->F0), static_cast<const void*>(step->F1), static_cast<const void*>(state0),
        static_cast<const void*>(state1), static_cast<const void*>(cauchy), static_cast<const void*>(status)}) {
    note(array);
  }
  inner->update(self, step, n, state0, state1, cauchy, status, factor, message);
}

// Loads of 16 bytes at once, which only a multiple of 16 bears, are met with what the contract promises: 8.
TEST(GuardedArrays, StandWhereNoMoreThanThePromisedAlignmentIs) {
  const std::vector<check_tests::Subject> subjects = check_tests::total_mutants::subjects();
  inner = &subjects.front().material.table();
  assay_material table = *inner;
  table.update = update;
  FirstCalls first;
  const TestResult result = guarded_arrays(Material(&table, {}), {}, first);
  EXPECT_EQ(result.verdict, Verdict::pass) << result.sentence;
  EXPECT_GT(calls, 100);
  EXPECT_EQ(better_aligned, 0);
}

double* own_parameters = nullptr;  ///< of the model, as create was given them

void* keep_parameters(const double* parameters, char* message) {
  own_parameters = const_cast<double*>(parameters);
  return inner->create(parameters, message);
}

void* write_parameters(const double* parameters, char* message) {
  void* made = keep_parameters(parameters, message);
  own_parameters[0] *= 2;
  return made;
}

void update_and_write_parameters(void* self, const assay_step* step, std::size_t n, const double* state0,
                                 double* state1, double* cauchy, std::int32_t* status, double* factor, char* message) {
  inner->update(self, step, n, state0, state1, cauchy, status, factor, message);
  own_parameters[0] = 7;
}

TEST(GuardedArrays, NamesAModelThatWritesIntoItsParameters) {
  const std::vector<check_tests::Subject> subjects = check_tests::total_mutants::subjects();
  inner = &subjects.front().material.table();
  for (const bool later : {false, true}) {
    assay_material table = *inner;
    table.create = later ? keep_parameters : write_parameters;
    if (later) table.update = update_and_write_parameters;
    FirstCalls first;
    const Material material(&table, {});
    const TestResult result = guarded_arrays(material, {}, first);
    EXPECT_EQ(result.verdict, Verdict::fail) << later;
    EXPECT_EQ(result.cause, causes::overrun);
    EXPECT_EQ(result.sentence, "it writes into the parameters that create is given");
    EXPECT_EQ(material.parameters(), Material(inner, {}).parameters()) << "what the host knows stays";
  }
}

void (*deed)(assay_step& step) = nullptr;

void update_and_write(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                      double* cauchy, std::int32_t* status, double* factor, char* message) {
  inner->update(self, step, n, state0, state1, cauchy, status, factor, message);
  deed(const_cast<assay_step&>(*step));
}

TEST(GuardedArrays, NamesAModelThatWritesIntoTheStep) {
  const std::vector<check_tests::Subject> subjects = check_tests::total_mutants::subjects();
  inner = &subjects.front().material.table();
  assay_material table = *inner;
  table.update = update_and_write;
  for (void (*each)(assay_step&) :
       {+[](assay_step& step) { step.dt = 1e3; }, +[](assay_step& step) { step.t += 1; },
        +[](assay_step& step) { step.F0 = nullptr; }, +[](assay_step& step) { step.F1 = step.F0; }}) {
    deed = each;
    FirstCalls first;
    const TestResult result = guarded_arrays(Material(&table, {}), {}, first);
    EXPECT_EQ(result.verdict, Verdict::fail);
    EXPECT_NE(result.sentence.find("changes the step that it gets"), std::string::npos) << result.sentence;
  }
}

}  // namespace
}  // namespace assay::check::test_arrays
