// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/case_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "drivers/result/result_json.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/whole_file.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_case_store {
namespace {

namespace fs = std::filesystem;

PlannedCase made_up_case(const std::string& key = "a1") {
  PlannedCase one;
  one.number = 1, one.key = key, one.label = "method=" + key, one.yaml = "title: " + key + "\n";
  return one;
}

/// What a run leaves, with a clock.
void leave_a_result(const CaseStore& store, const PlannedCase& one, const CaseRecord& record = {}) {
  const fs::path folder = store.begin(one).parent_path();
  if (!record.stopped && record.crashed.empty()) {
    std::ofstream(folder / "result.json") << "{\"outcome\": \"completed\", \"t\": 1}\n";
    std::ofstream(folder / "errors.csv") << "t,l2\n0,0\n1," << one.key << "\n";
  }
  store.finish(one, record);
}

CaseRecord timed_record() {
  CaseRecord record;
  record.clock = {true, {0.125, 0.1}, {0.3, 0.25}, {0.2, 1.0 / 3}, {0.01, 0}, "a machine, 2 cores"};
  return record;
}

class CaseStoreTest : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& key = "a1") const {
    return scratch_ / ("out/cases/" + key + "/" + name);
  }
  CaseState state() const { return store_.state_of("a1"); }

  ScratchFolder scratch_;
  CaseStore store_{scratch_ / "out"};
};

TEST_F(CaseStoreTest, StatesOfACase) {
  EXPECT_EQ(state(), CaseState::missing);
  EXPECT_EQ(store_.state_of(""), CaseState::missing);
  store_.begin(made_up_case());
  EXPECT_EQ(bytes_of(file("case.yaml")), "title: a1\n");
  EXPECT_EQ(state(), CaseState::missing) << "no record, whatever lies there";
  leave_a_result(store_, made_up_case(), timed_record());
  EXPECT_EQ(state(), CaseState::finished);
  store_.begin(made_up_case());
  EXPECT_EQ(state(), CaseState::missing);
  EXPECT_FALSE(fs::exists(file("result.json")));
}

TEST_F(CaseStoreTest, ARunWithoutAResultHasCrashedOrWasStopped) {
  leave_a_result(store_, made_up_case(), {"it ended with status 139: \xff and \"worse\"", false, {}});
  EXPECT_EQ(state(), CaseState::crashed);
  const StudyCase crashed = store_.read(made_up_case());
  EXPECT_EQ(crashed.outcome, "crashed");
  EXPECT_EQ(crashed.reason, "it ended with status 139: \xEF\xBF\xBD and \"worse\"");
  leave_a_result(store_, made_up_case(), {"", true, {}});
  EXPECT_EQ(state(), CaseState::stopped);
  EXPECT_EQ(store_.read(made_up_case()).outcome, "stopped");
  store_.begin(made_up_case());
  store_.finish(made_up_case(), {});
  EXPECT_EQ(state(), CaseState::torn) << "neither a result nor a reason why there is none";
}

TEST_F(CaseStoreTest, TheClockComesBackAsItWas) {
  CaseRecord record = timed_record();
  record.clock.cpu_s.push_back(std::nan(""));
  leave_a_result(store_, made_up_case(), record);
  EXPECT_EQ(state(), CaseState::finished);
  const ClockReadings clock = store_.read(made_up_case()).clock;
  EXPECT_TRUE(clock.alone);
  EXPECT_EQ(clock.step_s, (std::vector<double>{0.125, 0.1}));
  EXPECT_EQ(clock.wall_s, (std::vector<double>{0.2, 1.0 / 3}));
  EXPECT_EQ(clock.machine, "a machine, 2 cores");
}

// Every byte of the record and of the results counts, but for blanks of the record; here each third.
TEST_F(CaseStoreTest, AnyByteThatTurnsIsNoticed) {
  leave_a_result(store_, made_up_case(), timed_record());
  for (const char* name : {"case.json", "result.json", "errors.csv", "case.yaml"}) {
    const std::string whole = bytes_of(file(name));
    for (std::size_t k = 0; k < whole.size(); k += 3) {
      if (name == std::string("case.json") && std::isspace(static_cast<unsigned char>(whole[k]))) continue;
      std::string turned = whole;
      turned[k] ^= 1;
      std::ofstream(file(name), std::ios::binary) << turned;
      ASSERT_EQ(state(), CaseState::torn) << name << ", byte " << k << " of " << whole;
    }
    std::ofstream(file(name), std::ios::binary) << whole;
    ASSERT_EQ(state(), CaseState::finished);
  }
}

TEST_F(CaseStoreTest, AnyLengthThatIsMissingIsNoticed) {
  leave_a_result(store_, made_up_case(), timed_record());
  for (const char* name : {"case.json", "result.json", "errors.csv"}) {
    const std::string whole = bytes_of(file(name));
    for (std::size_t length = 0; length + 1 < whole.size(); length += 7) {
      std::ofstream(file(name), std::ios::binary) << whole.substr(0, length);
      ASSERT_EQ(state(), CaseState::torn) << name << ", " << length << " bytes";
    }
    std::ofstream(file(name), std::ios::binary) << whole + "x";
    EXPECT_EQ(state(), CaseState::torn) << name;
    std::ofstream(file(name), std::ios::binary) << whole;
  }
  EXPECT_EQ(state(), CaseState::finished);
}

TEST_F(CaseStoreTest, FilesThatAreGoneOrSomethingElseAreNoticed) {
  for (const char* name : {"result.json", "errors.csv", "case.json"}) {
    const bool is_record = name == std::string("case.json");
    leave_a_result(store_, made_up_case(), timed_record());
    fs::remove(file(name));
    EXPECT_EQ(state(), is_record ? CaseState::missing : CaseState::torn) << name;
    fs::create_directories(file(name) + "/deep");
    EXPECT_EQ(state(), CaseState::torn) << name;
    EXPECT_EQ(store_.read(made_up_case()).outcome, "missing");
    leave_a_result(store_, made_up_case(), timed_record());
    EXPECT_EQ(state(), CaseState::finished) << name << ": a folder is in the way";
  }
}

TEST_F(CaseStoreTest, TheResultOfAnotherCaseIsNoticed) {
  leave_a_result(store_, made_up_case(), timed_record());
  leave_a_result(store_, made_up_case("b2"), timed_record());
  const std::string own = bytes_of(file("case.json"));
  std::ofstream(file("case.json")) << bytes_of(file("case.json", "b2"));
  EXPECT_EQ(state(), CaseState::torn);
  std::ofstream(file("case.json")) << own;
  EXPECT_EQ(state(), CaseState::finished);
  std::ofstream(file("errors.csv")) << bytes_of(file("errors.csv", "b2"));
  EXPECT_EQ(state(), CaseState::torn);
  for (const char* name : {"case.json", "case.yaml", "result.json", "errors.csv"})
    std::ofstream(file(name)) << bytes_of(file(name, "b2"));
  EXPECT_EQ(state(), CaseState::torn) << "whole, and of another key";
}

TEST_F(CaseStoreTest, JsonThatIsNoRecordIsNoticed) {
  leave_a_result(store_, made_up_case());
  for (const char* text : {"", "null", "[]", "{}", "{\"key\": \"a1\"}", "{\"key\": 7}", "\"a1\"",
                           "{\"key\": \"a1\", \"files\": {}, \"clock\": {}, \"crashed\": \"\", \"stopped\": true}"}) {
    std::ofstream(file("case.json")) << text;
    EXPECT_EQ(state(), CaseState::torn) << text;
  }
}

TEST_F(CaseStoreTest, JsonThatIsNestedDeeplyIsTorn) {
  leave_a_result(store_, made_up_case(), {});
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  write_file(file("case.json"),
             R"({"key":"KEY","threads":1,"crashed":"","stopped":false,"clock":{},"files":{},"x":)" + deep + "}");
  EXPECT_EQ(state(), CaseState::torn);
  EXPECT_FALSE(read_result_json("{\"outcome\": \"completed\", \"x\": " + deep + "}"));
}

TEST_F(CaseStoreTest, AFolderThatIsALinkIsNotCleared) {
  const ScratchFolder elsewhere;
  elsewhere.write("precious", "x");
  fs::create_directories(store_.folder_of(made_up_case().key).parent_path());
  fs::create_directory_symlink(elsewhere / "", store_.folder_of(made_up_case().key));
  EXPECT_THROW(store_.begin(made_up_case()), SystemError);
  EXPECT_TRUE(fs::exists(elsewhere / "precious"));
}

TEST_F(CaseStoreTest, BeginLeavesNothingOfAnEarlierAttempt) {
  leave_a_result(store_, made_up_case());
  fs::create_directories(file("repeat"));
  std::ofstream(file("repeat/result.json")) << "{}";
  std::ofstream(file("particles_0001.vtu")) << "old";
  store_.begin(made_up_case());
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch_ / "out/cases/a1")) names.push_back(entry.path().filename());
  EXPECT_EQ(names, std::vector<std::string>{"case.yaml"});
}

TEST_F(CaseStoreTest, OneLockForACase) {
  auto held = store_.lock(made_up_case());
  ASSERT_TRUE(held);
  EXPECT_FALSE(store_.lock(made_up_case()));
  EXPECT_TRUE(store_.lock(made_up_case("b2")));
  const CaseLock moved = std::move(*held);
  held.reset();
  EXPECT_FALSE(store_.lock(made_up_case())) << "what was moved from holds nothing";
}

TEST_F(CaseStoreTest, TakesFromAnotherFolderWhatIsWholeThere) {
  const CaseStore other(scratch_ / "other");
  EXPECT_FALSE(store_.take(made_up_case(), other));
  leave_a_result(other, made_up_case(), timed_record());
  EXPECT_FALSE(store_.take(made_up_case(), other, CaseState::crashed));
  EXPECT_TRUE(store_.take(made_up_case(), other));
  EXPECT_EQ(state(), CaseState::finished);
  EXPECT_EQ(bytes_of(file("case.json")), bytes_of(scratch_ / "other/cases/a1/case.json"));
  EXPECT_TRUE(store_.take(made_up_case(), store_)) << "itself";
  EXPECT_EQ(state(), CaseState::finished);
  store_.begin(made_up_case());
  std::ofstream(scratch_ / "other/cases/a1/errors.csv") << "cut";
  EXPECT_FALSE(store_.take(made_up_case(), other));
  EXPECT_EQ(state(), CaseState::missing);
}

TEST_F(CaseStoreTest, TakesNothingInPlaceOfACaseThatIsBeingRun) {
  const CaseStore other(scratch_ / "other");
  leave_a_result(other, made_up_case(), {"it crashed", false, {}});
  {
    const auto held = store_.lock(made_up_case());
    EXPECT_FALSE(store_.take(made_up_case(), other, CaseState::crashed));
  }
  EXPECT_TRUE(store_.take(made_up_case(), other, CaseState::crashed));
  EXPECT_EQ(store_.read(made_up_case()).reason, "it crashed");
}

TEST_F(CaseStoreTest, AFolderThatCannotBeMadeIsOneLine) {
  scratch_.write("out", "a file");
  for (const std::function<void()>& attempt : {std::function<void()>([&] { store_.begin(made_up_case()); }),
                                               std::function<void()>([&] { store_.lock(made_up_case()); })}) {
    try {
      attempt();
      FAIL();
    } catch (const SystemError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(scratch_ / "out", 0), 0U) << error.what();
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_case_store
