// SPDX-License-Identifier: BSD-3-Clause
// A VUMAT is given 128 points a call: how many points a batch has changes nothing.
#include "adapters/foreign/vumat.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_vumat_blocks {
namespace {

/// Two steps of n points, each with a history of its own.
struct Batch {
  explicit Batch(std::size_t points) : n(points), F(3, std::vector<double>(9 * n)) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-0.05, 0.05);
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t k = 0; k < F.size(); ++k) {
        for (std::size_t c = 0; c < 9; ++c)
          F[k][c * n + p] = (c % 4 ? 0 : 1) + static_cast<double>(k) * uniform(random);
      }
    }
  }
  /// Of point p alone.
  std::vector<double> gradient(std::size_t k, std::size_t p) const {
    std::vector<double> nine(9);
    for (std::size_t c = 0; c < 9; ++c) nine[c] = F[k][c * n + p];
    return nine;
  }
  std::size_t n;
  std::vector<std::vector<double>> F;
};

class VumatBlocks : public testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    if (!double_exists("vumat_j2")) GTEST_SKIP() << "no Fortran compiler";
    material_ = std::make_unique<Material>(foreign_table(foreign_double("vumat_j2")), std::map<std::string, double>{});
  }
  /// State and stress after one step.
  struct End {
    std::vector<double> state, cauchy;
  };
  End step(std::size_t n, const std::vector<double>& F0, const std::vector<double>& F1,
           const std::vector<double>& state) const {
    End end{std::vector<double>(state.size()), std::vector<double>(9 * n)};
    const UpdateReport report =
        material_->update(0, 0.1, n, F0.data(), F1.data(), state.data(), end.state.data(), end.cauchy.data());
    EXPECT_EQ(report.worst, ASSAY_GOOD) << report.message;
    return end;
  }
  std::unique_ptr<Material> material_;
};

TEST_P(VumatBlocks, GiveBitForBitWhatPointsAloneGive) {
  const Batch batch(GetParam());
  const std::size_t n = batch.n;
  const std::vector<double> rest = material_->initial_state(n), rest_alone = material_->initial_state(1);
  const End first = step(n, batch.F[0], batch.F[1], rest), second = step(n, batch.F[1], batch.F[2], first.state);
  bool yielded = false;
  for (std::size_t p = 0; p < n; ++p) {
    const End one = step(1, batch.gradient(0, p), batch.gradient(1, p), rest_alone),
              two = step(1, batch.gradient(1, p), batch.gradient(2, p), one.state);
    for (std::size_t c = 0; c < 9; ++c) ASSERT_EQ(second.cauchy[c * n + p], two.cauchy[c]) << p;
    for (std::size_t c = 0; c < two.state.size(); ++c) ASSERT_EQ(second.state[c * n + p], two.state[c]) << p;
    yielded = yielded || two.state.back() > 0;
  }
  EXPECT_TRUE(yielded) << "the plastic strain is what this is about";
}

INSTANTIATE_TEST_SUITE_P(Sizes, VumatBlocks, testing::Values(1, 127, 128, 129, 300, 4096),
                         [](const auto& instance) { return "of_" + std::to_string(instance.param); });

TEST(Vumat, StressThatIsLeftUnwrittenIsNamed) {
  const Material material(foreign_table(foreign_double("vumat_clock")), {{"writes", 2}});
  const double I[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<double> state0 = material.initial_state(1);
  std::vector<double> state1(state0.size()), cauchy(9);
  const UpdateReport report = material.update(0, 1, 1, I, I, state0.data(), state1.data(), cauchy.data());
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_EQ(report.message,
            overrun_words +
                std::string("the VUMAT leaves stressNew 31 unwritten, or computes it from itself, at point 1 of 1"));
}

}  // namespace
}  // namespace assay::adapters::test_vumat_blocks
