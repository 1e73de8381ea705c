// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/host_values.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace assay::adapters::test_beyond_probe {
namespace {

/// A model of one state variable and one property, around whose calls a probe looks.
class BeyondProbes : public testing::Test {
 protected:
  void TearDown() override { probes_beyond = false; }

  using Model = std::function<void(double* stress, double* state, const double* properties)>;
  /// What is said of the model's 256th call; empty where nothing is.
  std::string said_of(const Model& model) {
    const auto answer = [&] {
      arrays_.fill(stress_, 1), arrays_.fill(state_, 0.5);
      probe_.lend(arrays_);
      model(arrays_[stress_], arrays_[state_], arrays_[properties_]);
      probe_.take_back(arrays_);
      ++calls_;
      if (arrays_[stress_][0] < 0) throw PointFailure("asks for a shorter step");
    };
    answer();
    for (int call = 1; call < 256; ++call) EXPECT_FALSE(probe_.is_due()) << call;
    if (!probe_.is_due()) return "not due";
    try {
      probe_.look(arrays_, {stress_, state_}, "STATEV", answer);
    } catch (const PointFailure& failure) {
      return failure.what();
    }
    return arrays_.broken_fence().value_or("");
  }

  GuardedArrays arrays_;
  std::size_t stress_ = arrays_.add("STRESS", 6), state_ = arrays_.add("STATEV", 1),
              properties_ = arrays_.add("PROPS", 1);
  BeyondProbe probe_;
  int calls_ = 0;
};

TEST_F(BeyondProbes, LookInWorkersAlone) {
  EXPECT_EQ(said_of([](double*, double*, const double*) {}), "not due");
  EXPECT_EQ(calls_, 1);
}

TEST_F(BeyondProbes, SayThatMoreIsReadThanThereIs) {
  probes_beyond = true;
  const Model models[] = {[](double* s, double* q, const double*) { s[0] += q[1]; },
                          [](double* s, double* q, const double*) { s[5] = q[7] > 0.5 ? 2 : 1; },
                          [](double*, double* q, const double* props) { q[0] = props[1] == 0 ? 3 : 4; },
                          [](double* s, double* q, const double*) { s[0] = q[2] > 1 ? -1 : 1; }};
  for (const Model& model : models) {
    probe_ = {};
    const std::string said = said_of(model);
    EXPECT_EQ(said.find("reads beyond its arrays"), 0u) << said;
    EXPECT_FALSE(arrays_.broken_fence());
  }
}

TEST_F(BeyondProbes, LeaveTheAnswerOfWhatIsRightOrNeverTheSame) {
  probes_beyond = true;
  EXPECT_EQ(said_of([](double* s, double* q, const double* props) { s[0] = q[0] + props[0]; }), "");
  EXPECT_EQ(arrays_[stress_][0], 0.5);
  EXPECT_EQ(calls_, 4);
  probe_ = {};
  EXPECT_EQ(said_of([n = 0](double* s, double*, const double*) mutable { s[0] = ++n; }), "");
}

}  // namespace
}  // namespace assay::adapters::test_beyond_probe
