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

/// The table of a path is a history with units.
TEST(HistoryFile, TakesTheUnitsThatAPathWrites) {
  const std::string table = "# units: t [min], e11 [1], s11 [MPa]\nt,e11,s11\n0,0,1\n2,0.5,3\n";
  EXPECT_EQ(read(table, "s11", "t", HistoryKind::stress).values, (Values{1e6, 3e6}));
  EXPECT_EQ(read(table, "e11").times, (Values{0, 120}));
}

TEST(HistoryFile, RefusesUnitsThatContradictOrDoNothing) {
  const auto refusal = [](const std::string& header, HistoryKind kind, const std::string& unit,
                          const std::string& time_unit = "") {
    const ScratchFolder scratch;
    PathFunction f;
    f.type = PathFunction::Type::file;
    f.file = scratch.write("data.csv", header + "\n0,1\n2,3\n"), f.time = "t";
    f.where = {"path.yaml", 3, 7}, f.unit = unit, f.time_unit = time_unit;
    try {
      read_history_file(f, "x", "path.control.s11", kind);
      return std::string("taken");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refusal("t,x [kPa]", HistoryKind::stress, "kPa"), "taken");
  EXPECT_EQ(refusal("t,x [kPa]", HistoryKind::stress, "MPa"),
            "path.yaml:3:7: path.control.s11.unit: is 'MPa', and the header of the file says 'kPa': leave it out");
  EXPECT_NE(refusal("t [s],x", HistoryKind::stress, "", "ms").find("time_unit: is 'ms'"), std::string::npos);
  EXPECT_NE(
      refusal("t,x [kPa]", HistoryKind::stress, "foo").find("path.control.s11.unit: 'foo' is no unit of a stress"),
      std::string::npos);
  EXPECT_NE(refusal("t,x [K]", HistoryKind::field, "degF").find("unit: has no effect"), std::string::npos);
  EXPECT_NE(refusal("t,x [kPa]", HistoryKind::field, "").find("is no unit of a field"), std::string::npos);
  EXPECT_EQ(refusal("t,x [K]", HistoryKind::field, ""), "taken");
}

/// Measured values over a strain that falls, as compression where tension counts positive.
TEST(HistoryFile, TakesAnAbscissaThatFalls) {
  const auto compared = [](const std::string& rows) {
    const ScratchFolder scratch;
    PathFunction f;
    f.type = PathFunction::Type::file;
    f.file = scratch.write("data.csv", "e11,s11\n" + rows), f.time = "e11";
    f.where = {"path.yaml", 3, 7};
    read_history_file(f, "s11", "compare", HistoryKind::stress, {}, HistoryKind::number);
    return f;
  };
  const PathFunction falls = compared("0,0\n-0.1,-5\n-0.2,-7\n");
  EXPECT_EQ(falls.times, (Values{-0.2, -0.1, 0}));
  EXPECT_EQ(falls.values, (Values{-7, -5, 0}));
  EXPECT_EQ(compared("-0.2,1\n0.1,2\n").times, (Values{-0.2, 0.1}));
  EXPECT_THROW(compared("0,0\n-0.1,1\n0.1,2\n"), InputError);
}

}  // namespace
}  // namespace assay::drivers::test_history_file
