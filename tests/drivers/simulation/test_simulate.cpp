// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/simulate.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/drivers/quiet_run.hpp"

namespace assay::drivers::test_simulate {
namespace {

constexpr double clock_grain = 0.02;  ///< of a processor's clock that is read twice [s]

nlohmann::json coarse_vortex(const char* samples) {
  return result_of_run("paper/vortex_cpdi",
                       {"grid.spacing=0.1", "output.particles=0", "output.pictures=false", samples});
}

TEST(StepClock, IsPartOfTheProcessorTimeOfTheRun) {
  const auto result = coarse_vortex("output.errors=10");
  EXPECT_GT(result["step_cpu_s"].get<double>(), 0);
  EXPECT_LE(result["step_cpu_s"].get<double>(), result["wall_s"].get<double>() + clock_grain);
}

TEST(StepClock, DoesNotSeeTheSamplingOfTheError) {
  const auto few = coarse_vortex("output.errors=1"), many = coarse_vortex("output.errors=10000");
  double sampling = 0;  // after every step
  for (const auto& pass : many["passes"])
    sampling += pass["name"] == "error_sampling" ? pass["seconds"].get<double>() : 0;
  ASSERT_GT(sampling, 0.2 * few["step_cpu_s"].get<double>());
  EXPECT_LT(many["step_cpu_s"].get<double>(), few["step_cpu_s"].get<double>() + 0.5 * sampling + clock_grain);
}

/// With the density as large as the modulus the motion is the same, and stresses are as many times larger.
TEST(ErrorOfStress, IsRelativeToTheModulusWhateverItsSize) {
  const auto stress = [](const std::string& size) {
    const auto result = result_of_run(
        "paper/vortex_cpdi", {"grid.spacing=0.125", "time.end=0.05", "output.particles=0", "output.pictures=false",
                              "material.parameters.E=" + size, "material.density=" + size});
    return result["error"]["stress"]["l2_max"].get<double>() / std::stod(size);
  };
  const double usual = stress("1e3");
  EXPECT_GT(usual, 0);
  for (const char* size : {"1e-290", "1e-160", "1e160", "1e290"}) EXPECT_NEAR(stress(size) / usual, 1, 1e-9) << size;
}

TEST(ZeroMotion, IsWarnedOf) {
  const auto warned = [](const std::string& set) {
    const auto result =
        result_of_run("paper/vortex_cpdi", {"grid.spacing=0.125", "output.particles=0", "output.pictures=false", set});
    return result["warnings"].dump().find("the exact displacement is zero") != std::string::npos;
  };
  EXPECT_TRUE(warned("motion.amplitude.peak=0"));
  EXPECT_FALSE(warned("output.errors=1"));
}

TEST(LongPeakMemory, GrowsWithWhatIsTouched) {
  const std::int64_t before = peak_memory();
  EXPECT_GT(before, 1 << 20);
  constexpr std::size_t bytes = std::size_t{512} << 20;
  const std::vector<char> large(bytes, 1);
  EXPECT_EQ(large.back(), 1);
  EXPECT_GE(peak_memory(), before);
  EXPECT_GE(peak_memory(), static_cast<std::int64_t>(bytes));
}

}  // namespace
}  // namespace assay::drivers::test_simulate
