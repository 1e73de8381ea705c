// SPDX-License-Identifier: BSD-3-Clause
// A host and the library leave each other alone: arithmetic, signals, locale, folder, standard streams, threads.
#include <fenv.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <thread>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "tests/drivers/library/handles.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::library_test::test_call {
namespace {

/// Everything from a scene to numbers.
std::vector<Fields> whole_way(const std::vector<double>& X) {
  const auto problem =
      opened(vortex_text("zener, parameters: {E: 1e3, nu: .3, viscous_ratio: .5, relaxation_time: .3}"), .3);
  assay_facts facts = ASSAY_FACTS_INIT;
  assay_get_facts(problem.get(), &facts, nullptr);
  return evaluated(points_at(problem, X, 2), .3, X.size() / 2);
}

const std::vector<double> some{.9, .2, .8, .1, 1, -.3, 1e-9, 0};

void expect_same(const std::vector<Fields>& a, const std::vector<Fields>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(Fields)), 0);
}

class OneRounding : public testing::TestWithParam<int> {};

TEST_P(OneRounding, OfTheHostChangesNoResultAndStays) {
  const std::vector<Fields> expected = whole_way(some);
  std::fesetround(GetParam());
  std::feraiseexcept(FE_INEXACT);
  std::feclearexcept(FE_OVERFLOW);
  const std::vector<Fields> found = whole_way(some);
  const int rounding = std::fegetround(), raised = std::fetestexcept(FE_ALL_EXCEPT);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(rounding, GetParam());
  EXPECT_EQ(raised & FE_OVERFLOW, 0);
  expect_same(found, expected);
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, OneRounding, testing::Values(FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO));

TEST(Arithmetic, TrapsOfTheHostFindNothing) {
  const std::vector<Fields> expected = whole_way(some);
  std::feclearexcept(FE_ALL_EXCEPT);
  ::feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  const std::vector<Fields> found = whole_way(some);
  const auto problem = opened(vortex_text());
  assay_options broken = ASSAY_OPTIONS_INIT;
  broken.text = "motion: 1e999";
  assay_problem* none = nullptr;
  EXPECT_EQ(assay_open(&broken, &none, nullptr), ASSAY_BAD_INPUT);
  const int enabled = ::fegetexcept();
  ::fedisableexcept(FE_ALL_EXCEPT);
  EXPECT_EQ(enabled, FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  expect_same(found, expected);
}

#if defined(__x86_64__)
TEST(Arithmetic, FlushedDenormalsOfTheHostChangeNothingAndStay) {
  constexpr unsigned flushed = 0x8040;  // FTZ and DAZ
  const std::vector<Fields> expected = whole_way(some);
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flushed);
  const std::vector<Fields> found = whole_way(some);
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  EXPECT_EQ(after & flushed, flushed);
  expect_same(found, expected);
}
#endif

TEST(Host, KeepsItsSignalsFolderLocaleAndUmask) {
  std::array<struct sigaction, 32> before{}, after{};
  sigset_t blocked_before, blocked_after;
  std::memset(&blocked_before, 0, sizeof blocked_before), std::memset(&blocked_after, 0, sizeof blocked_after);
  ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked_before);
  for (int s = 1; s < 32; ++s) ::sigaction(s, nullptr, &before[static_cast<std::size_t>(s)]);
  const auto folder = std::filesystem::current_path();
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  whole_way(some);
  for (int s = 1; s < 32; ++s) {
    ::sigaction(s, nullptr, &after[static_cast<std::size_t>(s)]);
    EXPECT_EQ(before[static_cast<std::size_t>(s)].sa_handler, after[static_cast<std::size_t>(s)].sa_handler) << s;
  }
  ::pthread_sigmask(SIG_SETMASK, nullptr, &blocked_after);
  EXPECT_EQ(std::memcmp(&blocked_before, &blocked_after, sizeof blocked_before), 0);
  EXPECT_EQ(std::filesystem::current_path(), folder);
  EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
}

TEST(Host, MayHaveADecimalComma) {
  const std::vector<Fields> expected = whole_way(some);
  const char* with_comma[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"};
  const bool is_there = std::ranges::any_of(with_comma, [](const char* name) { return std::setlocale(LC_ALL, name); });
  if (!is_there) GTEST_SKIP() << "no locale with a decimal comma is installed";
  const std::vector<Fields> found = whole_way(some);
  std::setlocale(LC_ALL, "C");
  expect_same(found, expected);
}

TEST(Host, MayStandInAFolderThatIsGone) {
  const std::vector<Fields> expected = whole_way(some);
  const auto back = std::filesystem::current_path();
  {
    const drivers::ScratchFolder gone;
    ASSERT_EQ(::chdir((gone / "").c_str()), 0);
  }
  const std::vector<Fields> found = whole_way(some);
  ASSERT_EQ(::chdir(back.c_str()), 0);
  expect_same(found, expected);
}

TEST(Host, ReadsNothingOnItsStreams) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  whole_way(some);
  opened("motion: {type: vortex", 0, ASSAY_BAD_INPUT);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Host, OpensProblemsInManyThreadsAtOnce) {
  const std::vector<Fields> expected = whole_way(some);
  std::vector<std::vector<Fields>> found(4);
  std::vector<std::thread> crew;
  for (auto& each : found) crew.emplace_back([&each] { each = whole_way(some); });
  for (std::thread& thread : crew) thread.join();
  for (const auto& each : found) expect_same(each, expected);
}

}  // namespace
}  // namespace assay::library_test::test_call
