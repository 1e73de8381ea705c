// SPDX-License-Identifier: BSD-3-Clause
// Negative controls: each promise of `assay run` is broken once, and the check must say so.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <vector>

#include "drivers/output/vtu.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/fuzz/result_files.hpp"
#include "tests/fuzz/run_faults.hpp"

namespace assay::fuzz::test_run_faults {

namespace {

namespace fs = std::filesystem;

Outcome refused() {
  Outcome outcome;
  outcome.status = 2;
  outcome.error = "scene.yaml:1:1: x: unknown key\n";
  return outcome;
}

std::size_t count_of_faults(const Outcome& outcome) { return faults_of(outcome, "/nowhere", Promise{}).size(); }

TEST(RunFaults, BadInputMayOnlyBeOneLine) {
  EXPECT_EQ(count_of_faults(refused()), 0u);
  for (const char* said : {"", "\n", "no end", "two\nlines\n", "esc\x1b[2J\n"}) {
    Outcome outcome = refused();
    outcome.error = said;
    EXPECT_GT(count_of_faults(outcome), 0u) << said;
  }
  Outcome outcome = refused();
  outcome.out = "partial";
  EXPECT_EQ(count_of_faults(outcome), 1u);
}

TEST(RunFaults, CrashesAreSeenThroughTheirStatusAndTheirWords) {
  for (const int status : {4, 77, 109, 127, 128 + 6, 128 + 11, -1}) {
    Outcome outcome = refused();
    outcome.status = status;
    EXPECT_GT(count_of_faults(outcome), 0u) << status;
  }
  for (const char* said : {"assay: crashed (signal 11), most likely in the material's library\n",
                           "assay: this is a bug: vector::_M_range_check\n", "assay: out of memory\n",
                           "a.cpp:1:2: runtime error: division by zero\n"}) {
    Outcome outcome = refused();
    outcome.status = 3;
    outcome.error = said;
    EXPECT_EQ(count_of_faults(outcome), 1u) << said;
  }
}

TEST(RunFaults, TimeAndMemory) {
  Outcome outcome = refused();
  outcome.cpu_s = 11;
  EXPECT_EQ(count_of_faults(outcome), 1u);
  outcome.resident_bytes = std::int64_t{1} << 40;
  EXPECT_EQ(count_of_faults(outcome), 2u);
  outcome.timed_out = true;
  EXPECT_EQ(count_of_faults(outcome), 3u);
}

TEST(RunFaults, AFolderIsWholeOrNotThere) {
  const drivers::ScratchFolder scratch;
  fs::create_directories(scratch / "out");
  EXPECT_EQ(faults_of(refused(), scratch / "out", Promise{}).size(), 1u);
  Outcome completed = refused();
  completed.status = 0, completed.error.clear();
  EXPECT_EQ(faults_of(completed, scratch / "out", Promise{}).size(), 3u);  // three files are missing
  EXPECT_EQ(faults_of(completed, scratch / "none", Promise{}).size(), 1u);
  scratch.write("out/.staging-1", "");
  EXPECT_EQ(faults_of(completed, scratch / "out", Promise{}).size(), 4u);
}

std::string fault_of(const std::string& name, const std::string& text) {
  const drivers::ScratchFolder scratch;
  return file_fault(scratch.write(name, text));
}

TEST(RunFaults, NumbersThatAreNotFinite) {
  EXPECT_EQ(fault_of("errors.csv", "t,l2\n0,\n1,2e-3\n"), "");
  for (const char* text : {"t,l2\n0,nan\n", "t,l2\n0,-inf\n", "t,l2\n0\n", "t,l2\n0,1"}) {
    EXPECT_NE(fault_of("errors.csv", text), "") << text;
  }
  EXPECT_NE(fault_of("result.json", "{\"outcome\": nan}"), "");
  EXPECT_NE(fault_of("result.json", "{\"outcome\": \"completed\""), "");
  EXPECT_NE(fault_of("particles.pvd", "<DataSet timestep=\"nan\"/></VTKFile>\n"), "");
  EXPECT_EQ(fault_of("report.html", "<title>nan</title><h1>nan</h1><td>1</td></html>"), "");
  EXPECT_NE(fault_of("report.html", "<td>nan</td></html>"), "");
  EXPECT_NE(fault_of("report.html", "<path d=\"M1,nan\"/></html>"), "");
  EXPECT_NE(fault_of("error.png", "\x89PNG"), "");
  EXPECT_NE(fault_of("resolved.yaml", "motion: {type: vortex}\n"), "");
  EXPECT_NE(fault_of("core", ""), "");
}

TEST(RunFaults, ValuesOfAVtuFile) {
  std::vector<double> at{0, 1, 0}, values{2};
  const auto text = [&] { return drivers::vtu_text(at, {{"jacobian", 1, std::span<const double>(values)}}, 0.5); };
  EXPECT_EQ(fault_of("particles_0000.vtu", text()), "");
  EXPECT_NE(fault_of("particles_0000.vtu", text().substr(0, text().size() - 30)), "");
  values[0] = std::nan("");
  EXPECT_NE(fault_of("particles_0000.vtu", text()).find("jacobian"), std::string::npos);
  values[0] = 2, at[2] = -INFINITY;
  EXPECT_NE(fault_of("particles_0000.vtu", text()).find("Points"), std::string::npos);
}

TEST(RunFaults, ADamagedBlockOfAVtuFile) {
  const std::vector<double> at(3000, 0.5);
  std::string text = drivers::vtu_text(at, {}, 0.5);
  text[text.rfind("\n</AppendedData>") - 5] ^= 0x10;
  EXPECT_EQ(fault_of("particles_0000.vtu", text), "a damaged block");
}

/// Runs sh with a script.
Outcome run_script(const std::string& script, const Bounds& bounds) {
  const drivers::ScratchFolder scratch;
  return run_bounded("/bin/sh", {"-c", script}, scratch / "", bounds);
}

TEST(RunFaults, BoundsAreThoseOfTheKernel) {
  const Outcome spoken = run_script("echo one; echo two >&2; exit 2", {});
  EXPECT_EQ(spoken.status, 2);
  EXPECT_EQ(spoken.out, "one\n");
  EXPECT_EQ(spoken.error, "two\n");
  const Outcome busy = run_script("while :; do :; done", {.cpu_s = 1});
  EXPECT_EQ(busy.status, 128 + SIGXCPU);
  // RLIMIT_CPU counts ticks of the clock, which may be a sixth too many beside programs that often wait. What is
  // measured is exact, as what the shell knows of itself.
  const Outcome measured = run_script(
      "until times >t && read user system <t && [ \"$user\" != \"${user#0m0.[5-9]}\" ]; do\n"
      "i=0; while [ $i -lt 9999 ]; do i=$((i + 1)); done; done",
      {});
  EXPECT_EQ(measured.status, 0);
  EXPECT_GT(measured.cpu_s, 0.49);
  const Outcome slow = run_script("sleep 60 & sleep 60", {.wall_s = 0.2});
  EXPECT_TRUE(slow.timed_out);
  EXPECT_LT(slow.wall_s, 30);
  EXPECT_EQ(run_script("kill -SEGV $$", {}).status, 128 + 11);
  EXPECT_NE(run_script("head -c 100000000 /dev/zero | tail", {.address_bytes = std::int64_t{32} << 20}).status, 0);
  EXPECT_NE(run_script("set -e; head -c 10000 /dev/zero >file", {.file_bytes = 5000}).status, 0);
}

}  // namespace

}  // namespace assay::fuzz::test_run_faults
