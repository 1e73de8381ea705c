// SPDX-License-Identifier: BSD-3-Clause
// A native model that goes to another folder, lowers limits, or changes how numbers are rounded: results lie where the
// user said, and it is named.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/misdeeds.hpp"
#include "tests/support/some_of.hpp"
#include "tests/support/wait.hpp"

namespace assay::drivers::test_own_files {
namespace {

namespace fs = std::filesystem;

struct Deed {
  const char *deed, *words;
};

class Disturbing : public testing::TestWithParam<Deed> {
 protected:
  Ending program(std::vector<std::string> words) const {
    return assay(words, [this] {
      the_.arm(GetParam().deed);
      if (::chdir((the_.scratch / "").c_str()) != 0) ::_exit(126);
    });
  }
  Misdeeds the_;
};

TEST_P(Disturbing, ARunIsWhereTheUserSaidAndWarns) {
  std::vector<std::string> words = the_.run_words(the_.library);
  words[3] = "out";  // -o
  const Ending ending = program(words);
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(fs::exists(the_.scratch / "out/errors.csv"));
  EXPECT_NE(bytes_of(the_.scratch / "out/result.json").find("the model " + std::string(GetParam().words)),
            std::string::npos)
      << ending.said;
}

TEST_P(Disturbing, ACheckIsWhereTheUserSaidAndNamesIt) {
  const Ending ending = program({"check", the_.library, "--quick", "--json", "check.json", "-o", "r"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  std::string sentence;
  const auto found = nlohmann::json::parse(bytes_of(the_.scratch / "check.json"));
  for (const auto& each : found["diagnosis"]) {
    if (each["cause"] == "disturbs its process") sentence = each["sentence"];
  }
  EXPECT_EQ(sentence, "the model " + std::string(GetParam().words));
  EXPECT_TRUE(fs::exists(the_.scratch / "r/misdeeds.calls.process.yaml"));
  EXPECT_NE(ending.said.find("r/misdeeds.calls.process.yaml"), std::string::npos) << ending.said;
}

constexpr const char *folder = "changes the folder of the process", *limits = "changes the limits of the process",
                     *rounding = "changes the rounding mode of the process";
const auto cases_of_disturbing = one_of_each<Disturbing::ParamType>(
    3, testing::Values(Deed{"load chdir", folder}, Deed{"create chdir", folder}, Deed{"each chdir", folder},
                       Deed{"create few_files", limits}, Deed{"create small_files", limits},
                       Deed{"update small_files", limits}, Deed{"create round", rounding},
                       Deed{"create round_down", rounding}));
const auto name_of_disturbing = [](const auto& instance) {
  std::string name = instance.param.deed;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(Deeds, Disturbing, testing::ValuesIn(cases_of_disturbing.some), name_of_disturbing);
INSTANTIATE_TEST_SUITE_P(LongDeeds, Disturbing, testing::ValuesIn(cases_of_disturbing.others), name_of_disturbing);

// What cannot be raised again stays so: the verdict comes all the same, and a run says who has done it.
TEST(HardLimit, OfAModelIsBlamedOnIt) {
  const Misdeeds the;
  const Ending check =
      the.program({"check", the.library, "--quick", "-o", the.scratch / "r"}, "create small_files_ever");
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_NE(check.said.find(limits), std::string::npos) << check.said;
  const Ending run = the.program(the.run_words(the.library), "create small_files_ever");
  // what it says is a file of as few bytes
  EXPECT_TRUE(run.status == 0 || run.said.find("; the material's library h") != std::string::npos) << run.said;
}

TEST(HardLimit, OfMemoryIsBlamedOnTheModel) {
  if (sanitized()) GTEST_SKIP() << "the sanitizer itself needs more";
  const Misdeeds the;
  const Ending run = the.program(the.run_words(the.library), "create little_memory_ever");
  EXPECT_TRUE(run.status == 0 || run.said.find("has lowered limits of the process: memory") != std::string::npos)
      << run.status << ": " << run.said;
}

// What the user asked for does not end in a file of the model.
class StolenOutput : public testing::TestWithParam<const char*> {};

TEST_P(StolenOutput, IsTheUsersAgain) {
  const Misdeeds the;
  std::vector<std::string> words = the.run_words(the.library);
  words.push_back("--json");
  const Ending run = the.program(words, GetParam());
  EXPECT_EQ(run.status, 0) << run.said;
  EXPECT_NE(run.said.find("\"outcome\": \"completed\""), std::string::npos) << run.said;
  EXPECT_NE(run.said.find("closes or redirects standard output"), std::string::npos) << run.said;
  EXPECT_EQ(bytes_of(the.scratch / "late"), "");
  std::vector<std::string> eval = the.eval_words(the.library);
  eval[5] = "-";
  const Ending table = the.program(eval, GetParam());
  EXPECT_EQ(table.status, 0) << table.said;
  EXPECT_NE(table.said.find("X,Y,t"), std::string::npos) << table.said;
}

INSTANTIATE_TEST_SUITE_P(Deeds, StolenOutput,
                         testing::Values("load steal", "create steal", "update steal", "create steal_all",
                                         "update steal_all"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

/// A stream of wide characters takes no others.
TEST(WideOutput, LosesNothing) {
  for (const char* when : {"load wide", "create wide", "update wide"}) {
    const Misdeeds the;
    std::vector<std::string> words = the.run_words(the.library);
    words.push_back("--json");
    const Ending run = the.program(words, when);
    EXPECT_EQ(run.status, 0) << run.said;
    EXPECT_NE(run.said.find("\"outcome\": \"completed\""), std::string::npos) << when << ": " << run.said;
  }
}

class IgnoredSignals : public testing::TestWithParam<const char*> {};

TEST_P(IgnoredSignals, AreNamedAtOnce) {
  const Misdeeds the;
  const Stopwatch watch;
  const Ending ending = the.program({"check", the.library, "--quick", "-o", the.scratch / "r"}, GetParam());
  EXPECT_LT(watch.seconds(), nobody_waited_s);
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_NE(ending.said.find("takes over signals"), std::string::npos) << ending.said;
  EXPECT_TRUE(the.nothing_is_left());
}

INSTANTIATE_TEST_SUITE_P(Deeds, IgnoredSignals,
                         testing::Values("load ignore_children", "create ignore_children", "create ignore_all",
                                         "update ignore_all"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(TemporaryFolder, ThatTakesNoFilesIsNamed) {
  const Misdeeds the;
  for (const std::string& folder : {std::string("/nonexistent"), the.points, std::string("/proc")}) {
    const Ending run =
        assay(the.run_words(built("tests/plugins/prints.so")), [&] { ::setenv("TMPDIR", folder.c_str(), 1); });
    EXPECT_EQ(run.status, 3) << run.said;
    EXPECT_NE(run.said.find("$TMPDIR, '" + folder + "', is no folder for temporary files"), std::string::npos)
        << run.said;
  }
}

/// Words after which a table or a document goes to standard output.
struct ToOutput {
  const char* name;
  std::vector<std::string> words;
};

class PrintingModel : public testing::TestWithParam<ToOutput> {
 protected:
  /// What lies on standard output; `with`: a part of what must lie on standard error.
  std::string output(const std::string& library, const std::string& with) const {
    const Misdeeds the;
    std::vector<std::string> words{GetParam().words.front(), the.scene};
    words.insert(words.end(), GetParam().words.begin() + 1, GetParam().words.end());
    if (words.front() == "eval") words.insert(words.end(), {"--points", the.points});
    if (words.front() == "run") words.insert(words.end(), {"-o", the.scratch / "out"});
    for (const char* set : {"motion.amplitude.peak=0.05", "grid.spacing=0.25", "time.end=0.02"})
      words.insert(words.end(), {"--set", set});
    words.insert(words.end(),
                 {"--set", "material={adapter: " + library + ", parameters: {E: 1.0e3, nu: 0.3}, density: 1000}"});
    const std::string out = the.scratch / "output";
    const Ending ending =
        assay(words, [&] { ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600), STDOUT_FILENO); });
    EXPECT_NE(ending.said.find(with), std::string::npos) << ending.said;
    return bytes_of(out);
  }
};

TEST_P(PrintingModel, SpoilsNoTable) {
  const std::string printed = output(built("tests/plugins/prints.so"), "which is all very well");
  EXPECT_EQ(printed.find("which is all very well"), std::string::npos) << printed;
  if (GetParam().words.front() == "run")  // times differ
    EXPECT_TRUE(nlohmann::json::accept(printed)) << printed;
  else
    EXPECT_EQ(printed, output("neo_hookean", ""));
}

INSTANTIATE_TEST_SUITE_P(Doors, PrintingModel,
                         testing::Values(ToOutput{"eval", {"eval"}}, ToOutput{"eval_to_a_dash", {"eval", "-o", "-"}},
                                         ToOutput{"eval_to_a_device", {"eval", "-o", "/dev/stdout"}},
                                         ToOutput{"eval_to_a_number", {"eval", "-o", "/dev/fd/1"}},
                                         ToOutput{"run_as_json", {"run", "--json"}}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace assay::drivers::test_own_files
