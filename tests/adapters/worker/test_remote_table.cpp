// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/remote_table.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "adapters/builtin.hpp"
#include "harness/material/material.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"
#include "tests/support/built.hpp"
#include "tests/support/wait.hpp"

namespace assay::adapters::test_remote_table {
namespace {

namespace fs = std::filesystem;

WorkerStart start_with(const std::string& description) { return {"model\ntest.yaml\n" + description}; }

std::string misbehaving() {
  return "library: " + double_library("misbehaving_umat") +
         "\ninterface: umat\nname: misbehaving\nproperties: {E: 1.0e3, nu: 0.3, which: 0, from: 0}\nstate: 1\n";
}

/// Workers keep their folders in one of this test's own.
class RemoteTable : public testing::Test {
 protected:
  void SetUp() override {
    if (!double_exists("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
    folder_ = (fs::temp_directory_path() / ("assay-test-remote-" + std::to_string(::getpid()))).string();
    fs::create_directories(folder_);
    setenv("TMPDIR", folder_.c_str(), 1);
  }
  void TearDown() override {
    end_workers();
    unsetenv("TMPDIR");
    if (folder_.empty()) return;
    EXPECT_TRUE(fs::is_empty(folder_)) << "a worker has left something in " << folder_;
    fs::remove_all(folder_);
  }

  /// One step of a little shear of one point that has been there for that time.
  UpdateReport step(const Material& material, double t) {
    const double F0[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, F1[9] = {1, 1e-3, 0, 0, 1, 0, 0, 0, 1};
    constexpr std::size_t age = 15;  // of a UMAT's own state
    std::vector<double> state0 = material.initial_state(1), state1(state0.size());
    state0[age] = t;
    return material.update(t, 0.1, 1, F0, F1, state0.data(), state1.data(), cauchy_);
  }

  std::string folder_;
  double cauchy_[9] = {};
};

struct Misbehaviour {
  int which;
  const char* words;
};

class Misbehaves : public RemoteTable, public testing::WithParamInterface<Misbehaviour> {};

TEST_P(Misbehaves, AndIsNamedAndSurvived) {
  WorkerStart start = start_with(misbehaving());
  start.limits.seconds = 1;
  const Material material(remote_table(start), {{"which", GetParam().which}, {"from", 0.5}});
  EXPECT_EQ(step(material, 0).worst, ASSAY_GOOD);
  const double shear = cauchy_[1];
  EXPECT_NE(shear, 0);
  const Stopwatch watch;
  const UpdateReport report = step(material, 1);
  EXPECT_LT(watch.seconds(), nobody_waited_s);
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_NE(report.message.find(GetParam().words), std::string::npos) << report.message;
  EXPECT_EQ(step(material, 0).worst, ASSAY_GOOD) << "the next call goes to a new worker";
  EXPECT_EQ(cauchy_[1], shear);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Misbehaves,
    testing::Values(Misbehaviour{1, "was ended by signal 11"},
                    Misbehaviour{2, "ended the process with status 0, without a result"},
                    Misbehaviour{3, "did not return within 1 s"}, Misbehaviour{4, "was ended by signal 6"},
                    Misbehaviour{5, "the stack overflowed"}, Misbehaviour{9, "was ended by signal 8"},
                    Misbehaviour{10, "changes the rounding mode"}, Misbehaviour{11, "writes past STATEV"},
                    Misbehaviour{13, "PNEWDT = 0.25"}, Misbehaviour{29, "not a number: PNEWDT"},
                    Misbehaviour{14, "called XIT"}, Misbehaviour{15, "stress that is not finite"},
                    Misbehaviour{16, "with status 0, without a result"}, Misbehaviour{19, "was ended by signal 9"},
                    Misbehaviour{22, "did not return within 1 s"}),
    [](const auto& instance) { return "number_" + std::to_string(instance.param.which); });

#if !defined(__SANITIZE_ADDRESS__) && !(defined(__has_feature) && __has_feature(address_sanitizer))
INSTANTIATE_TEST_SUITE_P(Memory, Misbehaves, testing::Values(Misbehaviour{6, "more than 4 GB of memory"}),
                         [](const auto& instance) { return "number_" + std::to_string(instance.param.which); });
#endif

class Harmless : public RemoteTable, public testing::WithParamInterface<int> {};

TEST_P(Harmless, AndGoesOn) {
  const Material material(remote_table(start_with(misbehaving())), {{"which", GetParam()}, {"from", 0.5}});
  for (const double t : {0., 1., 2., 3.}) EXPECT_EQ(step(material, t).worst, ASSAY_GOOD) << t;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Harmless,
                         testing::Values(7,    // closes standard output
                                         8,    // changes its folder
                                         12,   // prints 100 MB
                                         17,   // leaves a process behind
                                         18,   // writes files where it stands
                                         23),  // closes all files
                         [](const auto& instance) { return "number_" + std::to_string(instance.param); });

TEST_F(RemoteTable, ForwardsWhatANativeModelOffers) {
  const std::string library = built("materials/libneo_hookean.so");
  const Material here(builtin_table("neo_hookean"), {{"E", 1e3}, {"nu", 0.3}});
  const Material there(remote_table(start_with("library: " + library + "\n")), {{"E", 1e3}, {"nu", 0.3}});
  EXPECT_EQ(there.name(), "neo_hookean");
  EXPECT_EQ(there.table().parameter_count, here.table().parameter_count);
  for (const char* id : {ASSAY_EXTENSION_RATE, ASSAY_EXTENSION_TANGENT, ASSAY_EXTENSION_ENERGY,
                         ASSAY_EXTENSION_WAVE_SPEED, ASSAY_EXTENSION_CLOSED_FORM}) {
    EXPECT_EQ(extension_of(&there.table(), id) == nullptr, extension_of(&here.table(), id) == nullptr) << id;
  }
  const double F[9] = {1.1, 0.2, 0, 0, 0.9, 0.1, 0, 0, 1};
  double expected = 0, found = 0;
  here.extension<assay_energy>(ASSAY_EXTENSION_ENERGY)->energy(here.self(), 1, F, nullptr, &expected);
  there.extension<assay_energy>(ASSAY_EXTENSION_ENERGY)->energy(there.self(), 1, F, nullptr, &found);
  EXPECT_EQ(found, expected);
  EXPECT_GT(found, 0);
}

TEST_F(RemoteTable, KeepsTheClassOfSymmetry) {
  const auto class_of = [](const assay_material* table) {
    const auto* said = static_cast<const assay_symmetry*>(extension_of(table, ASSAY_EXTENSION_SYMMETRY));
    return said && said->struct_size == sizeof(assay_symmetry) ? said->material_class : 0;
  };
  const auto there = [](const std::string& task) { return remote_table(start_with(task + "\n")); };
  const std::string native = "library: " + built("materials/libneo_hookean.so");
  const std::string wood = "library: " + built("materials/liborthotropic_cylindrical.so");
  const std::string crystal = "library: " + double_library("umat_crystal") + "\ninterface: umat\n";
  EXPECT_EQ(class_of(there(native)), 0);
  EXPECT_EQ(class_of(there(wood)), ASSAY_ORTHOTROPIC);
  EXPECT_EQ(class_of(there(crystal + "symmetry: cubic")), ASSAY_CUBIC);
  EXPECT_EQ(class_of(there(crystal + "symmetry: anisotropic")), 0);
}

/// A batch of points of which the last but one is sheared too far.
UpdateReport batch_with_a_bad_point(const std::string& plugin, std::size_t n, std::size_t bad) {
  const std::string library = built("tests/plugins/") + plugin;
  const Material material(remote_table(start_with("library: " + library + "\n")), {});
  std::vector<double> F0(9 * n), F1(9 * n), cauchy(9 * n);
  for (const std::size_t d : {0, 4, 8}) std::fill_n(F0.begin() + static_cast<std::ptrdiff_t>(d * n), n, 1.0);
  F1 = F0;
  F1[n + bad] = 0.5;
  return material.update(0, 1, n, F0.data(), F1.data(), nullptr, nullptr, cauchy.data());
}

TEST_F(RemoteTable, APointThatEndsANativeModelIsFoundInItsBatch) {
  const UpdateReport report = batch_with_a_bad_point("crashes_when_sheared.so", 40, 38);
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_EQ(report.worst_point, 38u);
  EXPECT_NE(report.message.find("was ended by signal 6"), std::string::npos) << report.message;
}

/// A field at the end of the step is that of each point alone, too.
TEST_F(RemoteTable, APointThatEndsTheModelByItsFieldIsFoundInItsBatch) {
  constexpr std::size_t n = 3;
  Material material(remote_table(start_with("library: " + built("tests/plugins/crashes_when_hot.so") + "\n")), {});
  material.prescribe({{"temperature", [](double t) { return 300 + 100 * t; }}});
  std::vector<double> F(9 * n), state0 = material.initial_state(n), state1(n), cauchy(9 * n);
  for (const std::size_t d : {0, 4, 8}) std::fill_n(F.begin() + static_cast<std::ptrdiff_t>(d * n), n, 1.0);
  const UpdateReport report = material.update(0, 1, n, F.data(), F.data(), state0.data(), state1.data(), cauchy.data());
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_NE(report.message.find("was ended by signal 6"), std::string::npos) << report.message;
  EXPECT_EQ(report.message.find("by none of them alone"), std::string::npos) << report.message;
}

TEST_F(RemoteTable, ABatchOfWhichNoPointAloneEndsTheModelIsTold) {
  const UpdateReport report = batch_with_a_bad_point("crashes_in_a_run.so", 70, 38);
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_NE(report.message.find("in a batch of 70 points, by none of them alone"), std::string::npos) << report.message;
}

TEST_F(RemoteTable, SaysWhyThereIsNone) {
  try {
    remote_table(start_with("library: " + double_library("misbehaving_umat") + "\ninterface: umat\nsymbol: umap_\n"));
    FAIL();
  } catch (const ModelRefused& error) {
    EXPECT_EQ(error.key(), "symbol");
    EXPECT_NE(error.known().find("umat_"), std::string::npos);
  }
}

TEST_F(RemoteTable, KeepsWhatIsPrinted) {
  const assay_material* table = remote_table(start_with(misbehaving()));
  const Material material(table, {{"which", 12}, {"from", 0.5}});
  step(material, 1);
  end_workers();
  step(material, 0);
  const std::string printed = marks_of(table).printed;
  EXPECT_LT(printed.size(), 1u << 16);
  EXPECT_NE(printed.find("bytes are left out"), std::string::npos) << printed.substr(0, 200);
}

}  // namespace
}  // namespace assay::adapters::test_remote_table
