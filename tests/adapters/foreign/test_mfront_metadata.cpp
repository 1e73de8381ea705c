// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/mfront_metadata.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "adapters/foreign/foreign_table.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_mfront_metadata {
namespace {

MfrontBehaviour behaviour_of(const std::string& library, const std::string& name) {
  void* handle = dlopen(double_library(library).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(dlerror());
  return mfront_behaviour(handle, name, mfront_behaviours(double_library(library)));
}

TEST(MfrontMetadata, NamesTheBehavioursOfALibrary) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(mfront_behaviours(double_library("mfront_norton")), Names{"Norton"});
  EXPECT_EQ(mfront_behaviours(double_library("mfront_neo_hookean_specialised")), Names{"NeoHookean"});
  EXPECT_EQ(mfront_behaviours(double_library("mfront_malformed")).size(), 23u);
}

TEST(MfrontMetadata, TellsWhatABehaviourNeeds) {
  const MfrontBehaviour norton = behaviour_of("mfront_norton", "Norton");
  EXPECT_FALSE(norton.finite_strain);
  EXPECT_FALSE(norton.orthotropic);
  EXPECT_TRUE(norton.temperature);
  EXPECT_EQ(norton.prepended, (std::vector<std::string>{"YoungModulus", "PoissonRatio"}));
  EXPECT_TRUE(norton.properties.empty());
  ASSERT_EQ(norton.internal.size(), 2u);
  EXPECT_EQ(norton.internal[0].name, "ElasticStrain");
  EXPECT_EQ(norton.internal[0].type, 1);
  ASSERT_EQ(norton.parameters.size(), 6u) << "iterMax is no real number";
  EXPECT_EQ(norton.parameters[1].value, 8.2);
}

TEST(MfrontMetadata, AbsentSymbolsAreNothing) {
  const MfrontBehaviour bare = behaviour_of("mfront_malformed", "Bare");
  EXPECT_TRUE(bare.prepended.empty() && bare.properties.empty() && bare.internal.empty() && bare.external.empty() &&
              bare.parameters.empty());
  EXPECT_NE(bare.entry, nullptr);
}

struct Malformed {
  const char *behaviour, *words;
};

class MalformedBehaviour : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedBehaviour, IsRefusedInOneSentence) {
  ForeignModel model;
  model.interface = ForeignInterface::mfront;
  model.library = double_library("mfront_malformed");
  model.symbol = GetParam().behaviour;
  try {
    foreign_table(model);
    FAIL() << "accepted";
  } catch (const ModelRefused& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().words), std::string::npos) << error.what();
    const bool of_hypothesis = std::string(error.what()).find("the hypothesis Tridimensional") != std::string::npos;
    EXPECT_EQ(error.key() == "hypothesis", of_hypothesis) << error.key();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, MalformedBehaviour,
    testing::Values(Malformed{"NoFunction", "no function for the hypothesis Tridimensional"},
                    Malformed{"NoList", "symbol for MaterialProperties is missing"},
                    Malformed{"NullList", "symbol for InternalStateVariables is missing"},
                    Malformed{"Hole", "symbol for MaterialProperties is missing"},
                    Malformed{"HugeCount", "symbol for InternalStateVariables is shorter than its count"},
                    Malformed{"FewTypes", "symbol for InternalStateVariablesTypes is shorter than its count"},
                    Malformed{"UnknownKind", "variable 'p' is of an unknown kind"},
                    Malformed{"SameNames", "two of its parameters or state variables are named 'p'"},
                    Malformed{"SameProperties", "two of its parameters or state variables are named 'E'"},
                    Malformed{"NameOfLines", "is empty or holds what cannot stand in a key"},
                    Malformed{"NoName", "is empty or holds what cannot stand in a key"},
                    Malformed{"FullGradient", "Gradients contradict its type: a variable of kind 3, not one of kind 1"},
                    Malformed{"OddGradient", "Gradients contradict its type: a variable of kind 77"},
                    Malformed{"TwoGradients", "Gradients contradict its type: 2 variables"},
                    Malformed{"FixedPlane", "variable 'p' is of an unknown kind, 17"},
                    Malformed{"OtherHypotheses", "does not name the hypothesis Tridimensional among its own"},
                    Malformed{"ManyHypotheses", "symbol for ModellingHypotheses is shorter than its count"},
                    Malformed{"Cohesive", "is of type 3 and kinematic 2"}, Malformed{"Later", "has api_version 2"},
                    Malformed{"Castem", "made for MFront's interface 'Castem'"},
                    Malformed{"Nothing", "made for MFront's interface ''"},
                    Malformed{"Null", "made for MFront's interface ''"},
                    Malformed{"Absent", "has no behaviour 'Absent'"}),
    [](const auto& instance) { return std::string(instance.param.behaviour); });

}  // namespace
}  // namespace assay::adapters::test_mfront_metadata
