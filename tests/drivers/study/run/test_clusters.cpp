// SPDX-License-Identifier: BSD-3-Clause
// What docs/clusters.md says of GNU parallel and Slurm, done.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/drivers/study/study_program.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_clusters {
namespace {

namespace fs = std::filesystem;

const std::string array_script = tree_folder() + "/configs/studies/array.slurm";
const std::string slurm_of_one_node = tree_folder() + "/tests/drivers/study/one_node_slurm.sh";

/// A shell's command in the folder, with this build's program on the PATH.
Ending shell_command(const ScratchFolder& scratch, const std::string& command) {
  const std::string said = scratch / "shell";
  const std::string line = "cd '" + scratch / "." + "' && export HOME=$PWD PATH='" + built() + "':$PATH && { " +
                           command + "\n} >'" + said + "' 2>&1 </dev/null";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(said)};
}

TEST(LongClusters, GnuParallelRunsShards) {
  const SmallStudy small;
  if (shell_command(small.scratch, "parallel --version | grep -q '^GNU parallel'").status != 0)
    GTEST_SKIP() << "GNU parallel is not installed";
  ASSERT_EQ(small.run("whole").status, 0);
  const std::string shards = "parallel --jobs 3 assay study study.yaml -o out --resume --jobs 1 --shard {}/3 ::: 1 2 3";
  const Ending all = shell_command(small.scratch, shards + " && assay study study.yaml -o out --merge");
  EXPECT_EQ(all.status, 0) << all.said;
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

/// What Slurm gives the script, without Slurm.
std::string as_task(int index, int count, const std::string& more = "") {
  return "SLURM_ARRAY_TASK_MIN=1 SLURM_ARRAY_TASK_MAX=" + std::to_string(count) +
         " SLURM_ARRAY_TASK_COUNT=" + std::to_string(count) + " SLURM_ARRAY_TASK_ID=" + std::to_string(index) + " " +
         more + " bash " + array_script + " study.yaml out";
}

TEST(LongClusters, TheArrayScriptMapsItsIndexToAShard) {
  const SmallStudy small;
  ASSERT_EQ(small.run("whole").status, 0);
  const Ending first = shell_command(small.scratch, as_task(1, 2, "SLURM_CPUS_ON_NODE=2"));
  EXPECT_EQ(first.status, 0) << first.said;
  EXPECT_NE(first.said.find("shard 1/2: 2 cases"), std::string::npos) << first.said;
  const Ending early = shell_command(small.scratch, "bash " + array_script + " study.yaml out --merge");
  EXPECT_EQ(early.status, 1) << early.said;
  const Ending second = shell_command(small.scratch, as_task(2, 2, "ASSAY=" + built("assay")));
  EXPECT_EQ(second.status, 0) << second.said;
  const Ending merged = shell_command(small.scratch, "bash " + array_script + " study.yaml out --merge");
  EXPECT_EQ(merged.status, 0) << merged.said;
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

TEST(Clusters, TheArrayScriptRefusesAPartOfAnArray) {
  const SmallStudy small;
  const std::string part =
      "SLURM_ARRAY_TASK_MIN=2 SLURM_ARRAY_TASK_MAX=3 SLURM_ARRAY_TASK_COUNT=2 "
      "SLURM_ARRAY_TASK_ID=3 ";
  const std::string call = "bash " + array_script + " study.yaml out";
  EXPECT_EQ(shell_command(small.scratch, part + call).status, 2) << "2-3 of how many?";
  EXPECT_EQ(shell_command(small.scratch, call).status, 2) << "no array";
  EXPECT_EQ(shell_command(small.scratch, "bash " + array_script).status, 2);
  EXPECT_FALSE(fs::exists(small.scratch / "out"));
  const Ending known = shell_command(small.scratch, part + "SHARDS=4 " + call);
  EXPECT_EQ(known.status, 0) << known.said;
  EXPECT_NE(known.said.find("shard 3/4: 1 cases"), std::string::npos) << known.said;
}

/// Ends the daemons whatever happens.
class OneNodeSlurm {
 public:
  explicit OneNodeSlurm(const ScratchFolder& scratch) : scratch_(scratch) {
    const int port = 20000 + 2 * (::getpid() % 10000);
    started_ = shell_command(scratch_, "'" + slurm_of_one_node + "' $PWD/slurm " + std::to_string(port));
  }
  ~OneNodeSlurm() { shell_command(scratch_, "'" + slurm_of_one_node + "' $PWD/slurm stop"); }
  OneNodeSlurm(const OneNodeSlurm&) = delete;
  OneNodeSlurm& operator=(const OneNodeSlurm&) = delete;

  const Ending& started() const { return started_; }
  Ending run(const std::string& command) const {
    return shell_command(scratch_, "export SLURM_CONF=$PWD/slurm/slurm.conf; " + command);
  }

 private:
  const ScratchFolder& scratch_;
  Ending started_;
};

class LongClusters : public testing::Test {
 protected:
  void SetUp() override {
    if (slurm_.started().status == 77) GTEST_SKIP() << slurm_.started().said;
    ASSERT_EQ(slurm_.started().status, 0) << slurm_.started().said;
    ASSERT_EQ(small_.run("whole").status, 0);
  }
  std::string logs() const {
    return shell_command(small_.scratch, "cat slurm-* /dev/null; tail -n 20 slurm/slurm*.log").said;
  }

  SmallStudy small_{small_study_text("timing: {repeat: 2, where: {method: CPDI}}\n")};
  OneNodeSlurm slurm_{small_.scratch};
};

TEST_F(LongClusters, AnArrayAndItsMerge) {
  const Ending all =
      slurm_.run("job=$(sbatch --parsable --array=1-3 '" + array_script + "' study.yaml out)\n" +
                 "timeout 120 sbatch --wait --dependency=afterany:$job '" + array_script + "' study.yaml out --merge");
  EXPECT_EQ(all.status, 0) << all.said << logs();
  EXPECT_EQ(same_in_every_run(small_.scratch / "out"), same_in_every_run(small_.scratch / "whole")) << logs();
}

TEST_F(LongClusters, AJobThatFailedIsNamedByTheMergeAndStartedAgain) {
  const std::string broken =
      "ASSAY=/bin/false sbatch --parsable --array=2 --export=ALL,SHARDS=2 '" + array_script + "' study.yaml out";
  const std::string script = "'" + array_script + "' study.yaml out";
  const Ending missing =
      slurm_.run("export SHARDS=2; a=$(sbatch --parsable --array=1 " + script + "); b=$(" + broken + ")\n" +
                 "timeout 120 sbatch --wait --dependency=afterany:$a:$b " + script + " --merge");
  EXPECT_EQ(missing.status, 1) << missing.said << logs();
  EXPECT_NE(bytes_of(small_.scratch / "out/cases.csv").find(",missing,"), std::string::npos) << logs();
  const Ending mended = slurm_.run("SHARDS=2 timeout 120 sbatch --wait --array=2 " + script +
                                   " && timeout 120 sbatch --wait " + script + " --merge");
  EXPECT_EQ(mended.status, 0) << mended.said << logs();
  EXPECT_EQ(same_in_every_run(small_.scratch / "out"), same_in_every_run(small_.scratch / "whole"));
}

}  // namespace
}  // namespace assay::drivers::test_clusters
