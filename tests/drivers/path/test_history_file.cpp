// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "drivers/path/path_function.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_history_file {
namespace {

PathFunction read(const std::string& text, const std::string& column, const std::string& time = "t",
                  HistoryKind kind = HistoryKind::number) {
  const ScratchFolder scratch;
  PathFunction f;
  f.type = PathFunction::Type::file;
  f.file = scratch.write("data.csv", text), f.column = column, f.time = time;
  f.where = {"path.yaml", 3, 7};
  read_history_file(f, column, "path.control.e11", kind);
  return f;
}

std::string refusal_of(const std::string& text, const std::string& column, const std::string& time = "t") {
  try {
    read(text, column, time);
    return "taken";
  } catch (const InputError& error) {
    return error.what();
  }
}

using Values = std::vector<double>;

TEST(HistoryFile, ReadsWhatPeopleExport) {
  EXPECT_EQ(read("t,e\n0,1\n2,3\n", "e").values, (Values{1, 3}));
  EXPECT_EQ(read("\xEF\xBB\xBFt;e\n0;1,5\n2;3\n", "e").values, (Values{1.5, 3}));
  EXPECT_EQ(read("# of the machine\nt\te\n0\t1\n\n# pause\n2\t3\n", "e").values, (Values{1, 3}));
  EXPECT_EQ(read("\"t\",\"true strain\"\r\n0,1\r\n2,3\r\n", "true strain").times, (Values{0, 2}));
  EXPECT_EQ(read("other,t,e\n7,0,1\n8,2,3\n", "e").values, (Values{1, 3}));
}

TEST(HistoryFile, ConvertsTheUnitsOfItsHeader) {
  EXPECT_EQ(read("time [ms],load (kPa)\n0,1\n2000,3\n", "load", "time", HistoryKind::stress).times, (Values{0, 2}));
  EXPECT_EQ(read("time [ms],load (kPa)\n0,1\n2000,3\n", "load", "time", HistoryKind::stress).values,
            (Values{1000, 3000}));
  EXPECT_EQ(read("t/min,e/%\n0,1\n2,3\n", "e").times, (Values{0, 120}));
  EXPECT_DOUBLE_EQ(read("t/min,e/%\n0,1\n2,3\n", "e").values[1], 0.03);
  EXPECT_EQ(read("t [s],sigma [N/mm2]\n0,1\n2,3\n", "sigma", "t", HistoryKind::stress).values, (Values{1e6, 3e6}));
  EXPECT_EQ(read("t [s],sigma [N/mm2]\n0,1\n2,3\n", "sigma [N/mm2]", "t", HistoryKind::stress).values,
            (Values{1e6, 3e6}));
}

TEST(HistoryFile, RefusesWithPlace) {
  const auto has = [](const std::string& text, const char* word) { return text.find(word) != text.npos; };
  EXPECT_TRUE(has(refusal_of("t,e\n0,1\n2,3\n", "x"), "has no column 'x'; known: t, e"));
  EXPECT_TRUE(has(refusal_of("t,e [furlong]\n0,1\n2,3\n", "e"),
                  "'furlong' of the column 'e [furlong]' is no unit of a number"));
  EXPECT_TRUE(has(refusal_of("t,e [kPa]\n0,1\n2,3\n", "e"), "is no unit of a number; known: 1, -, %"));
  EXPECT_TRUE(has(refusal_of("t [MPa],e\n0,1\n2,3\n", "e"), "is no unit of a time"));
  EXPECT_TRUE(has(refusal_of("t,e\n0,1\n2,3\n1,4\n", "e"), "data.csv:4:1"));
  EXPECT_TRUE(has(refusal_of("t,e\n-1,1\n2,3\n", "e"), "must not be negative"));
  EXPECT_TRUE(has(refusal_of("t,e\n0,1\n0,2\n0,3\n", "e"), "three rows at one time"));
  EXPECT_TRUE(has(refusal_of("t,e\n0,1\n", "e"), "two rows at least"));
  EXPECT_TRUE(has(refusal_of("t,e\n0,1\n2,x\n", "e"), "data.csv:3"));
  EXPECT_TRUE(has(refusal_of("", "e"), "data.csv"));
}

}  // namespace
}  // namespace assay::drivers::test_history_file
