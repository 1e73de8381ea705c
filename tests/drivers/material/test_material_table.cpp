// SPDX-License-Identifier: BSD-3-Clause
// From descriptions to tables, in this process and in workers.
#include "drivers/material/registry.hpp"

#include <gtest/gtest.h>

#include "adapters/worker/remote_table.hpp"
#include "harness/material/material.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_material_table {
namespace {

const std::string norton = built("tests/foreign/mfront_norton.so");
const std::string file = "/folder/creep.yaml";

class MaterialTable : public RegistryTest {
 protected:
  void TearDown() override {
    adapters::end_workers();
    RegistryTest::TearDown();
  }
  static MaterialDescription of_norton(const std::string& keys) {
    return read_description("library: " + norton + "\ninterface: mfront\n" + keys, file);
  }
  static std::string refused(const std::string& keys, Isolation isolation) {
    return refusal_of([&] { source_of(of_norton(keys), file, isolation); });
  }
};

TEST_F(MaterialTable, ForeignModelsRunApartUnlessToldOtherwise) {
  const MaterialDescription foreign = of_norton("");
  MaterialDescription native;
  native.library = plugins + "anisotropic.so";
  const auto ran = [](const MaterialDescription& d, Isolation i) { return source_of(d, file, i).isolation; };
  EXPECT_EQ(ran(foreign, Isolation::automatic), Isolation::worker);
  EXPECT_EQ(ran(foreign, Isolation::none), Isolation::none);
  EXPECT_EQ(ran(native, Isolation::automatic), Isolation::none);
  EXPECT_EQ(ran(native, Isolation::worker), Isolation::worker);
}

TEST_F(MaterialTable, OfAWorkerIsTheOneOfThisProcess) {
  const MaterialDescription description = of_norton("name: creep\nproperties: {A: 1e-3, n: 2}\nflags: [non_smooth]\n");
  const MaterialSource here = source_of(description, file, Isolation::none),
                       there = source_of(description, file, Isolation::worker);
  EXPECT_STREQ(there.table->name, "creep");
  EXPECT_STREQ(there.table->version, here.table->version);
  EXPECT_EQ(there.table->flags | ASSAY_THREAD_SAFE, here.table->flags | ASSAY_THREAD_SAFE);
  ASSERT_EQ(there.table->parameter_count, here.table->parameter_count);
  for (std::uint32_t k = 0; k < here.table->parameter_count; ++k) {
    const assay_parameter &a = here.table->parameters[k], &b = there.table->parameters[k];
    EXPECT_STREQ(a.name, b.name);
    EXPECT_TRUE(a.default_value == b.default_value || (a.default_value != a.default_value)) << a.name;
    EXPECT_EQ(a.lower, b.lower);
  }
  ASSERT_EQ(there.table->state_count, here.table->state_count);
  for (std::uint32_t k = 0; k < here.table->state_count; ++k) {
    EXPECT_STREQ(there.table->state[k].name, here.table->state[k].name);
    EXPECT_EQ(there.table->state[k].kind, here.table->state[k].kind);
    EXPECT_EQ(there.table->state[k].role, here.table->state[k].role);
  }
  EXPECT_TRUE(there.foreign);
  EXPECT_EQ(there.library, norton);
}

TEST_F(MaterialTable, ComplaintsStandAtTheSameKeyWhereverTheModelRuns) {
  for (const Isolation isolation : {Isolation::none, Isolation::worker}) {
    EXPECT_TRUE(refused("properties: {Young: 1}\n", isolation)
                    .starts_with(file + ":3:21: properties.Young: behaviour 'Norton' has no such property; known: "
                                        "YoungModulus, PoissonRatio, A, n"));
    EXPECT_TRUE(refused("symbol: Creep\n", isolation)
                    .starts_with(file + ":3:9: symbol: the library has no behaviour 'Creep'; known: Norton"));
    EXPECT_TRUE(refused("state: {q: scalar}\n", isolation)
                    .starts_with(file + ":3:12: state.q: the behaviour has no such state variable; known: Elastic"));
    EXPECT_TRUE(refused("state: {ElasticStrain: {initial: [1, 2]}}\n", isolation)
                    .starts_with(file + ":3:24: state.ElasticStrain: has 6 components, found 2"));
  }
}

TEST_F(MaterialTable, InitialValuesReachTheModelFromEveryProcess) {
  const std::string keys =
      "properties: {YoungModulus: 1e3, PoissonRatio: 0.3}\n"
      "state: {ElasticStrain: {initial: [1, 2, 3, 4, 5, 6]}}\n";
  for (const Isolation isolation : {Isolation::none, Isolation::worker}) {
    const Material material(source_of(of_norton(keys), file, isolation).table, {});
    const std::vector<double> state = material.initial_state(1);
    ASSERT_EQ(state.size(), 15u);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(state[8 + k], static_cast<double>(k + 1));
  }
}

TEST_F(MaterialTable, AFileNamedInTwoLinesIsAFile) {
  const MaterialSource source = source_of(of_norton(""), "/folder/two\nlines.yaml", Isolation::worker);
  EXPECT_STREQ(source.table->name, "creep");
}

TEST_F(MaterialTable, ADescriptionTooLongForAWorkerIsBadInput) {
  std::string keys;
  for (int k = 0; k < 5; ++k) keys += (k ? ", s" : "state: {s") + std::to_string(k) + ": {count: 10000}";
  const std::string found = refusal_of([&] {
    source_of(read_description("library: " + norton + "\ninterface: umat\n" + keys + "}\n", file), file,
              Isolation::worker);
  });
  EXPECT_TRUE(found.starts_with(file + ":1:10: library: the description is too long for a worker")) << found;
}

}  // namespace
}  // namespace assay::drivers::test_material_table
