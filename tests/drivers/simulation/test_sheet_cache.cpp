// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/sheet_cache.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_sheet_cache {
namespace {

const char* const scene_text = R"(
motion: {type: vortex, amplitude: {type: sine, peak: 0.05}}
material: {adapter: j2_jaumann, parameters: {E: 1000, nu: 0.3, yield_stress: 10, hardening_modulus: 50}, density: 1000}
force: {tolerance: 1.0e-4}
)";

class Cached : public testing::Test {
 protected:
  Cached() : scene_(read_scene(home_.write("cached.yaml", scene_text))) {
    ::setenv("ASSAY_CACHE_HOME", (home_ / "cache").c_str(), 1);
    std::string library;
    material_ = material_of(scene_, library);
    path_ = baseline_path(scene_);
  }

  std::shared_ptr<const Response> response() const { return response_of(scene_, material_, path_, 1); }
  std::string file() const { return SheetCache(scene_, *material_, path_, 1).file(); }

  ScratchFolder home_;
  Scene scene_;
  std::shared_ptr<const Material> material_;
  Path path_;
};
using LongCached = Cached;

TEST_F(Cached, ASheetIsMadeOnceAndIsTheSameFromDisk) {
  const auto first = response(), second = response();
  EXPECT_FALSE(first->sheet()->restored());
  EXPECT_TRUE(second->sheet()->restored());
  EXPECT_EQ(first->sheet()->points(), second->sheet()->points());
  EXPECT_EQ(first->sheet()->error_tau(), second->sheet()->error_tau());
  EXPECT_EQ(first->at_time(0.3)->fronts(), second->at_time(0.3)->fronts());
  for (const double t : {0.1, 0.5, 0.93}) {
    Tensor tau[2], slope[2];
    first->at(-1.7, t, tau[0], slope[0]);
    second->at(-1.7, t, tau[1], slope[1]);
    EXPECT_EQ(tau[0], tau[1]);
    EXPECT_EQ(slope[0], slope[1]);
  }
}

/// They agree at every row, and where a component is held.
TEST_F(Cached, TheInterpolationOfATableIsInTheName) {
  std::vector<double> times;
  std::vector<Tensor> F(3, Tensor::Identity());
  for (int k = 0; k < 3; ++k) times.push_back(0.5 * k);
  F[1](0, 1) = F[2](0, 1) = 0.1;
  std::set<std::string> files;
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone, Interpolation::spline}) {
    path_ = DeformationTable("rows.csv", times, F, kind).baseline();
    EXPECT_TRUE(files.insert(file()).second) << static_cast<int>(kind);
  }
  path_ = DeformationTable("elsewhere.csv", times, F, Interpolation::linear).baseline();
  EXPECT_TRUE(files.contains(file())) << "the same rows of another file";
}

TEST_F(Cached, EverythingThatMattersIsInTheName) {
  const std::string before = file();
  EXPECT_EQ(file(), before);
  scene_.force.tolerance = 1e-5;
  EXPECT_NE(file(), before);
  scene_.force.tolerance = 1e-4;
  scene_.motion.as<Vortex>()->amplitude.peak = 0.06;
  path_ = baseline_path(scene_);
  EXPECT_NE(file(), before);
  scene_.motion.as<Vortex>()->amplitude.peak = 0.05;
  path_ = baseline_path(scene_);
  EXPECT_EQ(file(), before);
  // of every period as much as of the first: equal times would all meet the zeros of g
  scene_.time.end = 32;
  scene_.motion.as<Vortex>()->amplitude.type = Amplitude::Type::one_minus_cosine;
  const auto of_peak = [&](double peak) {
    scene_.motion.as<Vortex>()->amplitude.peak = peak;
    return SheetCache(scene_, *material_, baseline_path(scene_), 32).file();
  };
  EXPECT_NE(of_peak(0.02), of_peak(0.05));
  scene_.material.parameters["yield_stress"] = 11;
  std::string library;
  material_ = material_of(scene_, library);
  EXPECT_NE(file(), before);
}

TEST_F(Cached, ALibraryThatTheMaterialsNeedsIsInTheName) {
  for (const std::string name : {"asks_a_helper.so", "libhelper.so"})
    std::filesystem::copy(built("tests/plugins/" + name), home_ / name);
  scene_.material.adapter = home_ / "asks_a_helper.so";
  scene_.material.parameters = {};
  std::string library;
  material_ = material_of(scene_, library);
  const std::string before = file();
  EXPECT_EQ(file(), before);
  std::ofstream(home_ / "libhelper.so", std::ios::app | std::ios::binary) << '\0';  // the loader does not mind
  EXPECT_NE(file(), before);
}

TEST_F(Cached, AModelThatAnswersOtherwiseNowIsAskedAgain) {
  scene_.material.adapter = built("tests/plugins/asks_its_environment.so");
  scene_.material.parameters = {};
  std::string library;
  material_ = material_of(scene_, library);
  const auto stress = [](const Response& response) {
    Tensor tau, slope;
    response.at(-1.7, 0.3, tau, slope);
    return tau(0, 1);
  };
  ::unsetenv("ASSAY_TEST_SHARE");
  const double before = stress(*response());
  EXPECT_TRUE(response()->sheet()->restored()) << "where nothing has changed";
  for (const char* share : {"1.001", "30", "1"}) {
    const Environment variable("ASSAY_TEST_SHARE", share);
    const auto other = response();
    EXPECT_FALSE(other->sheet()->restored()) << share;
    EXPECT_NEAR(stress(*other), std::atof(share) * before, 1e-4 * std::atof(share) * std::abs(before));
    EXPECT_TRUE(response()->sheet()->restored()) << share;
  }
}

TEST_F(Cached, ADamagedFileIsMadeAgain) {
  response();
  std::fstream damaged(file(), std::ios::in | std::ios::out | std::ios::binary);
  damaged.seekp(200);
  damaged.put('x');
  damaged.close();
  EXPECT_FALSE(SheetCache(scene_, *material_, path_, 1).load());
  EXPECT_FALSE(response()->sheet()->restored());
  EXPECT_TRUE(response()->sheet()->restored());
  std::filesystem::resize_file(file(), 90);
  EXPECT_FALSE(SheetCache(scene_, *material_, path_, 1).load());
}

TEST_F(Cached, AFileUnderTheNameOfAnotherIsNotTaken) {
  response();
  const std::string of_one = file();
  scene_.material.parameters["yield_stress"] = 11;
  std::string library;
  material_ = material_of(scene_, library);
  std::filesystem::copy_file(of_one, file());
  EXPECT_FALSE(response()->sheet()->restored());
  EXPECT_TRUE(response()->sheet()->restored());
}

TEST_F(Cached, WhatALinkLeadsToIsLeftAlone) {
  const std::string own = home_.write("own.txt", "mine\n");
  std::filesystem::create_directories(std::filesystem::path(file()).parent_path());
  std::filesystem::create_symlink(own, file());
  EXPECT_FALSE(response()->sheet()->restored());
  EXPECT_EQ(bytes_of(own), "mine\n");
  EXPECT_TRUE(response()->sheet()->restored());
}

TEST_F(Cached, NothingIsKeptWhereTheSceneSaysSoOrTheDiskDoesNot) {
  scene_.force.cache = false;
  response();
  EXPECT_FALSE(std::filesystem::exists(home_ / "cache"));
  scene_.force.cache = true;
  home_.write("cache", "a file where the folder should be");
  EXPECT_FALSE(response()->sheet()->restored());
  EXPECT_FALSE(response()->sheet()->restored());
}

/// The library of a built-in model is the program, whatever name it was called by.
TEST_F(LongCached, ASheetOfABuiltInModelIsKeptByAProgramThatPathFinds) {
  for (const bool cached : {false, true}) {
    const Ending ending = assay({"tabulate", home_ / "cached.yaml", "--json", "--quiet", "-o", home_ / "out"});
    ASSERT_EQ(ending.status, 0) << ending.said;
    const auto result = nlohmann::json::parse(ending.said.substr(ending.said.find('{')));
    EXPECT_EQ(result["sheet"]["cached"].get<bool>(), cached);
  }
}

TEST_F(Cached, AFailureIsNotKept) {
  scene_.material.adapter = built("tests/plugins/fails_when_sheared.so");
  scene_.material.parameters = {{"modulus", 0.1}};  // which sets its limit
  std::string library;
  material_ = material_of(scene_, library);
  EXPECT_THROW(response(), MaterialFailure);
  EXPECT_FALSE(std::filesystem::exists(home_ / "cache"));
}

}  // namespace
}  // namespace assay::drivers::test_sheet_cache
