// SPDX-License-Identifier: BSD-3-Clause
// Whatever a model writes where it stands, `check` leaves the user's files as they are.
#include <gtest/gtest.h>

#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/misdeeds.hpp"
#include "tests/support/some_of.hpp"

namespace assay::drivers::test_check_child {
namespace {

namespace fs = std::filesystem;

/// In a folder with a file of the user's.
class UsersFolder {
 public:
  UsersFolder() { scratch.write("data.csv", "mine"); }
  void stand_here() const {
    if (::chdir((scratch / "").c_str()) != 0) ::_exit(126);
  }
  std::string data() const { return bytes_of(scratch / "data.csv"); }
  ScratchFolder scratch;
};

class LitteringModel : public testing::TestWithParam<const char*> {};

TEST_P(LitteringModel, DoesNotReachIt) {
  const Misdeeds the;
  const UsersFolder users;
  const Ending ending = assay({"check", the.library, "--quick", "-o", "r"}, [&] {
    the.arm(GetParam());
    users.stand_here();
  });
  EXPECT_LE(ending.status, 1) << ending.said;
  EXPECT_EQ(users.data(), "mine");
  EXPECT_TRUE(the.nothing_is_left());
}

const auto cases_of_littering_model = one_of_each<LitteringModel::ParamType>(
    3, testing::Values("load litter", "create litter", "update litter", "update litter_and_die", "destroy litter",
                       "destroy litter_and_die", "create litter_and_die"));
const auto name_of_littering_model = [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(Deeds, LitteringModel, testing::ValuesIn(cases_of_littering_model.some),
                         name_of_littering_model);
INSTANTIATE_TEST_SUITE_P(LongDeeds, LitteringModel, testing::ValuesIn(cases_of_littering_model.others),
                         name_of_littering_model);

class LitteringSource : public SourceTest {};
using LongLitteringSource = LitteringSource;

// Once it has ended the process, it is tried with other components of stress.
TEST_F(LongLitteringSource, DoesNotReachItWhenItEndsTheProcess) {
  const std::string open = "      OPEN(15,FILE='data.csv',STATUS='REPLACE')\n      CLOSE(15)\n";
  for (const char* end : {"      STOP 3\n", "      CALL XIT\n", "      CALL ABORT\n"}) {
    const UsersFolder users;
    users.scratch.write("model.f", fixed_umat(open + end));
    const Ending ending = assay({"check", "model.f", "--props", "1000,.3", "--quick"}, [&] { users.stand_here(); });
    EXPECT_EQ(ending.status, 1) << ending.said;
    EXPECT_EQ(users.data(), "mine") << end;
    EXPECT_TRUE(fs::exists(users.scratch / "results/check/model.yaml"));
  }
}

// It ends, too, where it does not find what it reads: not in the folder of the user alone.
TEST_F(LitteringSource, FindsItsFilesWhereverItIsTried) {
  const UsersFolder users;
  users.scratch.write("table.txt", "1.0\n");
  users.scratch.write("model.f", fixed_umat("      OPEN(15,FILE='table.txt',STATUS='OLD')\n      CLOSE(15)\n"
                                            "      OPEN(15,FILE='data.csv',STATUS='REPLACE')\n      CLOSE(15)\n"
                                            "      PRINT *, 'read'\n      CALL FLUSH(6)\n      STOP 3\n"));
  users.scratch.write("model.yaml",
                      "source: model.f\ninterface: umat\nproperties: {E: 1000, nu: 0.3}\nfiles: [table.txt]\n");
  const Ending ending = assay({"check", "model.yaml", "--quick"}, [&] { users.stand_here(); });
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_EQ(users.data(), "mine");
  EXPECT_EQ(ending.said.find("table.txt"), std::string::npos) << ending.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_child
