// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/command_line/verb.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

namespace assay::drivers::test_manual {
namespace {

const std::string page =
    ".TH ASSAY 1\n.SS assay bend SCENE\nBend it.\n.TP\n.B \\-\\-hot\\-dip\nIn zinc.\n.SS assay other\nOther.\n.SH EXIT "
    "STATUS\n0\n";

class Manual : public testing::Test {
 protected:
  Manual() {
    add("bend", "bend a scene");
    add("other", "something else");
  }
  CLI::App& add(const std::string& name, const std::string& doc) {
    verbs.push_back({name, {*app.add_subcommand(name, doc)}, {}});
    return verbs.back().arguments.app;
  }
  std::string whole() const { return whole_manual(app, verbs, page); }

  CLI::App app{"", "assay"};
  std::vector<AddedVerb> verbs;
  std::string value;
  bool flag = false;
};

TEST_F(Manual, OfAPageThatSaysAllIsThePage) {
  verbs[0].arguments.app.add_flag("--hot-dip", flag, "dip it");
  verbs[0].arguments.app.add_option("SCENE", value, "YAML file")->required();
  EXPECT_EQ(whole(), page);
}

TEST_F(Manual, HasAnEntryForAnOptionThatTheSectionOfTheVerbLacks) {
  CLI::App& bend = verbs[0].arguments.app;
  bend.add_flag("--hot", flag, "use heat");
  bend.add_option("-o", value, "folder for the half-done")->type_name("DIR");
  std::string wanted = page;
  wanted.insert(page.find(".SS assay other"),
                ".TP\n.B \\-\\-hot\nUse heat.\n.TP\n.BI \\-o \" DIR\"\nFolder for the half\\-done.\n");
  EXPECT_EQ(whole(), wanted);
}

TEST_F(Manual, HasASectionForAVerbThatThePageLacks) {
  CLI::App& verb = add("new-verb", "do it");
  verb.add_option("SCENE", value, "YAML file")->required()->type_name("");
  verb.add_option("OTHER", value, "another")->type_name("");
  verb.add_flag("--hot-dip", flag, "dip it");
  std::string wanted = page;
  wanted.insert(page.find(".SH EXIT"), ".SS assay new-verb SCENE [OTHER]\nDo it.\n.TP\n.B \\-\\-hot\\-dip\nDip it.\n");
  EXPECT_EQ(whole(), wanted);
}

}  // namespace
}  // namespace assay::drivers::test_manual
