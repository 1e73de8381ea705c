// SPDX-License-Identifier: BSD-3-Clause
// The end of the analysis, messages, texts, tables and mutexes.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "tests/adapters/abaqus/abaqus_library.hpp"

namespace assay::adapters::test_host {
namespace {

using Exit = void();
using Abqerr = void(const int*, const char*, const int*, const double*, const char*, std::size_t, std::size_t);
using Text = void(char*, int*, std::size_t);
using OfFortran = void(const int*);
using OfC = void(int);

/// What a routine says on standard error, with how it ended the analysis.
std::string said_by(const std::function<void()>& call) {
  const EndsAreThrown ends;
  testing::internal::CaptureStderr();
  std::string end;
  try {
    call();
  } catch (const Ended& ended) {
    end = "[" + ended.what + "]";
  }
  return testing::internal::GetCapturedStderr() + end;
}

std::string message(int lop, const std::string& text, const std::string& routine = "stdb_abqerr_") {
  const int integers[] = {12, -3};
  const double reals[] = {0.25, -1.5e30};
  const std::string words = padded("STEEL", 8) + padded("CLAY", 8);
  return said_by([&] { abaqus<Abqerr>(routine)(&lop, text.data(), integers, reals, words.data(), text.size(), 8); });
}

TEST(AbaqusHost, MessagesHaveTheirValuesFilledInInTurn) {
  EXPECT_EQ(message(1, "%I points, %I left"), "information: 12 points, -3 left\n");
  EXPECT_EQ(message(1, "E = %R, f = %R"), "information: E = 0.25, f = -1.5e+30\n");
  EXPECT_EQ(message(1, "%S and %S"), "information: STEEL    and CLAY\n");
  EXPECT_EQ(message(1, "%S%I%R%I"), "information: STEEL   120.25-3\n");
  EXPECT_EQ(message(1, "100 % of %i %"), "information: 100 % of %i %\n");
  EXPECT_EQ(message(1, padded("blanks at the end go", 500)), "information: blanks at the end go\n");
  EXPECT_EQ(message(1, ""), "information: \n");
}

TEST(AbaqusHost, MessagesWithoutPlacesLookAtNoValues) {
  const int lop = -1;
  const std::string text = "as public models call it";
  EXPECT_EQ(
      said_by([&] { abaqus<Abqerr>("stdb_abqerr_")(&lop, text.data(), nullptr, nullptr, nullptr, text.size(), 0); }),
      "warning: as public models call it\n");
}

TEST(AbaqusHost, LevelsAreNamedAndTheThirdErrorEndsTheAnalysis) {
  for (const char* routine : {"stdb_abqerr_", "xplb_abqerr_"}) {
    EXPECT_EQ(message(1, "a", routine), "information: a\n");
    EXPECT_EQ(message(-1, "a", routine), "warning: a\n");
    EXPECT_EQ(message(-2, "a", routine), "error: a\n");
    EXPECT_EQ(message(-3, "no %S", routine), "error: no STEEL\n[reported an error that ends the analysis: no STEEL]");
  }
}

TEST(AbaqusHost, LongMessagesAreCut) {
  const std::string found = message(-3, std::string(5000, 'x'));
  EXPECT_GT(found.size(), 1000u);
  EXPECT_LT(found.size(), 1500u);
}

TEST(AbaqusHost, ExitsSayWhichRoutineWasCalled) {
  EXPECT_EQ(said_by([] { abaqus<Exit>("xit_")(); }), "[called XIT]");
  EXPECT_EQ(said_by([] { abaqus<Exit>("xplb_exit_")(); }), "[called XPLB_EXIT]");
}

TEST(AbaqusHost, WithoutAHostAnExitEndsTheProcess) {
  auto* hook = abaqus<EndsAreThrown::Hook>("assay_abaqus_on_end");
  const auto before = std::exchange(*hook, nullptr);
  EXPECT_EXIT(abaqus<Exit>("xit_")(), testing::ExitedWithCode(1), "the model called XIT");
  *hook = before;
}

TEST(AbaqusHost, TextsArePaddedAndCutAsFortrans) {
  char* folder = abaqus<char>("assay_abaqus_folder");
  const std::string before = folder, here = "/some/folder";
  folder[here.copy(folder, here.size())] = '\0';
  for (const char* routine : {"getoutdir_", "vgetoutdir_", "getjobname_", "vgetjobname_"}) {
    const std::string expected = std::string(routine).find("outdir") != std::string::npos ? here : "assay";
    for (const std::size_t size : {256, 12, 3, 0}) {
      std::string text(size + 1, '#');
      int length = -1;
      abaqus<Text>(routine)(text.data(), &length, size);
      const std::string cut = expected.substr(0, size);
      EXPECT_EQ(text, padded(cut, size) + "#") << routine;
      EXPECT_EQ(length, static_cast<int>(cut.size()));
    }
  }
  folder[before.copy(folder, before.size())] = '\0';
}

TEST(AbaqusHost, WhatThereIsNotIsSaidByTheFlag) {
  int flag = 0, none = 0;
  double value = 3;
  char text[8] = "";
  for (const char* routine : {"getvrm_", "vgetvrm_"}) {
    flag = 0;
    abaqus<void(const char*, double*, int*, char*, int*, ...)>(routine)("SINV", &value, &none, text, &flag, 4, 8);
    EXPECT_EQ(flag, 1) << routine;
  }
  flag = 0;
  double slopes = 5;
  abaqus<void(const char*, const double*, const double*, const double*, const int*, double*, double*, const int*, int*,
              ...)>("getpropertytable_")("STIFFNESS", &value, &value, &value, &none, &value, &slopes, &none, &flag, 9);
  EXPECT_EQ(flag, 1) << "JERROR is the ninth";
  EXPECT_EQ(slopes, 5);
  flag = 0;
  abaqus<void(const char*, int*, ...)>("settablecollection_")("TABLES", &flag, 6);
  EXPECT_EQ(flag, 1);
  flag = 0;
  abaqus<void(const char*, const int*, int*, int*, double*, char*, int*, ...)>("getparametertable_")(
      "STIFFNESS", &none, &none, &none, &value, text, &flag, 9, 8);
  EXPECT_EQ(flag, 1);
  EXPECT_EQ(none, 0);
  EXPECT_EQ(value, 3);
}

TEST(AbaqusHost, OneProcessIsTheWholeAnalysis) {
  for (const char* routine : {"getrank_", "vgetrank_"}) {
    int rank = -1;
    abaqus<void(int*)>(routine)(&rank);
    EXPECT_EQ(rank, 0);
  }
  for (const char* routine : {"getnumcpus_", "vgetnumcpus_"}) {
    int count = -1;
    abaqus<void(int*)>(routine)(&count);
    EXPECT_EQ(count, 1);
  }
  EXPECT_EQ(abaqus<int()>("getnumthreads_")(), 1);
  EXPECT_EQ(abaqus<int()>("get_thread_id_")(), 0);
}

TEST(AbaqusHost, AMutexLetsOneThreadInAtATime) {
  constexpr int threads = 4, rounds = 2000, id = 100;
  abaqus<OfFortran>("mutexinit_")(&id);
  abaqus<OfC>("MutexInit")(id);
  long counted = 0;  // a race where the lock is none
  const auto from_fortran = [&] {
    abaqus<OfFortran>("mutexlock_")(&id), ++counted, abaqus<OfFortran>("mutexunlock_")(&id);
  };
  const auto from_c = [&] { abaqus<OfC>("MutexLock")(id), ++counted, abaqus<OfC>("MutexUnlock")(id); };
  std::vector<std::thread> all;
  for (int k = 0; k < threads; ++k) {
    all.emplace_back([&, k] {
      for (int round = 0; round < rounds; ++round) k % 2 ? from_c() : from_fortran();
    });
  }
  for (std::thread& thread : all) thread.join();
  EXPECT_EQ(counted, threads * rounds);
}

/// Whether another thread gets the mutex within a second.
bool is_free(int id) {
  auto got = std::make_shared<std::atomic<bool>>(false);
  std::thread([id, got] {
    abaqus<OfC>("MutexLock")(id);
    abaqus<OfC>("MutexUnlock")(id);
    *got = true;
  }).detach();
  for (int k = 0; k < 1000 && !*got; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return *got;
}

TEST(AbaqusHost, TheEndOfTheAnalysisReleasesWhatItsThreadHolds) {
  for (const int id : {1, 37}) abaqus<OfC>("MutexLock")(id);
  EXPECT_EQ(said_by([] { abaqus<Exit>("xit_")(); }), "[called XIT]");
  EXPECT_TRUE(is_free(1));
  EXPECT_TRUE(is_free(37));
}

TEST(AbaqusHost, IdsOutOfRangeAndUnlocksTooManyDoNoHarm) {
  for (const int id : {0, -1, 101, 1 << 30}) {
    abaqus<OfC>("MutexUnlock")(id);
    abaqus<OfC>("MutexLock")(id);
    abaqus<OfC>("MutexUnlock")(id);
    abaqus<OfC>("MutexUnlock")(id);
    EXPECT_TRUE(is_free(id)) << id;
  }
}

}  // namespace
}  // namespace assay::adapters::test_host
