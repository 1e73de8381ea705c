// SPDX-License-Identifier: BSD-3-Clause
// Every misbehaviour of a foreign model, through the program: survived, named, and to repeat it: assay check --replay
// its replay.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"
#include "tests/support/some_of.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_misbehaving_models {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string library = built("tests/foreign/misbehaving_umat.so");

struct Misbehaviour {
  int which;  ///< of tests/adapters/foreign/misbehaving_umat_c.c
  const char* name;
  const char* cause;  ///< that `check` names
  const char* said_by_check;
  const char* said_by_run;
};

std::ostream& operator<<(std::ostream& out, const Misbehaviour& m) { return out << m.name; }

constexpr const char *ends = "ends the process", *overrun = "overrun", *disturbs = "disturbs its process",
                     *refuses = "refuses a step";

const Misbehaviour all[] = {
    {1, "null_pointer", ends, "it used a null pointer", "it used a null pointer"},
    {2, "stop", ends, "with status 0", "with status 0, without a result"},
    {3, "endless_loop", ends, "did not return from a call within 1 s", "did not return within 1 s"},
    {4, "abort", ends, "was ended by signal 6", "was ended by signal 6"},
    {5, "stack_overflow", ends, "the stack overflowed", "the stack overflowed"},
    {7, "closes_output", disturbs, "closes or redirects standard output", "closes or redirects standard output"},
    {8, "changes_folder", disturbs, "changes the folder", "changes the folder"},
    {9, "traps_division", ends, "was ended by signal 8", "was ended by signal 8"},
    {10, "rounds_upward", disturbs, "changes the rounding mode", "changes the rounding mode"},
    {11, "overruns_statev", overrun, "writes STATEV(2:21), 1 is declared", "writes past STATEV"},
    {13, "asks_for_shorter", refuses, "PNEWDT = 0.25", "PNEWDT = 0.25"},
    {14, "calls_xit", refuses, "called XIT", "called XIT"},
    {15, "returns_nan", "stress or state not finite", "stress that is not finite", "stress that is not finite"},
    {16, "exits", ends, "with status 0", "with status 0, without a result"},
    {17, "leaves_a_process", disturbs, "leaves processes behind", "leaves processes behind"},
    {19, "kills_itself", ends, "was ended by signal 9", "was ended by signal 9"},
    {22, "ignores_signals", ends, "did not return from a call within 1 s", "did not return within 1 s"},
    {27, "leaves_a_daemon", disturbs, "leaves processes behind", "leaves processes behind"},
    {28, "kills_its_watcher", ends, "ended the process that watches it", "lost with the process that watched it"},
    {31, "blocks_termination", disturbs, "leaves signals blocked", "leaves signals blocked"},
    {32, "ignores_hangup", disturbs, "takes over signals", "takes over signals"},
#if defined(__x86_64__)
    {33, "flushes_to_zero", disturbs, "leaves denormal numbers flushed to zero", "leaves denormal numbers flushed"},
    {34, "rounds_doubles_to_zero", disturbs, "changes the rounding mode", "changes the rounding mode"},
    {35, "shortens_long_doubles", disturbs, "changes the precision of long double", "changes the precision of long"},
#endif
    {23, "closes_everything", disturbs, "closes or redirects standard output", "closes or redirects standard output"},
};

class MisbehavingModel : public testing::TestWithParam<Misbehaviour> {
 protected:
  void SetUp() override {
    if (!fs::exists(library)) GTEST_SKIP() << "no Fortran compiler";
    fs::create_directories(scratch_ / "tmp");
    const bool hangs = std::string(GetParam().said_by_check).find("within 1 s") != std::string::npos;
    const int limit = hangs ? 1 : 20;  // 4096 calls of XIT take their time under sanitizers
    model_ = scratch_.write("model.yaml", "library: " + library + "\ninterface: umat\nstate: 1\ndensity: 1000\n" +
                                              "time_limit: " + std::to_string(limit) +
                                              "\nproperties: {E: 1.0e3, nu: 0.3, which: " +
                                              std::to_string(GetParam().which) + ", from: 0.05}\n");
  }
  void TearDown() override {
    if (fs::exists(scratch_ / "tmp")) {
      EXPECT_TRUE(fs::is_empty(scratch_ / "tmp")) << "something is left behind";
    }
  }

  Ending program(const std::vector<std::string>& words) {
    return assay(words, [this] { setenv("TMPDIR", (scratch_ / "tmp").c_str(), 1); });
  }

  std::vector<std::string> run_words() const {
    return {"run",   tree_folder() + "/configs/foreign/vortex_umat.yaml",
            "-o",    scratch_ / "out",
            "--set", "material={adapter: " + model_ + "}",
            "--set", "force.tolerance=1e-4",
            "--set", "motion={type: vortex, allow_unstable: true, amplitude: {type: sine, peak: 0.05}}",
            "--set", "grid.spacing=0.1",
            "--set", "time.end=0.1",
            "--set", "expect={outcome: completed}"};
  }

  ScratchFolder scratch_;
  std::string model_;
};

/// Words as check would wrap them.
std::string one_line_of(std::string text) {
  std::string line;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\n';
    if (!space || line.empty() || line.back() != ' ') line += space ? ' ' : c;
  }
  return line;
}

TEST_P(MisbehavingModel, IsNamedByCheckAndAgainByItsReplay) {
  const Misbehaviour& m = GetParam();
  const Ending ending = program({"check", model_, "--quick", "--json", scratch_ / "check.json", "-o", scratch_ / "r"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  const Json found = Json::parse(bytes_of(scratch_ / "check.json"));
  ASSERT_FALSE(found["diagnosis"].empty());
  EXPECT_EQ(found["diagnosis"][0]["cause"], m.cause) << ending.said;
  EXPECT_NE(found["diagnosis"][0]["sentence"].get<std::string>().find(m.said_by_check), std::string::npos)
      << ending.said;
  ASSERT_FALSE(fs::is_empty(scratch_ / "r"));
  const Ending again = program({"check", "--replay", fs::directory_iterator(scratch_ / "r")->path().string()});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(one_line_of(again.said).find(m.said_by_check), std::string::npos) << again.said;
  EXPECT_EQ(again.said.find("has changed"), std::string::npos) << again.said;
}

TEST_P(MisbehavingModel, IsNamedByARunAndAgainByItsReplay) {
  const Misbehaviour& m = GetParam();
  const Ending ending = program(run_words());
  const Json found = Json::parse(bytes_of(scratch_ / "out/result.json"));
  const bool harmless = found["outcome"] == "completed";
  EXPECT_EQ(ending.status, harmless ? 0 : 1) << ending.said;
  EXPECT_EQ(harmless, m.cause == disturbs && std::string(m.said_by_run) != "changes the rounding mode") << ending.said;
  const std::string said = harmless ? found["warnings"].dump() : found["reason"].get<std::string>();
  EXPECT_NE(said.find(m.said_by_run), std::string::npos) << said;
  const Ending again = program({"check", "--replay", scratch_ / "out/replay.yaml"});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(one_line_of(again.said).find(m.said_by_run), std::string::npos) << again.said;
}

const auto cases_of_misbehaving_model = one_of_each<MisbehavingModel::ParamType>(5, testing::ValuesIn(all));
const auto name_of_misbehaving_model = [](const auto& instance) { return std::string(instance.param.name); };
INSTANTIATE_TEST_SUITE_P(Kinds, MisbehavingModel, testing::ValuesIn(cases_of_misbehaving_model.some),
                         name_of_misbehaving_model);
INSTANTIATE_TEST_SUITE_P(LongKinds, MisbehavingModel, testing::ValuesIn(cases_of_misbehaving_model.others),
                         name_of_misbehaving_model);

/// As MFront's behaviours do, compiled with assertions: in a worker that is a refusal.
TEST(AssertingModel, MayDieOfAnFThatIsNoNumber) {
  if (!fs::exists(library)) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model =
      scratch.write("model.yaml", "library: " + library + "\ninterface: umat\nstate: 1\ndensity: 1000\n" +
                                      "properties: {E: 1.0e3, nu: 0.3, which: 26, from: 0}\n");
  const Ending ending = assay({"check", model, "--quick", "--json", scratch / "check.json", "-o", scratch / "r"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  const Json found = Json::parse(bytes_of(scratch / "check.json"));
  const Json& last = found["tests"].back();
  EXPECT_EQ(last["id"], "calls.senseless");
  EXPECT_EQ(last["verdict"], "n/a");
  EXPECT_NE(last["sentence"].get<std::string>().find("was ended by signal 6"), std::string::npos);
}

/// What changes by chance does not follow from the words around the arrays.
TEST(LongUnsteadyModel, IsNotToldToReadBeyondItsArrays) {
  if (!fs::exists(library)) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  for (const char* which : {"36", "37"}) {  // by a random number, by the clock
    const std::string model =
        scratch.write("model.yaml", "library: " + library + "\ninterface: umat\nstate: 1\ndensity: 1000\n" +
                                        "properties: {E: 1.0e3, nu: 0.3, which: " + which + ", from: 0}\n");
    assay({"check", model, "--quick", "--json", scratch / "check.json", "-o", scratch / "r"});
    const Json found = Json::parse(bytes_of(scratch / "check.json"));
    ASSERT_EQ(found["diagnosis"].size(), 1u) << which;
    EXPECT_EQ(found["diagnosis"][0]["cause"], "not reproducible") << which;
  }
}

/// Abaqus would be surprised; here they are put right.
class WritingModel : public MisbehavingModel {};

TEST_P(WritingModel, IsRemarkedAndNoDefect) {
  const Ending checked = program({"check", model_, "--quick", "--json", scratch_ / "check.json", "-o", scratch_ / "r"});
  EXPECT_EQ(checked.status, 0) << checked.said;
  EXPECT_NE(bytes_of(scratch_ / "check.json").find(GetParam().said_by_check), std::string::npos);
  program(run_words());
  const Json found = Json::parse(bytes_of(scratch_ / "out/result.json"));
  EXPECT_EQ(found["outcome"], "completed");
  EXPECT_NE(found["warnings"].dump().find(GetParam().said_by_run), std::string::npos);
  EXPECT_TRUE(found["replay"].is_null());
}

INSTANTIATE_TEST_SUITE_P(Kinds, WritingModel,
                         testing::Values(Misbehaviour{25, "writes_inputs", "",
                                                      "a remark: the model writes to its inputs",
                                                      "writes to its inputs (STRAN)"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace assay::drivers::test_misbehaving_models
