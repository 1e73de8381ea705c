// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/path.hpp"

#include <gtest/gtest.h>

#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::test_path {
namespace {

TEST(LoadingPath, ReachesEveryStateOfThePathAndLittleMore) {
  Homogeneous stretch;
  stretch.final(0, 0) = 0.4;
  const Vortex sine{0.75, 1.25, 2, {Amplitude::Type::sine, -0.7, 1.0}};
  const Vortex from_rest{0.75, 1.25, 3, {Amplitude::Type::one_minus_cosine, 1.3, 0.5}};
  const Vortex ramp{0.75, 1.25, 2, {Amplitude::Type::ramp, 1.3, 0.5}};
  for (const Path& path : {stretch.baseline(), sine.baseline(), from_rest.baseline(), ramp.baseline()}) {
    for (const double end : {0.9, 1.7}) {
      const Path straight = loading_path(path, end);
      Interval reached;
      for (int k = 0; k <= 1000; ++k) {
        for (const double xi : {path.parameter.lower, path.parameter.upper}) {
          const double eps = path.eps(xi, end * k / 1000);
          reached.lower = std::min(reached.lower, eps);
          reached.upper = std::max(reached.upper, eps);
        }
      }
      EXPECT_LE(straight.parameter.lower, reached.lower + 1e-12) << path.name;
      EXPECT_GE(straight.parameter.upper, reached.upper - 1e-12) << path.name;
      EXPECT_LT(straight.parameter.width(), 1.1 * reached.width() + 1e-12) << path.name << " " << end;
      const double eps = straight.parameter.lower;
      EXPECT_LT((straight.deformation_gradient(eps, 1) - Tensor::Identity() - eps * path.direction).norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace assay::test_path
