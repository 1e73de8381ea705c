// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/units.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::drivers::test_units {
namespace {

const Units mm_MPa_s{.length = "mm", .stress = "MPa", .time = "s"};

double si_of(const std::string& word) { return parse_unit(word)->scale.to_si(1); }

// By hand: 1 psi = 1 lbf/in^2 = 4.4482216152605 N / (0.0254 m)^2.
TEST(Units, AreWhatTheyAreInSI) {
  EXPECT_EQ(si_of("N/mm^2"), 1e6);
  EXPECT_EQ(si_of("N/mm2"), 1e6);
  EXPECT_EQ(si_of("kg/m^3"), 1);
  EXPECT_DOUBLE_EQ(si_of("t/mm^3"), 1e12);
  EXPECT_DOUBLE_EQ(si_of("psi"), 4.4482216152605 / (0.0254 * 0.0254));
  EXPECT_DOUBLE_EQ(si_of("ksi"), 1000 * si_of("psi"));
  EXPECT_DOUBLE_EQ(si_of("1/min"), 1 / 60.0);
  EXPECT_DOUBLE_EQ(si_of("um/m"), 1e-6);
  EXPECT_EQ(si_of("in"), 0.0254);
  EXPECT_EQ(si_of("%"), 0.01);
  EXPECT_DOUBLE_EQ(si_of("MPa m^0.5"), 1e6);
  EXPECT_EQ(parse_unit("J/m^3")->dimension, parse_unit("Pa")->dimension);
  EXPECT_EQ(parse_unit("W")->dimension, parse_unit("N m/s")->dimension);
  EXPECT_EQ(parse_unit("N")->dimension, parse_unit("kg m/s^2")->dimension);
  EXPECT_EQ(parse_unit("rad/s")->dimension, parse_unit("1/s")->dimension);
}

TEST(Units, OtherWordsAreNone) {
  for (const char* word : {"", " ", "regime", "Pa/", "/s", "Pa^", "Pa s^x", "m^99", "kg/m^3)", "1/(Pa s)", "Pas", "pa"})
    EXPECT_FALSE(parse_unit(word)) << "'" << word << "'";
}

TEST(Units, ConvertByTheDimension) {
  EXPECT_EQ(mm_MPa_s.scale("m").to_si(1250), 1.25) << "to the last bit";
  EXPECT_EQ(mm_MPa_s.scale("Pa").to_si(210000), 2.1e11);
  EXPECT_DOUBLE_EQ(mm_MPa_s.scale("kg/m^3").to_si(7.85e-9), 7850);
  EXPECT_DOUBLE_EQ(mm_MPa_s.scale("m/s").to_si(3000), 3);
  EXPECT_DOUBLE_EQ(mm_MPa_s.scale("J/m^3").to_si(2), 2e6) << "mJ/mm^3 are MPa";
  EXPECT_EQ(mm_MPa_s.scale("1").to_si(0.3), 0.3);
  EXPECT_EQ(mm_MPa_s.scale("deg").to_si(30), 30) << "an angle of a model stays";
  EXPECT_NE(parse_unit("deg")->dimension, parse_unit("1")->dimension) << "a strain has no degrees";
  EXPECT_TRUE(mm_MPa_s.scale("regime").is_one());
  EXPECT_TRUE(mm_MPa_s.scale("MPa").is_one()) << "what a foreign model has in its own units stays";
}

TEST(Units, HaveNames) {
  EXPECT_EQ(mm_MPa_s.name("Pa"), "MPa");
  EXPECT_EQ(mm_MPa_s.name("J/m^3"), "MPa");
  EXPECT_EQ(mm_MPa_s.name("m/s"), "mm/s");
  EXPECT_EQ(mm_MPa_s.name("1/s"), "1/s");
  EXPECT_EQ(mm_MPa_s.name("Pa s"), "MPa s");
  EXPECT_EQ(mm_MPa_s.name("kg/m^3"), "t/mm^3");
  EXPECT_EQ((Units{"mm", "MPa", "ms"}.name("kg/m^3")), "g/mm^3");
  EXPECT_EQ((Units{"mm", "GPa", "ms"}.name("kg/m^3")), "kg/mm^3");
  EXPECT_EQ((Units{"in", "psi", "s"}.name("kg/m^3")), "psi s^2/in^2") << "it has no name of its own here";
  EXPECT_EQ(mm_MPa_s.name("regime"), "regime");
  EXPECT_EQ(Units().name("J/m^3"), "J/m^3");
  EXPECT_EQ(mm_MPa_s.text(0.5, "m"), "500 mm");
  EXPECT_EQ(mm_MPa_s.text(30, "deg"), "30 deg");
  EXPECT_EQ(mm_MPa_s.text(3, "Pa/deg"), "3e-06 MPa/deg");
}

TEST(Units, StandInHeadings) {
  for (const char* text : {"stress [MPa]", "stress (MPa)", "stress / MPa", " stress[MPa]"}) {
    EXPECT_EQ(heading_of(text).name, "stress") << text;
    EXPECT_EQ(heading_of(text).unit, "MPa") << text;
  }
  EXPECT_EQ(heading_of("stress").unit, "");
}

}  // namespace
}  // namespace assay::drivers::test_units
