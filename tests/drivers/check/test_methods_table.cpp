// SPDX-License-Identifier: BSD-3-Clause
// The table of methods and tests says of every method what was found, and of none anything else.
#include "drivers/check/methods_report.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_methods_table {
namespace {

using check::Verdict;

mpm::MethodReport patched_report(mpm::Basis basis, mpm::Transfer transfer, const std::vector<Verdict>& verdicts,
                                 mpm::Update update = mpm::Update::usl) {
  mpm::MethodReport report{{basis, transfer, update}, {}};
  const std::vector<std::string> ids{"stress.seeded", "stress.graded", "stress.jittered", "translation"};
  for (std::size_t k = 0; k < ids.size(); ++k) report.tests.push_back({.id = ids[k], .verdict = verdicts[k]});
  return report;
}

constexpr Verdict passed_test = Verdict::pass, open_test = Verdict::not_applicable, failed_test = Verdict::fail;
const std::vector<Verdict> all_passed{passed_test, passed_test, passed_test, passed_test},
    some_open{passed_test, open_test, open_test, passed_test};

TEST(MethodsTable, MergesMethodsAndTestsThatAgree) {
  using mpm::Basis;
  using mpm::Transfer;
  const CheckedMethods checked{
      {patched_report(Basis::ugimp, Transfer::pic, some_open), patched_report(Basis::ugimp, Transfer::flip, some_open),
       patched_report(Basis::cpdi, Transfer::pic, some_open), patched_report(Basis::cpdi, Transfer::flip, some_open),
       patched_report(Basis::cpdi2, Transfer::flip, all_passed)},
      0};
  EXPECT_EQ(methods_markdown(checked),
            "All 5 methods pass `stress.seeded`, `translation`. In the table, - means not promised.\n"
            "\n"
            "| Formulation | Basis | Transfer | Methods | `stress.graded`, `.jittered` |\n"
            "| --- | --- | --- | --- | --- |\n"
            "| updated | ugimp, cpdi | pic, flip | 4 | - |\n"
            "| updated | cpdi2 | flip | 1 | pass |\n");
}

// Rows hold all that their names make: no method is told what holds for another.
TEST(MethodsTable, KeepsApartWhatDiffersInOneVerdict) {
  using mpm::Basis;
  using mpm::Transfer;
  CheckedMethods checked{
      {patched_report(Basis::ugimp, Transfer::pic, some_open), patched_report(Basis::ugimp, Transfer::flip, all_passed),
       patched_report(Basis::cpdi, Transfer::flip, some_open)},
      0};
  checked.methods.push_back(patched_report(Basis::ugimp, Transfer::flip,
                                           {passed_test, passed_test, failed_test, passed_test}, mpm::Update::musl));
  const std::string table = methods_markdown(checked);
  for (const char* row :
       {"| updated | ugimp | pic | 1 | - | - |\n", "| updated | ugimp | flip/usl | 1 | pass | pass |\n",
        "| updated | cpdi | flip | 1 | - | - |\n", "| updated | ugimp | flip/musl | 1 | pass | FAIL |\n"}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << table;
  }
}

TEST(MethodsTable, IsASentenceWhereAllPass) {
  const CheckedMethods checked{{patched_report(mpm::Basis::cpdi2, mpm::Transfer::flip, all_passed)}, 0};
  EXPECT_EQ(methods_markdown(checked), "The method passes `stress.seeded`, `.graded`, `.jittered`, `translation`.\n");
  EXPECT_EQ(methods_markdown({}), "");
}

}  // namespace
}  // namespace assay::drivers::test_methods_table
