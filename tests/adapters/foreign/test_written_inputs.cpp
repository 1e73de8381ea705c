// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/written_inputs.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "adapters/process/process_watch.hpp"
#include "adapters/worker/remote_table.hpp"
#include "tests/adapters/foreign/foreign_steps.hpp"
#include "tests/adapters/foreign/vendor_doubles.hpp"

namespace assay::adapters::test_written_inputs {
namespace {

Tensor stretched(double by) { return Vector3(1 + by, 1, 1).asDiagonal(); }

/// Names of what a model has written after a step taken twice, in a process that no other test has marked.
std::string written_by(const ForeignModel& model, double which) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const ProcessWatch watch;
    StepsOfOnePoint point(
        model, which > 0 ? std::map<std::string, double>{{"writes", which}} : std::map<std::string, double>{});
    const Tensor once = point.tried(0, 0.5, stretched(0), stretched(0.01)).cauchy;
    const Tensor twice = point.tried(0, 0.5, stretched(0), stretched(0.01)).cauchy;
    std::string words = habit_words(watch.habits());
    if (twice != once) words += " and the next call is another";
    [[maybe_unused]] const ssize_t written = ::write(ends[1], words.data(), words.size());
    ::_exit(0);
  }
  ::close(ends[1]);
  char text[256];
  std::string words;
  for (ssize_t n; (n = ::read(ends[0], text, sizeof text)) > 0;) words.append(text, static_cast<std::size_t>(n));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return words;
}

TEST(WrittenInputs, OfAUmatAreNamedAndPutRight) {
  const char* names[] = {"",       "STRAN",  "PROPS", "DTIME", "integers as NTENS, KINC",
                         "DFGRD1", "PREDEF", "DROT",  "CELENT"};
  for (std::size_t which = 0; which < std::size(names); ++which) {
    const std::string name = names[which];
    EXPECT_EQ(written_by(foreign_double("umat_orthotropic"), static_cast<double>(which)),
              name.empty() ? "" : "writes to its inputs (" + name + ")");
  }
}

TEST(WrittenInputs, OfAVumatAreNamedFromItsFirstStepOn) {
  EXPECT_EQ(written_by(foreign_double("vumat_clock"), 0), "");
  EXPECT_EQ(written_by(foreign_double("vumat_clock"), 1), "writes to its inputs (stateOld)");
  const Material material(foreign_table(foreign_double("vumat_clock")), {{"writes", 1}});
  const ProcessWatch watch;
  material.initial_state(1);
  EXPECT_EQ(watch.habits(), no_habit) << "at time 0 a model may set another state";
}

TEST(WrittenInputs, OfMfrontAreNamed) {
  EXPECT_EQ(written_by(foreign_double("mfront_norton"), 0), "");
  EXPECT_EQ(written_by(foreign_double("mfront_norton_writes"), 0), "writes to its inputs (s0)");
}

TEST(WrittenInputs, OfOtherVendorsAreNamedAndPutRight) {
  if (!double_exists("usermat_j2")) GTEST_SKIP() << "no Fortran compiler";
  constexpr double writes = 4;
  ForeignModel usermat = usermat_double(), lsdyna = lsdyna_double();
  EXPECT_EQ(written_by(usermat, 0), "");
  EXPECT_EQ(written_by(lsdyna, 0), "");
  usermat.properties.back().value = lsdyna.properties.back().value = writes;
  EXPECT_EQ(written_by(usermat, 0), "writes to its inputs (DSTRAN)");
  EXPECT_EQ(written_by(lsdyna, 0), "writes to its inputs (PROPS)");
}

TEST(WrittenInputs, AreHeardOfFromAWorker) {
  const assay_material* table =
      remote_table({"model\ntest.yaml\nlibrary: " + double_library("vumat_clock") +
                    "\ninterface: vumat\nname: clock\nproperties: {modulus: 1.0e3, writes: 1}\nstate: 4\n"});
  const Material material(table, {});
  const double I[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<double> state0 = material.initial_state(1);
  std::vector<double> state1(state0.size()), cauchy(9);
  EXPECT_EQ(marks_of(table).habits, no_habit);
  material.update(0, 1, 1, I, I, state0.data(), state1.data(), cauchy.data());
  EXPECT_EQ(marks_of(table).habits, written_state_old);
  end_workers();
}

}  // namespace
}  // namespace assay::adapters::test_written_inputs
