// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/abaqus_deck.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_abaqus_deck {
namespace {

DeckMaterial read(const std::string& text, const std::string& asked = "") {
  const ScratchFolder scratch;
  return read_deck(scratch.write("job.inp", text), asked, "--material NAME");
}

/// Without the folder.
std::string refused(const std::string& text, const std::string& asked = "") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("job.inp", text);
  std::string line = refusal_of([&] { read_deck(file, asked, "--material NAME"); });
  while (line.find(file) != line.npos) line.replace(line.find(file), file.size(), "job.inp");
  return line;
}

TEST(AbaqusDeck, GivesConstantsStateAndDensity) {
  const DeckMaterial found = read(
      "*Heading\n** a comment\n*NODE\n1, 0., 0.\n"
      "*Material, name=Steel-1\n"
      "*DENSITY\n 7.85E-9,\n"
      "** *Density\n"
      "*Depvar, delete=3\n 9,\n1, PEEQ, \"equivalent plastic strain, so far\"\n 3 , BACK11\n"
      "*USER MATERIAL , Constants = 10, type=mechanical, unsymm\n"
      " 210.E3, .3, 1.d2, , -5, +6, 7, 8\n 9.,10\n"
      "*Elastic\n1., .3\n*Step\n*Static\n.1, 1.\n*End Step\n");
  EXPECT_EQ(found.name, "Steel-1");
  EXPECT_EQ(found.constants, (std::vector<double>{210e3, .3, 1e2, 0, -5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(found.depvar, 9);
  ASSERT_EQ(found.variables.size(), 2u);
  EXPECT_EQ(found.variables[0].name, "PEEQ");
  EXPECT_EQ(found.variables[0].doc, "equivalent plastic strain, so far");
  EXPECT_EQ(found.variables[1].number, 3);
  EXPECT_EQ(found.variables[1].name, "BACK11");
  EXPECT_EQ(found.density, 7.85e-9);
  EXPECT_TRUE(found.notes.empty());
}

TEST(AbaqusDeck, KeywordsGoOnBehindACommaAndAreShortened) {
  const DeckMaterial found = read("*MATERIAL,NAME=\"soft clay\"\n*user mat,\n  constants=2\n1,2\n*depvar\n4\n");
  EXPECT_EQ(found.name, "soft clay");
  EXPECT_EQ(found.constants.size(), 2u);
  EXPECT_EQ(found.depvar, 4);
  EXPECT_FALSE(found.density);
}

// As in decks of crystal plasticity in common use.
TEST(AbaqusDeck, WhatIsLeftOutOfALineIsZero) {
  const DeckMaterial found = read("*Material, name=A\n*User Material, const=18\n1, 2, 3 ,\n** words\n4\n5\n");
  EXPECT_EQ(found.constants, (std::vector<double>{1, 2, 3, 0, 0, 0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 5, 0}));
}

TEST(AbaqusDeck, ParametersAreNumbersWithNames) {
  const std::string material = "*Material, name=A\n*Density\n<rho>,\n*User Material, constants=2\n<K>, <G>\n";
  const DeckMaterial found = read("*PARAMETER\n# words\n k = 1.e3\nG=2\nrho = 7\ntwice = 2*K\n" + material);
  EXPECT_EQ(found.constants, (std::vector<double>{1e3, 2}));
  EXPECT_EQ(found.density, 7);
  EXPECT_NE(refused("*Parameter\nrho=1\nK=1\nG = 2*K\n" + material).find("found '<G>', to which no *Parameter"),
            std::string::npos);
}

TEST(AbaqusDeck, OneOfSeveralIsChosenByName) {
  const std::string text =
      "*Material, name=A\n*User Material, constants=1\n1\n*Material, name=plain\n*Elastic\n1, .3\n"
      "*Material, name=B\n*Depvar\n2\n*User Material, constants=1\n2\n*Material, name=hot\n"
      "*User Material, constants=1, type=THERMAL\n3\n";
  EXPECT_EQ(refused(text),
            "job.inp: has several materials with *User Material: choose one by --material NAME; known: A, B");
  EXPECT_EQ(read(text, "b").constants, std::vector<double>{2});
  EXPECT_EQ(read(text, "A").depvar, 0);
  EXPECT_EQ(refused(text, "plain"), "job.inp: has no material 'plain' with *User Material; known: A, B");
}

TEST(AbaqusDeck, IncludedFilesAreRead) {
  const ScratchFolder scratch;
  scratch.write("mat.inc", "*User Material, constants=2\n1, 2\n");
  const std::string deck =
      scratch.write("job.inp", "*Material, name=A\n*Include, input=mat.inc\n*include,input=mesh.inc\n");
  const DeckMaterial found = read_deck(deck, "", "");
  EXPECT_EQ(found.constants.size(), 2u);
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_NE(found.warnings[0].find(":3:1: *Include: 'mesh.inc' cannot be read"), std::string::npos);
  const std::string loop = scratch.write("loop.inp", "*Include, input=loop.inp\n");
  EXPECT_NE(refusal_of([&] { read_deck(loop, "", ""); }), "accepted") << "and comes to an end";
}

TEST(AbaqusDeck, HasALargestSizeWithAllThatItIncludes) {
  const ScratchFolder scratch;
  const std::string long_one = scratch.write("long.inp", "*Material, name=A\n");
  std::filesystem::resize_file(long_one, std::uintmax_t{3} << 30);
  EXPECT_EQ(refusal_of([&] { read_deck(long_one, "", ""); }), long_one + ": longer than 268435456 bytes");
  const std::string deck = scratch.write("job.inp", "*Heading\n*Include, input=long.inp\n");
  EXPECT_EQ(refusal_of([&] { read_deck(deck, "", ""); }),
            deck + ":2:1: with '" + long_one + "' the deck is longer than 268435456 bytes");
}

TEST(AbaqusDeck, WhatIsWrongIsSaidAtItsLine) {
  const std::string head = "*Material, name=A\n";
  EXPECT_EQ(
      refused(head + "*User Material, constants=8\n1, 2, 3, 4\n5, 6, 7, 8\n"),
      "job.inp:2:1: *User Material: has 2 lines, and constants=8 takes 1, with eight numbers in each but the last");
  EXPECT_EQ(
      refused(head + "*User Material, constants=9\n1, 2, 3, 4\n"),
      "job.inp:2:1: *User Material: has 1 lines, and constants=9 takes 2, with eight numbers in each but the last");
  EXPECT_EQ(refused(head + "*User Material, constants=16\n1, 2, 3, 4, 5, 6, 7, 8, 9\n1\n"),
            "job.inp:3:1: *User Material: has 9 numbers, and Abaqus takes eight a line");
  EXPECT_EQ(refused(head + "*User Material, constants=2\n1, <E>\n"),
            "job.inp:3:1: *User Material: must be a number, found '<E>', to which no *Parameter gives one");
  EXPECT_EQ(refused(head + "*User Material\n1\n"), "job.inp:2:1: *User Material: constants= is required and not given");
  EXPECT_EQ(refused(head + "*User Material, constants=two\n1\n"),
            "job.inp:2:1: constants: must be a whole number from 0 to 100000, found 'two'");
  EXPECT_EQ(refused(head + "*User Material, constants=1000000000\n1\n"),
            "job.inp:2:1: constants: must be a whole number from 0 to 100000, found '1000000000'");
  EXPECT_EQ(refused(head + "*User Material, constants=1\n1\n*Depvar\n1000000000\n"),
            "job.inp:5:1: *Depvar: must be a whole number from 0 to 100000, found '1000000000'");
  EXPECT_EQ(refused(head + "*User Material, constants=1\n1\n*Depvar\n2\n3, X\n"),
            "job.inp:6:1: *Depvar: names variable 3 of 2");
  EXPECT_EQ(refused(head + "*Elastic\n1, .3\n"), "job.inp: has no material with *User Material; known: A");
  EXPECT_EQ(refused(head + "*User Material, type=THERMAL, constants=1\n1\n"),
            "job.inp: has no material with *User Material; known: A (*User Material, type=thermal, is of UMATHT)");
  EXPECT_EQ(refused(""), "job.inp: has no material with *User Material");
  EXPECT_EQ(refusal_of([] { read_deck("/absent/job.inp", "", ""); }), "/absent/job.inp: no such file");
}

/// To Abaqus, capitals are no other name.
TEST(AbaqusDeck, NamesThatGoOnAreUtf8) {
  const ScratchFolder scratch;
  const auto said = [&](const std::string& name, const std::string& variable) {
    const std::string deck =
        scratch.write("d.inp", "*Heading\n St\xE4hle\n*Material, name=" + name + "\n*Depvar\n1\n1, " + variable +
                                   "\n*User Material, constants=1\n1.\n");
    return refusal_of([&] { read_deck(deck, "", "--material"); });
  };
  EXPECT_EQ(said("ST\xC3\x84HL", "PEEQ"), "accepted");
  EXPECT_NE(said("ST\xC4HL", "PEEQ").find("d.inp:3:1: *Material: 'ST"), std::string::npos) << said("ST\xC4HL", "PEEQ");
  EXPECT_NE(said("STEEL", "PEEQ\xB5").find("d.inp:6:1: *Depvar: 'PEEQ"), std::string::npos)
      << said("STEEL", "PEEQ\xB5");
  EXPECT_NE(said("STEEL", "PEEQ, \"\xB5\"").find("is not UTF-8 text"), std::string::npos);
}

TEST(AbaqusDeck, WhatIsThereTwiceIsRefused) {
  const std::string one = "*Material, name=Steel\n*User Material, constants=1\n1\n";
  EXPECT_EQ(refused(one + "*Material, name=STEEL\n*User Material, constants=1\n2\n", "Steel"),
            "job.inp:4:1: *Material, name=STEEL: stands in line 1 already");
  EXPECT_EQ(refused(one + "*Material, name=steel\n*Elastic\n1, .3\n"),
            "job.inp:4:1: *Material, name=steel: stands in line 1 already");
  EXPECT_EQ(refused(one + "*User Material, constants=1\n2\n"), "job.inp:4:1: *User Material: stands in line 2 already");
  EXPECT_EQ(refused(one + "*Depvar\n1\n*Depvar\n2\n"), "job.inp:6:1: *Depvar: stands in line 4 already");
  EXPECT_EQ(refused(one + "*Density\n1.,\n*Density\n2.,\n"), "job.inp:6:1: *Density: stands in line 4 already");
  EXPECT_EQ(refused(one + "*Density\n-1.,\n"), "job.inp:5:1: *Density: must not be negative");
  EXPECT_EQ(read(one + "*User Material, constants=1, type=THERMAL\n2\n").constants, std::vector<double>{1});
}

TEST(AbaqusDeck, ADecimalCommaIsNoSecondNumber) {
  const std::string head = "*Material, name=A\n*User Material, constants=2\n";
  EXPECT_EQ(
      refused(head + "1000., 0,3\n"),
      "job.inp:3:1: *User Material: has 3 numbers, and constants=2 stands above: a number is written with a point, "
      "as in 0.3, and a temperature behind the constants with one at its end");
  EXPECT_EQ(
      refused(head + "1000,5, 0,3\n"),
      "job.inp:3:1: *User Material: has 4 numbers, and constants=2 stands above: numbers have a decimal point, and "
      "commas between them");
  EXPECT_EQ(
      refused("*Material, name=A\n*User Material, constants=9\n1, 2, 3, 4, 5, 6, 7, 8\n0,3\n"),
      "job.inp:4:1: *User Material: has 10 numbers, and constants=9 stands above: a number is written with a point, "
      "as in 0.3, and a temperature behind the constants with one at its end");
  EXPECT_EQ(read(head + "1000., 0.3, 294.\n").constants, (std::vector<double>{1000, 0.3}));
  EXPECT_EQ(read(head + "1000,\n").constants, (std::vector<double>{1000, 0})) << "what is left out is zero";
}

TEST(AbaqusDeck, WhatIsSeenAndNotTakenIsTold) {
  const DeckMaterial found = read(
      "*Solid Section, elset=all, material=a, orientation=Ori-1\n*Material, name=A\n*User Material, constants=1\n"
      "1, 294.\n*Initial Conditions, type=SOLUTION\nall, 1., 2.\n");
  EXPECT_EQ(found.constants, std::vector<double>{1}) << "the number behind them is CalculiX's temperature";
  ASSERT_EQ(found.notes.size(), 3u);
  EXPECT_NE(found.notes[0].find("temperature that CalculiX has"), std::string::npos);
  EXPECT_NE(found.notes[1].find("axes: corotational"), std::string::npos);
  EXPECT_NE(found.notes[2].find("*Initial Conditions"), std::string::npos);
}

TEST(AbaqusDeck, NumbersAreThoseOfFortranToo) {
  EXPECT_EQ(deck_number("1.D+05"), 1e5);
  EXPECT_EQ(deck_number(".3"), .3);
  EXPECT_EQ(deck_number("2."), 2);
  for (const char* text : {"", "x", "1,2", ".inf", "nan", "1 2"}) EXPECT_FALSE(deck_number(text)) << text;
}

}  // namespace
}  // namespace assay::drivers::test_abaqus_deck
