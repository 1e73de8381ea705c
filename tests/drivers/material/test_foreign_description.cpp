// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/foreign_description.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/material/description_text.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/support/kept_yaml.hpp"

namespace assay::drivers::test_foreign_description {
namespace {

const std::string file = "/folder/My-Clay.yaml";

MaterialDescription read(const std::string& keys) {
  return read_description("library: a.so\ninterface: umat\n" + keys, file);
}
adapters::ForeignModel model(const std::string& keys) { return read(keys).foreign.value(); }

TEST(ForeignDescription, WrittenReadsBackToTheSame) {
  constexpr unsigned descriptions = 1000;
  for (unsigned seed = 0; seed < descriptions && !testing::Test::HasFailure(); ++seed) {
    const std::string yaml = RandomDescription(seed).yaml();
    const MaterialDescription first = read_description(yaml, file);
    const std::string written = description_yaml(first);
    if (seed < 100) keep_yaml("plain", written);
    const MaterialDescription second = read_description(written, "/other/place.yaml");
    expect_same(first, second);
    EXPECT_EQ(description_yaml(second), written);
    if (testing::Test::HasFailure()) ADD_FAILURE() << yaml << "\n" << written;
  }
}

TEST(ForeignDescription, HasTheDefaultsOfItsInterface) {
  const MaterialDescription umat = read("");
  EXPECT_EQ(umat.library, "/folder/a.so");
  EXPECT_EQ(umat.name, "my_clay");
  EXPECT_EQ(umat.foreign->symbol, "umat_");
  EXPECT_EQ(umat.foreign->temperature, 0);
  EXPECT_EQ(umat.foreign->components, std::vector<int>{6});
  EXPECT_EQ(read_description("library: a.so\ninterface: vumat\n", file).foreign->symbol, "vumat_");
  const auto mfront = read_description("library: a.so\ninterface: mfront\n", file).foreign;
  EXPECT_EQ(mfront->symbol, "");
  EXPECT_EQ(mfront->temperature, 293.15);
  EXPECT_FALSE(read_description("library: a.so\n", file).foreign) << "native";
}

std::string refused(const std::string& keys) {
  return refusal_of([&] { read(keys); });
}

TEST(ForeignDescription, ANumberThatIsWrittenOtherwiseIsNoName) {
  const auto told = [](const std::string& item) { return refused("properties: [" + item + ", .3]\n"); };
  const std::string at = "/folder/My-Clay.yaml:3:14: properties.p1: must be a number or a name";
  EXPECT_EQ(told("2.1D5"), at + ", found '2.1D5': write 2.1e5");
  EXPECT_EQ(told("1_000").find(at + ", found '1_000'"), 0u) << told("1_000");
  EXPECT_EQ(told("1000 MPa").find(at + ", found '1000 MPa'"), 0u) << told("1000 MPa");
  EXPECT_EQ(told("E=1000"), at + ", found 'E=1000': names with values are a map, {E: 1000}");
  EXPECT_EQ(refused("properties:\n  - E: 1000\n"),
            "/folder/My-Clay.yaml:4:5: properties.p1: must be a number or a name: keys with values stand without '-'");
  EXPECT_NE(refused("properties: {E=1000, nu=.3}\n")
                .find("properties.E=1000: is no name: a key needs ':' and a space after it"),
            std::string::npos);
  EXPECT_EQ(model("properties: [E, nu]").properties.size(), 2u);
}

TEST(ForeignDescription, NumbersWithoutBracketsAreToldToBeAList) {
  const std::string at = "/folder/My-Clay.yaml:3:13: properties: must be a list or a map, found ";
  EXPECT_EQ(refused("properties: 1000, .3\n"), at + "'1000, .3': write [1000, .3]");
  EXPECT_EQ(refused("properties: (1000 .3)\n"), at + "'(1000 .3)': write [1000, .3]");
  EXPECT_EQ(refused("properties: 1000\n"), at + "'1000': write [1000]");
  EXPECT_NE(refused("properties: steel\n").find("must be a map of keys, found 'steel'"), std::string::npos);
}

TEST(ForeignDescription, WhatHasNoEffectOfMfrontIsRefused) {
  const auto told = [](const std::string& keys) {
    return refusal_of([&] { read_description("library: a.so\ninterface: mfront\n" + keys, file); });
  };
  for (const std::string& key : keys_of_abaqus()) {
    const std::string begin = "/folder/My-Clay.yaml:3:" + std::to_string(key.size() + 3) + ": " + key +
                              ": has no effect with interface: mfront, only with ";
    EXPECT_TRUE(told(key + ": 1\n").starts_with(begin)) << told(key + ": 1\n");
  }
  EXPECT_TRUE(told("arguments: 16\n").ends_with("only with lsdyna")) << told("arguments: 16\n");
  EXPECT_TRUE(told("thickness: 0.5\n").ends_with("only with umat")) << told("thickness: 0.5\n");
  EXPECT_EQ(told("temperature: 300\nunits: {stress: MPa}\nsymmetry: cubic\nfields: {a: 1}\n"), "accepted");
}

TEST(ForeignDescription, ASourceNeedsAnInterfaceAndIsOneFile) {
  const auto told = [](const std::string& text) { return refusal_of([&] { read_description(text, file); }); };
  EXPECT_EQ(
      told("source: a.f\n"),
      "/folder/My-Clay.yaml:1:9: source: goes with interface: umat, vumat, usermat or lsdyna: write one of these lines "
      "beside it");
  EXPECT_EQ(
      told("source: a.f\ninterface: native\n"),
      "/folder/My-Clay.yaml:1:9: source: goes with interface: umat, vumat, usermat or lsdyna, found interface: native");
  EXPECT_EQ(told("source: [a.f, b.f]\ninterface: umat\n"),
            "/folder/My-Clay.yaml:1:9: source: must be one file, found a list: let one INCLUDE the others, or build a "
            "library of them, for `link`");
}

TEST(ForeignDescription, ANameIsThereOnce) {
  EXPECT_EQ(refused("state: [a, b, a]\n"), "/folder/My-Clay.yaml:3:15: state.a: is there twice");
  EXPECT_EQ(refused("properties: [E, nu, E]\n"), "/folder/My-Clay.yaml:3:21: properties.E: is there twice");
}

TEST(ForeignDescription, PropertiesKeepTheirOrderInEveryForm) {
  const auto names = [](const adapters::ForeignModel& m) {
    std::string list;
    for (const auto& p : m.properties) list += p.name + (std::isnan(p.value) ? " " : "! ");
    return list;
  };
  EXPECT_EQ(model("properties: {z: 1, a: ~, m: {value: 3}}").properties.size(), 3u);
  EXPECT_EQ(names(model("properties: {z: ~, a: ~, m: ~}")), "z a m ");
  EXPECT_EQ(names(model("properties: [E, nu]")), "E nu ");
  const auto counted = model("properties: [4, E, 5]").properties;
  EXPECT_EQ(counted[0].name, "p1");
  EXPECT_EQ(counted[0].value, 4);
  EXPECT_EQ(counted[2].name, "p3");
  EXPECT_EQ(model("properties: ['4']").properties[0].name, "4") << "quoted is text";
}

TEST(ForeignDescription, StateKeepsItsOrderInEveryForm) {
  using Kind = adapters::ForeignVariable::Kind;
  EXPECT_EQ(model("state: 3").state[2].name, "s3");
  EXPECT_EQ(model("state: [b, a]").state[1].name, "a");
  const auto state =
      model("state: {z: tensor, n: {initial: 0.8}, a: {kind: strain, count: 2, initial: [1, 2, 3, 4, 5, 6]}}").state;
  ASSERT_EQ(state.size(), 4u);
  EXPECT_EQ(state[0].kind, Kind::tensor);
  EXPECT_EQ(state[1].initial, std::vector<double>{0.8});
  EXPECT_EQ(state[2].name + state[3].name, "a[1]a[2]");
  EXPECT_EQ(state[3].initial.size(), 6u);
}

/// The library knows how many components a variable of MFront has.
TEST(ForeignDescription, InitialValuesOfMfrontAreAsManyAsTheyAre) {
  const std::string yaml = "library: a.so\ninterface: mfront\nstate: {Fe: {initial: [1, 1, 1, 0, 0, 0, 0, 0, 0]}}\n";
  const MaterialDescription found = read_description(yaml, file);
  EXPECT_EQ(found.foreign->state[0].initial.size(), 9u);
  expect_same(read_description(description_yaml(found), file), found);
}

TEST(ForeignDescription, AClassOfSymmetryIsThatOfWhatIsAnisotropic) {
  const auto of = [](const std::string& word) {
    const adapters::ForeignModel found = model("symmetry: " + word);
    return std::pair(found.symmetry, found.material_class);
  };
  EXPECT_EQ(of("isotropic"), std::pair(int{ASSAY_ISOTROPIC}, 0));
  EXPECT_EQ(of("anisotropic"), std::pair(int{ASSAY_ANISOTROPIC}, 0));
  EXPECT_EQ(of("monoclinic"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_MONOCLINIC}));
  EXPECT_EQ(of("orthotropic"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_ORTHOTROPIC}));
  EXPECT_EQ(of("trigonal"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_TRIGONAL}));
  EXPECT_EQ(of("tetragonal"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_TETRAGONAL}));
  EXPECT_EQ(of("hexagonal"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_HEXAGONAL}));
  EXPECT_EQ(of("transversely_isotropic"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_TRANSVERSELY_ISOTROPIC}));
  EXPECT_EQ(of("cubic"), std::pair(int{ASSAY_ANISOTROPIC}, int{ASSAY_CUBIC}));
}

TEST(ForeignDescription, OnlyAUmatIsToldItsAxes) {
  const auto of = [](const std::string& interface, const std::string& axes) {
    return refusal_of(
        [&] { read_description("library: a.so\ninterface: " + interface + "\naxes: " + axes + "\n", file); });
  };
  EXPECT_EQ(of("umat", "corotational"), "accepted");
  EXPECT_EQ(of("vumat", "fixed"), "accepted");
  EXPECT_TRUE(of("vumat", "corotational").starts_with(file + ":3:7: axes: is for interfaces that leave the choice"));
}

TEST(ForeignDescription, PlaneStressHasAThickness) {
  EXPECT_EQ(model("components: [3]").thickness, 0.5);
  EXPECT_EQ(model("components: [3]\nthickness: constant").thickness, 0);
  EXPECT_EQ(model("components: [3]\nthickness: incompressible").thickness, 0.5);
  const MaterialDescription said = read("components: [3]\nthickness: 0.3\n");
  EXPECT_EQ(said.foreign->thickness, 0.3);
  EXPECT_EQ(read_description(description_yaml(said), file).foreign->thickness, 0.3);
  EXPECT_NE(refused("components: [3]\nthickness: thin\n").find("known: constant, incompressible"), std::string::npos);
  EXPECT_NE(refused("components: [3]\nthickness: 0.6\n").find("thickness: must be"), std::string::npos);
  EXPECT_NE(refused("thickness: 0.3\n").find("is for a UMAT of plane stress alone"), std::string::npos);
  EXPECT_NE(refused("components: [3, 6]\n").find("3 stands alone"), std::string::npos);
}

TEST(ForeignDescription, OtherVendorsHaveDefaultsAndKeysOfTheirOwn) {
  const auto of = [](const std::string& interface, const std::string& keys) {
    return read_description("library: a.so\ninterface: " + interface + "\n" + keys, file);
  };
  EXPECT_EQ(of("usermat", "").foreign->symbol, "usermat_");
  EXPECT_EQ(of("usermat", "").foreign->axes, adapters::Axes::corotational);
  EXPECT_EQ(of("lsdyna", "").foreign->symbol, "umat41_");
  EXPECT_EQ(of("lsdyna", "").foreign->axes, adapters::Axes::fixed);
  EXPECT_EQ(of("lsdyna", "").foreign->arguments, 18);
  for (const auto& [interface, keys] : {std::pair{"usermat", "axes: fixed\ncomponents: [4]\nstep: 2\n"},
                                        {"lsdyna", "arguments: 16\nstrain: finite\nsymbol: umat45_\n"}}) {
    const MaterialDescription first = of(interface, keys), second = read_description(description_yaml(first), file);
    expect_same(first, second);
    EXPECT_EQ(second.foreign->arguments, first.foreign->arguments);
    EXPECT_EQ(description_yaml(second), description_yaml(first));
  }
  for (const std::string interface : {"umat", "vumat", "usermat", "lsdyna"}) {
    for (const std::string& key : keys_without_effect(interface)) {
      EXPECT_NE(refusal_of([&] { of(interface, key + ": 1\n"); }).find("has no effect with interface: " + interface),
                std::string::npos)
          << interface << " " << key;
    }
  }
  EXPECT_NE(refusal_of([&] { of("usermat", "components: [3]\n"); }).find("3 is for UMATs alone"), std::string::npos);
}

struct BadKey {
  const char *keys, *line;  ///< the third of the file and its error after "file:3:"
};

class BadForeignKey : public testing::TestWithParam<BadKey> {};

TEST_P(BadForeignKey, IsOneLineAtItsPlace) {
  const std::string found = refusal_of([] { read(GetParam().keys); });
  EXPECT_EQ(found.substr(0, file.size() + 3), file + ":3:") << found;
  EXPECT_EQ(found.substr(std::min(found.size(), file.size() + 3)).substr(0, std::string(GetParam().line).size()),
            GetParam().line);
  EXPECT_EQ(found.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadForeignKey,
    testing::Values(
        BadKey{"propertys: {E: 1}", "1: propertys: unknown key (nearest: properties); known: library, source, link, n"},
        BadKey{"parameters: {E: 1}", "1: parameters: unknown key"},
        BadKey{"properties: 3", "13: properties: must be a list or a map, found '3': write [3]"},
        BadKey{"properties: {E: {vale: 1}}", "18: properties.E.vale: unknown key (nearest: value); known: value, unit"},
        BadKey{"properties: {E: [1]}", "17: properties.E: must be a number, found a list: write 1 without brackets"},
        BadKey{"properties: {E: .nan}", "17: properties.E: must be a finite number"},
        BadKey{"properties: {E: '1'}", "17: properties.E: must be a number, found '1'"},
        BadKey{"properties: [1, .inf]", "17: properties.p2: must be a finite number, found '.inf'"},
        BadKey{"properties: [a, a]", "17: properties.a: is there twice"},
        BadKey{"properties: [p2, 1]", "18: properties.p2: is there twice"},
        BadKey{"state: -1", "8: state: must be from 0 to 10000, found '-1'"},
        BadKey{"state: 1.5", "8: state: must be a whole number"},
        BadKey{"state: {a: vectr}", "12: state.a: unknown value 'vectr' (nearest: vector); known: scalar, vector"},
        BadKey{"state: {a: .nan}", "12: state.a: a number alone is no kind: a first value is {initial: .nan}"},
        BadKey{"state: {a: 0.5}", "12: state.a: a number alone is no kind: a first value is {initial: 0.5}"},
        BadKey{"state: {a: 14}",
               "12: state.a: a number alone may be a count or a first value: write {count: 14} or {initial: 14}"},
        BadKey{"noel: 0", "7: noel: must be from 1 to"}, BadKey{"npt: 1.5", "6: npt: must be a whole number"},
        BadKey{"elements: all", "11: elements: unknown value 'all'"},
        BadKey{"state: {a: {knd: vector}}", "13: state.a.knd: unknown key (nearest: kind); known: kind, count"},
        BadKey{"state: {a: {count: 0}}", "20: state.a.count: must be from 1 to 10000"},
        BadKey{"state: {a: {kind: vector, initial: [1, 2]}}",
               "36: state.a.initial: must be a list of 3 numbers, found 2"},
        BadKey{"state: [[a]]", "9: state: must be text, found a list"},
        BadKey{"kinematics: abaqs",
               "13: kinematics: unknown value 'abaqs' (nearest: abaqus); known: objective, abaqus"},
        BadKey{"axes: turning", "7: axes: unknown value 'turning'"},
        BadKey{"fields: [1]", "9: fields: must be a map of keys, found a list"},
        BadKey{"fields: {T: hot}", "13: fields.T: must be a number, found 'hot'"},
        BadKey{"step: 0", "7: step: must be from 1 to 10000"},
        BadKey{"strain: [small]", "9: strain: must be a word, found a list; known: small, finite"},
        BadKey{"symmetry: isotrop", "11: symmetry: unknown value 'isotrop'"},
        BadKey{"flags: non_smooth", "8: flags: must be a list, found 'non_smooth'; known: non_smooth, rate_dependent"},
        BadKey{"flags: [nonsmooth]", "9: flags: unknown value 'nonsmooth' (nearest: non_smooth)"},
        BadKey{"components: [5]", "14: components: unknown value '5'"},
        BadKey{"components: []", "13: components: must name 6, 4 or both"},
        BadKey{"units: MPa", "8: units: must be a map of keys, found 'MPa'; known: stress, time, length"},
        BadKey{"units: {stres: MPa}", "9: units.stres: unknown key (nearest: stress); known: stress, time, length"},
        BadKey{"units: {stress: Mpa}", "17: units.stress: unknown value 'Mpa' (nearest: MPa); known: Pa, kPa"},
        BadKey{"temperature: warm", "14: temperature: must be a number, found 'warm'"},
        BadKey{"characteristic_length: 0", "24: characteristic_length: must be greater than 0"},
        BadKey{"density: -1", "10: density: must be greater than 0"},
        BadKey{"time_limit: 0", "13: time_limit: must be greater than 0"},
        BadKey{"memory_limit: .inf", "15: memory_limit: must be a finite number"},
        BadKey{"material_name: {a: 1}", "16: material_name: must be text, found a map"},
        BadKey{"symbol: [umat_]", "9: symbol: must be text, found a list"}),
    [](const auto& instance) { return "number_" + std::to_string(instance.index); });

TEST(ForeignDescription, DamagedIsReadOrRefusedInOneLine) {
  constexpr unsigned descriptions = 1000;
  const std::string hard = "{}[]:,-#&*!|>'\"%@` \n\t~.0e\xff";
  for (unsigned seed = 0; seed < descriptions; ++seed) {
    std::mt19937 random(seed);
    std::string yaml = RandomDescription(seed).yaml();
    for (unsigned k = random() % 4; k < 4; ++k) yaml[random() % yaml.size()] = hard[random() % hard.size()];
    const std::string found = refusal_of([&] { read_description(yaml, file); });
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
    EXPECT_TRUE(found == "accepted" || found.starts_with(file + ":")) << found;
  }
}

TEST(ForeignDescription, AnUnknownInterfaceIsToldWithTheNearest) {
  EXPECT_EQ(refusal_of([] { read_description("library: a.so\ninterface: umatt\n", file); }),
            file +
                ":2:12: interface: unknown value 'umatt' (nearest: umat); known: native, umat, vumat, mfront, "
                "usermat, lsdyna");
}

}  // namespace
}  // namespace assay::drivers::test_foreign_description
