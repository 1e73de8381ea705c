// SPDX-License-Identifier: BSD-3-Clause
// Paths in the units of their author.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/format/csv.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/path/path_tabulation.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/author_text.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_path_units {
namespace {

const std::string head = "units: {length: mm, stress: MPa, time: ms}\n";

PathScene scene_of_text(const std::string& text) { return path_scene_of(read_yaml(text, "p.yaml"), "p.yaml", {}); }

const std::string si_material =
    "material: {adapter: norton, parameters: {E: 2.0e+11, nu: 0.3, reference_rate: 1.0e-3, reference_stress: 1.0e+8, "
    "exponent: 5}, density: 7850}\n";
const std::string own_material =
    "material: {adapter: norton, parameters: {E: 200000, nu: 0.3, reference_rate: 1.0e-6, reference_stress: 100, "
    "exponent: 5}, density: 7.85e-3}\n";

/// Every number that a path can have, in SI and in mm, MPa and ms.
struct Twin {
  std::string si, own;
};
const std::vector<Twin> twins{
    {"control: {s11: 2.0e+8}, end: 3, initial_stress: [1.0e+6, 2.0e+6, 0, 0, 0, 0]",
     "control: {s11: 200}, end: 3000, initial_stress: [1, 2, 0, 0, 0, 0]"},
    {"type: triaxial, confinement: 1.0e+5, control: {s11: {type: ramp, from: -1.0e+5, to: -3.0e+5, begin: 1, end: 4}}",
     "type: triaxial, confinement: 0.1, control: {s11: {type: ramp, from: -0.1, to: -0.3, begin: 1000, end: 4000}}"},
    {"control: {tau11: {type: sine, amplitude: 1.0e+7, mean: 2.0e+7, period: 0.5, phase: 90}}",
     "control: {tau11: {type: sine, amplitude: 10, mean: 20, period: 500, phase: 90}}"},
    {"control: {P11: {type: cycles, sizes: [1.0e+7, 2.0e+7], period: 2}}",
     "control: {P11: {type: cycles, sizes: [10, 20], period: 2000}}"},
    {"control: {L11: {type: table, times: [0, 2], values: [0.01, 0.03]}}",
     "control: {L11: {type: table, times: [0, 2000], values: [1.0e-5, 3.0e-5]}}"},
    {"control: {e11: 0.01, s22 - 2.0e+9 e22: 3.0e+6}", "control: {e11: 0.01, s22 - 2000 e22: 3}"},
    {"control: {pressure: 1.0e+6, e22 - e11: 0, e33 - e11: 0}", "control: {pressure: 1, e22 - e11: 0, e33 - e11: 0}"},
    {"control: {e11: {type: ramp, to: 0.1}}, stop: [{above: {s11: 1.0e+8}}, {below: {s11 - 1.0e+9 e11: -5.0e+6}}, "
     "{above: {e11: 0.05}}, {peak: s11}]",
     "control: {e11: {type: ramp, to: 0.1}}, stop: [{above: {s11: 100}}, {below: {s11 - 1000 e11: -5}}, {above: {e11: "
     "0.05}}, {peak: s11}]"}};

TEST(PathUnits, EveryNumberIsTheSame) {
  for (const Twin& twin : twins) {
    SCOPED_TRACE(twin.own);
    const PathScene own = scene_of_text(head + own_material + "path: {" + twin.own + "}\n");
    PathScene si = scene_of_text(si_material + "path: {" + twin.si + "}\n");
    si.material.parameters = own.material.parameters;  // which the model's table converts
    expect_same_text(resolved_path_yaml(own), resolved_path_yaml(si));
  }
}

struct Tabulated {
  int status = 0;
  nlohmann::json result;
  std::string csv, resolved;
};

Tabulated tabulated(const std::string& text) {
  const ScratchFolder scratch;
  scratch.write("plain.csv", "t,s11\n0,0\n1000,150\n2000,150\n");
  scratch.write("headed.csv", "t [s],s11 [Pa]\n0,0\n1,1.5e8\n2,1.5e8\n");
  TabulateOptions options;
  options.scene = scratch.write("path.yaml", text);
  options.out = scratch / "out";
  options.verbosity = Verbosity::quiet;
  Tabulated found;
  found.status = tabulate(options);
  found.csv = bytes_of(options.out + "/path.csv");
  found.resolved = bytes_of(options.out + "/resolved.yaml");
  found.result = nlohmann::json::parse(bytes_of(options.out + "/result.json"));
  if (text.find("plain.csv") != text.npos) {  // and the same once more, in SI, as long as the file is there
    options.scene = options.out + "/resolved.yaml", options.out = scratch / "again";
    EXPECT_EQ(tabulate(options), found.status);
    const auto again = nlohmann::json::parse(bytes_of(options.out + "/result.json"));
    EXPECT_DOUBLE_EQ(again["last"]["s11"].get<double>(), 1e6 * found.result["last"]["s11"].get<double>());
    EXPECT_DOUBLE_EQ(again["t"].get<double>(), 1e-3 * found.result["t"].get<double>());
    EXPECT_EQ(again["misfit"], found.result["misfit"]);
    EXPECT_EQ(bytes_of(options.out + "/resolved.yaml"), found.resolved);
  }
  return found;
}

// The model's own equations know nothing of units: creep e = s/E + rate (s/reference)^n t, to first order in strain.
TEST(LongPathUnits, ResultsAreInThem) {
  constexpr double rounding = 1e-12;
  const std::string expect =
      "expect: {outcome: completed, last.s11: {between: [199, 201]}, t: {above: 2999}, "
      "largest.work: {above: 0.1}}\n";
  const Tabulated own =
      tabulated(head + own_material + "path: {type: uniaxial_stress, control: {s11: 200}, end: 3000}\n" + expect);
  const Tabulated si = tabulated(si_material + "path: {type: uniaxial_stress, control: {s11: 2.0e+8}, end: 3}\n");
  EXPECT_EQ(own.status, 0) << own.result["expect"];
  EXPECT_EQ(own.result["units"]["stress"], "MPa");
  EXPECT_EQ(si.result["units"]["time"], "s");
  const auto same = [&](const char* name, double unit) {
    const double a = own.result.at("last").at(name), b = si.result.at("last").at(name);
    EXPECT_NEAR(a * unit, b, rounding * std::abs(b)) << name;
  };
  same("s11", 1e6), same("t", 1e-3), same("e11", 1), same("e22", 1), same("work", 1e6), same("p", 1);
  EXPECT_EQ(own.csv.substr(0, 18), "# units: t [ms], F");
  EXPECT_NE(own.csv.find("s11 [MPa]"), std::string::npos);
  EXPECT_NE(own.csv.find("work [MPa]"), std::string::npos);
  EXPECT_EQ(own.resolved.find("units"), std::string::npos) << "in SI";
  EXPECT_NE(own.resolved.find("last.s11: {between: [1.99e+8, 2.01e+8]}"), std::string::npos) << own.resolved;
}

TEST(LongPathUnits, AFileWithoutUnitsIsInThem) {
  const auto last = [&](const std::string& file, const std::string& more) {
    const Tabulated found =
        tabulated(head + own_material + "path: {type: uniaxial_stress, control: {s11: {type: file, file: " + file +
                  more + "}}}\ncompare: {file: " + file + ", y: s11}\n");
    EXPECT_NEAR(found.result["misfit"].get<double>(), 0, 1e-9);
    EXPECT_NEAR(found.result["t"].get<double>(), 2000, 1e-9) << "ms";
    return found.result["last"]["s11"].get<double>();
  };
  EXPECT_NEAR(last("plain.csv", ""), 150, 1e-6);
  EXPECT_NEAR(last("headed.csv", ""), 150, 1e-6) << "the header wins";
}

TEST(PathUnits, MessagesAreInThem) {
  EXPECT_NE(refusal_of([] {
              scene_of_text(head + own_material + "path: {control: {e11: 0.1}, end: 1.0e+13}\n");
            }).find("1e+12"),
            std::string::npos)
      << "1e9 s in ms";
  EXPECT_NE(refusal_of([] {
              scene_of_text(head + own_material +
                            "path: {control: {e11: {type: ramp, to: 1, begin: 900, end: 1000}}, end: 500}\n");
            }).find("500 ms"),
            std::string::npos);
  EXPECT_NE(refusal_of([] {
              scene_of_text("units: {time: sec}\n" + own_material + "path: {control: {e11: 0.1}}\n");
            }).find("known: s, ms, us, min, h"),
            std::string::npos);
}

/// Limits on figures of a variant are in the units of the scene as well, and resolved.yaml holds as the scene does.
TEST(LongPathUnits, LimitsOnVariantsAreConverted) {
  const std::string text =
      "units: {length: mm, stress: MPa, time: min}\n"
      "material: {adapter: neo_hookean, parameters: {E: 10, nu: 0.3}, density: 1.0e-9}\n"
      "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 0.02}}, end: 2}\n"
      "variants: [{label: B, parameters: {E: 20}}]\n"
      "expect: {last.s11: {between: [0.1, 0.3]}, variants.B.last.s11: {between: [0.3, 0.5]}, "
      "variants.B.t: {between: [1.9, 2.1]}}\n";
  const Tabulated found = tabulated(text);
  EXPECT_EQ(found.status, 0);
  const Tabulated again = tabulated(found.resolved);
  EXPECT_EQ(again.status, 0) << found.resolved;
}

/// ln J has no indices.
TEST(PathUnits, VolumeBesideAStressIsConverted) {
  const PathScene scene =
      scene_of_text(head + own_material + "path: {control: {s11 + 1000 lnJ: 0, e22: 0.01, e33: 0}}\n");
  EXPECT_NE(resolved_path_yaml(scene).find("s11 + 1.0e+9 lnJ\": 0"), std::string::npos) << resolved_path_yaml(scene);
}

}  // namespace
}  // namespace assay::drivers::test_path_units
