// SPDX-License-Identifier: BSD-3-Clause
// What the program offers to the shells, and the scripts by which they ask for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>

#include "tests/house/tree.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::test_completions {
namespace {

using namespace assay::house;

using Words = std::vector<std::string>;

/// What stands before the tabs of what is offered after `assay ...`.
Words offers(const std::string& words) {
  Words found = lines_of(run_assay("--complete " + words).output);
  for (std::string& each : found) each = each.substr(0, each.find('\t'));
  return found;
}

bool has(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The lines of a command of the shell.
Words printed(const std::string& shell, const std::string& script) {
  FILE* pipe = popen(("PATH='" + built() + "':\"$PATH\" " + shell + " -c '" + script + "' 2>/dev/null").c_str(), "r");
  std::string output;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
  pclose(pipe);
  return lines_of(output);
}

bool is_there(const std::string& shell) { return std::system((shell + " -c : 2>/dev/null").c_str()) == 0; }

std::string script(const std::string& name) { return tree_folder() + "/completions/" + name; }

/// What bash puts in place of the last word.
Words completed_by_bash(const std::string& line) {
  return printed("bash", "compopt() { :; }; source " + script("assay.bash") + "; COMP_WORDS=(" + line +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _assay; printf \"%s\\n\" \"${COMPREPLY[@]}\"");
}

TEST(Completions, OfferEveryVerb) {
  const Words found = offers("''");
  for (const std::string& verb : verbs()) EXPECT_TRUE(has(found, verb)) << verb;
  for (const char* option : {"--help", "--version", "--quiet", "--verbose"}) EXPECT_TRUE(has(found, option)) << option;
}

TEST(LongCompletions, OfferEveryOptionOfAVerbAndNoOther) {
  const std::regex option(R"(\n  (?:-[a-z],)?(--?[a-z-]+))");
  for (const std::string& verb : verbs()) {
    const std::string help = run_assay(verb + " --help").output;
    Words found = offers(verb + " -"), known;
    for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it) known.push_back((*it)[1]);
    EXPECT_EQ(found, known) << verb;
  }
}

TEST(LongCompletions, OfferFilesForFiles) {
  const std::regex valued(R"(\n  (--?[a-z-]+) ([A-Z][^ ]*))");
  int files = 0;
  for (const std::string& verb : verbs()) {
    const std::string help = run_assay(verb + " --help").output;
    for (std::sregex_iterator it(help.begin(), help.end(), valued), end; it != end; ++it) {
      const std::string option = (*it)[1], type = (*it)[2];
      const Words found = offers(verb + " " + option + " ''");
      const std::map<std::string, Words> wanted{
          {"FILE", {"*"}}, {"FILE.inp", {"*.inp", "*/"}}, {"CSV", {"*.csv", "*/"}}, {"DIR", {"*/"}}};
      const bool is_file = wanted.contains(type);
      const bool offers_files = !found.empty() && found[0].starts_with("*");
      EXPECT_TRUE(is_file ? found == wanted.at(type) : !offers_files) << verb << " " << option;
      files += is_file ? 1 : 0;
    }
  }
  EXPECT_GE(files, 15);
}

TEST(Completions, OfferWhatAVerbIsAbout) {
  for (const char* verb : {"run", "tabulate", "eval", "explain", "study", "recommend"})
    EXPECT_TRUE(has(offers(verb + std::string(" ''")), "*.yaml")) << verb;
  for (const char* verb : {"check", "materials"}) {
    const Words found = offers(verb + std::string(" ''"));
    for (const char* each : {"neo_hookean", "*.so", "*.f", "*.inp"}) EXPECT_TRUE(has(found, each)) << verb << each;
  }
  EXPECT_FALSE(has(offers("register ''"), "neo_hookean"));
  EXPECT_TRUE(has(offers("register ''"), "*.so"));
  EXPECT_EQ(offers("new-material ''"), Words{});
  EXPECT_EQ(offers("new-material --language ''"), (Words{"c", "c++", "fortran"}));
  EXPECT_EQ(offers("run --set ''"), Words{});
  EXPECT_TRUE(has(offers("check x.f --props 1 --deck a.inp"), "*.inp"));
}

TEST(Completions, BashCompletes) {
  ASSERT_EQ(std::system(("bash -n " + script("assay.bash")).c_str()), 0);
  EXPECT_EQ(completed_by_bash("assay tab"), Words{"tabulate"});
  EXPECT_EQ(completed_by_bash("assay run --th"), Words{"--threads"});
  EXPECT_EQ(completed_by_bash("assay new-material --language c"), (Words{"c", "c++"}));
  EXPECT_EQ(completed_by_bash("assay check neo_h"), Words{"neo_hookean"});
  const std::string scenes = tree_folder() + "/configs/paper/";
  EXPECT_EQ(completed_by_bash("assay run " + scenes + "vortex_cpdi.y"), Words{scenes + "vortex_cpdi.yaml"});
  EXPECT_EQ(completed_by_bash("assay run -o " + scenes + "vortex_cpdi.y"), Words{""}) << "a folder is asked for";
  EXPECT_EQ(completed_by_bash("assay run -o " + tree_folder() + "/configs/pape"),
            Words{tree_folder() + "/configs/paper"});
}

TEST(Completions, FishCompletes) {
  if (!is_there("fish")) GTEST_SKIP() << "no fish";
  const auto completed = [](const std::string& line) {
    Words found = printed("fish", "source " + script("assay.fish") + "; complete -C \"" + line + "\"");
    for (std::string& each : found) each = each.substr(0, each.find('\t'));
    return found;
  };
  EXPECT_EQ(completed("assay tab"), Words{"tabulate"});
  EXPECT_EQ(completed("assay run --th"), Words{"--threads"});
  EXPECT_EQ(completed("assay check neo_h"), Words{"neo_hookean"});
  const std::string scenes = tree_folder() + "/configs/paper/";
  EXPECT_EQ(completed("assay run " + scenes + "vortex_cpdi.y"), Words{scenes + "vortex_cpdi.yaml"});
}

TEST(Completions, ZshCompletes) {
  if (!is_there("zsh")) GTEST_SKIP() << "no zsh";
  const auto offered = [](const std::string& words) {
    return printed("zsh", "_describe() { print -rl -- $offers }; _files() { print -r -- \"$@\" }; words=(" + words +
                              "); CURRENT=$#words; source " + script("_assay"));
  };
  EXPECT_TRUE(has(offered("assay tab"), "tabulate:tabulate a model's response along the scene's motion"));
  EXPECT_TRUE(has(offered("assay run --th"), "--threads:number of threads (default\\: 1)"));
  EXPECT_TRUE(has(offered("assay check neo_h"), "neo_hookean:material"));
  EXPECT_EQ(offered("assay run \"\""), Words{"-g (*.yaml|*.yml)"});
  EXPECT_EQ(offered("assay run -o \"\""), Words{"-/"});
}

}  // namespace
}  // namespace assay::test_completions
