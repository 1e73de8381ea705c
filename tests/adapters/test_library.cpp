// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/library.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/statvfs.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "adapters/builtin.hpp"
#include "adapters/worker/probe.hpp"
#include "harness/material/material.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::adapters::test_library {
namespace {

namespace fs = std::filesystem;

const std::string plugins = built("tests/plugins/");

std::string refusal(const std::string& path, const std::string& name = {}) {
  try {
    table_of_library(path, name);
  } catch (const LibraryError& error) {
    return error.what() + (error.known().empty() ? std::string() : "; known: " + error.known());
  }
  return "accepted";
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string write_temporary(const std::string& name, const std::string& bytes) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

TEST(Library, ServesAllItsTables) {
  const auto tables = tables_of_library(plugins + "two_models.so");
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_STREQ(tables[0]->name, "first");
  EXPECT_STREQ(tables[1]->name, "second");
  EXPECT_EQ(table_of_library(plugins + "two_models.so", "second"), tables[1]);
}

TEST(Library, ARelativePathIsAFileNotASystemLibrary) {
  const fs::path before = fs::current_path();
  fs::current_path(plugins);
  EXPECT_STREQ(table_of_library("two_models.so", "first")->name, "first");
  EXPECT_EQ(refusal("libm.so.6"), "no such library");
  fs::current_path(before);
}

TEST(Library, ThePluginAnswersAsTheBuiltInModel) {
  const Material built_in(builtin_table("neo_hookean"), {{"E", 1e3}, {"nu", 0.2}});
  const assay_material* table = table_of_library(built("materials/libneo_hookean.so"), "");
  ASSERT_NE(table, builtin_table("neo_hookean"));
  const Material loaded(table, {{"E", 1e3}, {"nu", 0.2}});
  const double F0[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, F1[9] = {1.1, 0.3, 0, -0.2, 0.9, 0.1, 0, 0.05, 1.2};
  double a[9], b[9];
  built_in.update(0, 1, 1, F0, F1, nullptr, nullptr, a);
  loaded.update(0, 1, 1, F0, F1, nullptr, nullptr, b);
  for (int c = 0; c < 9; ++c) {
    EXPECT_EQ(a[c], b[c]);
    EXPECT_NE(a[c], 0);
  }
}

TEST(Library, APluginOfTheFrozenAbiLoadsForEver) {
  const assay_material* table = table_of_library(plugins + "frozen_1_0.so", "frozen");
  EXPECT_EQ(table->abi_major, 1u);
  EXPECT_EQ(table->struct_size, 112u);
  const Material material(table, std::map<std::string, double>{});
  const double F0[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, F1[9] = {1.1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto state0 = material.initial_state(1);
  double state1[1], cauchy[9];
  material.update(0, 1, 1, F0, F1, state0.data(), state1, cauchy);
  EXPECT_DOUBLE_EQ(cauchy[0], 1e3 * std::log(1.1) / 1.1);
  EXPECT_DOUBLE_EQ(state1[0], 1.1);
  EXPECT_EQ(cauchy[1], 0);
}

TEST(Library, TheFrozenHeaderIsNotEdited) {
  // Its layout is the promise: sizes and offsets of 1.0 on x86-64.
  EXPECT_EQ(bytes_of(tree_folder() + "/tests/adapters/frozen_1_0/assay_material.h").find("#define ASSAY_ABI_MINOR 0") !=
                std::string::npos,
            true);
  EXPECT_GE(sizeof(assay_material), 112u);
  EXPECT_EQ(offsetof(assay_material, parameters), 56u);
  EXPECT_EQ(offsetof(assay_material, create), 72u);
  EXPECT_EQ(offsetof(assay_material, update), 96u);
  EXPECT_EQ(offsetof(assay_material, extension), 104u);
}

TEST(Library, RefusesWithOneSentence) {
  EXPECT_EQ(refusal(plugins + "absent.so"), "no such library");
  EXPECT_EQ(refusal(plugins), "is no shared library but a folder or device");
  EXPECT_EQ(refusal("/dev/null"), "is no shared library but a folder or device");
  EXPECT_EQ(refusal(tree_folder() + "/LICENSE"), "is no shared library");
  EXPECT_EQ(refusal(write_temporary("empty.so", "")), "is no shared library");
  EXPECT_EQ(refusal(plugins + "no_entry.so"), "is no material library: it has no symbol assay_material_entry");
  EXPECT_EQ(refusal(plugins + "other_major.so"), "holds no material for ABI major 1; it serves 2");
  EXPECT_EQ(refusal(plugins + "wrong_major.so"), "cannot serve: built for ABI major 7, this host serves 1");
  EXPECT_EQ(refusal(plugins + "small_struct.so"), "cannot serve: its table has 96 bytes, ABI 1.0 has 112");
  EXPECT_EQ(refusal(plugins + "every_index.so"), "its entry returns a table for every index");
  EXPECT_EQ(refusal(plugins + "two_models.so"),
            "holds several materials; say which as FILE:NAME; known: first, second");
  EXPECT_EQ(refusal(plugins + "two_models.so", "third"), "holds no material 'third'; known: first, second");
  EXPECT_EQ(refusal(plugins + "unresolved.so"), "cannot be loaded: undefined symbol: assay_test_provided_by_nobody");
}

// The loader would map what is not there and die of SIGBUS.
TEST(Library, RefusesWhatIsTruncatedAnywhere) {
  const std::string whole = bytes_of(plugins + "two_models.so");
  ASSERT_GT(whole.size(), 4096u);
  for (std::size_t size = 0; size < 3 * whole.size() / 4; size += size < 2048 ? 61 : 509) {
    const std::string path = write_temporary("cut_" + std::to_string(size) + ".so", whole.substr(0, size));
    EXPECT_THROW(tables_of_library(path), LibraryError) << size;
    fs::remove(path);
  }
}

/// The loader says of such a file that it is not there.
TEST(Library, NamesTheMachineThatAFileIsFor) {
  const std::string whole = bytes_of(plugins + "two_models.so");
  const auto made_for = [&](int machine, bool wide, bool big) {
    std::string bytes = whole;
    bytes[4] = static_cast<char>(wide ? 2 : 1), bytes[5] = static_cast<char>(big ? 2 : 1);
    bytes[big ? 19 : 18] = static_cast<char>(machine), bytes[big ? 18 : 19] = 0;
    return refusal(write_temporary("elsewhere.so", bytes));
  };
  const std::string of_64_arm = made_for(183, true, false), of_32_x86 = made_for(3, false, false);
  EXPECT_TRUE(of_64_arm.starts_with("is for another machine: ARM of 64 bits; this one is ")) << of_64_arm;
  EXPECT_TRUE(of_32_x86.starts_with("is for another machine: x86 of 32 bits; this one is ")) << of_32_x86;
  EXPECT_TRUE(made_for(21, true, true).starts_with("is for another machine: POWER of 64 bits; "));
  EXPECT_TRUE(made_for(77, true, false).starts_with("is for another machine: number 77 of the ELF format; "));
}

TEST(Library, TheLoaderIsHelpedWhereNothingMayRun) {
  const std::string file = "/proc/version";
  struct statvfs system = {};
  if (::statvfs(file.c_str(), &system) != 0 || !(system.f_flag & ST_NOEXEC)) GTEST_SKIP() << "/proc is no such place";
  ASSERT_EQ(::dlopen(file.c_str(), RTLD_NOW), nullptr);
  EXPECT_TRUE(loader_message(file).ends_with("; its file system is mounted noexec: no code in it may run"));
  ASSERT_EQ(::dlopen((plugins + "absent.so").c_str(), RTLD_NOW), nullptr);
  EXPECT_EQ(loader_message(plugins + "absent.so").find("noexec"), std::string::npos);
}

TEST(Library, RefusesAnExecutable) { EXPECT_TRUE(refusal("/proc/self/exe").starts_with("cannot be loaded: ")); }

std::string trial(const std::string& name) {
  try {
    try_library(plugins + name + ".so");
  } catch (const LibraryError& error) {
    return error.what();
  }
  return "survived";
}

TEST(Library, ATrialTellsThatItEndsTheProcess) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(trial("entry_crashes"), "crashes when it is loaded: Aborted");
  EXPECT_EQ(trial("entry_exits"), "ends the process when it is loaded");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "") << "what it says is nobody's";
}

TEST(Library, ATrialTellsWhatLoadingWouldTell) {
  for (const char* name : {"two_models", "crashes", "exits"}) EXPECT_EQ(trial(name), "survived");
  for (const char* name : {"no_entry", "unresolved", "every_index", "small_struct", "other_major", "absent"}) {
    try {
      tables_of_library(plugins + name + ".so");
      ADD_FAILURE() << name;
    } catch (const LibraryError& error) {
      EXPECT_EQ(trial(name), error.what());
    }
  }
}

}  // namespace
}  // namespace assay::adapters::test_library
