// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/error_sampler.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::drivers::test_error_sampler {
namespace {

TEST(ErrorFigures, AnErrorThatIsNoNumberIsNotLeftOut) {
  for (const int of_none : {0, 1, 2}) {
    std::vector<ErrorSample> history(3);
    for (int k = 0; k < 3; ++k) history[static_cast<std::size_t>(k)].t = 0.5 * k;
    history[1].displacement = {1e-3, 2e-3};
    EXPECT_EQ(figures_of(history, 0.5, 1, 1).l2_max, 1e-3);
    ErrorSample& sample = history[static_cast<std::size_t>(of_none)];
    sample.displacement.l2 = sample.stress.linf = sample.rms36 = NAN;
    const ErrorFigures found = figures_of(history, 0.5, 1, 1);
    EXPECT_TRUE(std::isnan(*found.l2_max)) << of_none;
    EXPECT_TRUE(std::isnan(*found.stress.linf_max)) << of_none;
    EXPECT_TRUE(std::isnan(*found.rms36_max)) << of_none;
    EXPECT_EQ(found.linf_max, 2e-3);
  }
}

}  // namespace
}  // namespace assay::drivers::test_error_sampler
