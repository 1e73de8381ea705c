// SPDX-License-Identifier: BSD-3-Clause
// All of a run's time has a name.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <regex>

#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_time_accounts {
namespace {

using Clock = std::chrono::steady_clock;

/// What a verb writes down of its time, and what a clock beside it says [s].
struct Accounts {
  double setup = 0, work = 0, finish = 0, cpu = 0, life = 0;
};

Accounts accounts_of(const std::string& folder, const std::function<void()>& verb) {
  const auto start = Clock::now();
  verb();
  const double life = std::chrono::duration<double>(Clock::now() - start).count();
  const auto result = result_in(folder);
  const auto figure = [&](const char* key) { return result.at(key).get<double>(); };
  return {figure("setup_s"), figure("wall_s"), figure("finish_s"), figure("cpu_s"), life};
}

Accounts accounts_of_run(const std::vector<std::string>& sets) {
  const ScratchFolder scratch;
  const RunOptions options = quiet_run("paper/vortex_cpdi", scratch / "out", sets);
  return accounts_of(options.out, [&] { run(options); });
}

/// The report and result.json are written when the accounts are closed, and a busy machine may hold the program then.
void expect_whole(const Accounts& all, const std::string& what) {
  const double named = all.setup + all.work + all.finish;
  EXPECT_LE(named, all.life) << what;
  EXPECT_GT(named, 0.7 * all.life - 0.05)
      << what << ": " << all.setup << ", " << all.work << ", " << all.finish << " of " << all.life;
}

TEST(LongTimeAccounts, ARunIsNamedAsAWhole) {
  const Accounts drawn = accounts_of_run({"grid.spacing=0.0625", "time.end=0.02", "output.particles=2"});
  expect_whole(drawn, "pictures");
  EXPECT_GT(drawn.setup, 0);
  EXPECT_GT(drawn.finish, drawn.work) << "two pictures of thousands of particles, and three steps";
  const Accounts plain = accounts_of_run(
      {"grid.spacing=0.0625", "time.end=0.1", "output.particles=0", "output.pictures=false", "output.report=false"});
  expect_whole(plain, "no pictures");
  EXPECT_LT(plain.finish, plain.setup + plain.work);
}

TEST(TimeAccounts, OfARunThatComesToNoStepAllIsSetUp) {
  const Accounts refused =
      accounts_of_run({"grid.spacing=0.125", "time.end=0.1", "force.tolerance=1e-6",
                       "material={adapter: hypoelastic_jaumann, parameters: {E: 1000, nu: 0.3}, density: 1000}"});
  expect_whole(refused, "refused");
  EXPECT_EQ(refused.work, 0);
  EXPECT_GT(refused.setup, 0);
}

TEST(LongTimeAccounts, ATabulationIsNamedAsAWhole) {
  const ScratchFolder scratch;
  TabulateOptions options;
  options.scene = tree_folder() + "/configs/paper/tabulate_neo_hookean.yaml";
  options.out = scratch / "out";
  options.verbosity = Verbosity::quiet;
  const Accounts all = accounts_of(options.out, [&] { tabulate(options); });
  expect_whole(all, "tabulate");
  EXPECT_GT(all.setup, 0);
  EXPECT_GT(all.work, 0);
  EXPECT_GT(all.finish, all.work) << "a curve is made faster than three pictures";
}

TEST(TimeAccounts, TheTerminalSaysThem) {
  const ScratchFolder scratch;
  const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
  const Ending ran = assay({"run", scene, "-o", scratch / "run", "--set", "grid.spacing=0.25", "--set", "time.end=0.05",
                            "--set", "expect={}"});
  // The line breaks between its parts where it is longer than a terminal is wide.
  const std::string said = std::regex_replace(ran.said, std::regex("\\s+"), " ");
  EXPECT_NE(said.find("s: set-up "), std::string::npos) << ran.said;
  EXPECT_NE(said.find(", stepping "), std::string::npos) << ran.said;
  EXPECT_NE(said.find(", pictures and files "), std::string::npos) << ran.said;
}

}  // namespace
}  // namespace assay::drivers::test_time_accounts
