// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/mtest_components.hpp"

#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

const std::vector<MtestHypothesis>& all_hypotheses() {
  using Words = std::vector<std::string>;
  static const std::vector<MtestHypothesis> all = [] {
    const Words line{"RR", "ZZ", "TT"}, ring{"RR", "ZZ", "TT", "RZ"}, plane{"XX", "YY", "ZZ", "XY"};
    const Words plane_general{"XX", "YY", "ZZ", "XY", "YX"};
    return std::vector<MtestHypothesis>{{"AxisymmetricalGeneralisedPlaneStrain", line, line, {"R"}},
                                        {"AxisymmetricalGeneralisedPlaneStress", line, line, {"R"}},
                                        {"Axisymmetrical", ring, {"RR", "ZZ", "TT", "RZ", "ZR"}, {"R", "Z"}},
                                        {"PlaneStress", plane, plane_general, {"X", "Y"}},
                                        {"PlaneStrain", plane, plane_general, {"X", "Y"}},
                                        {"GeneralisedPlaneStrain", plane, plane_general, {"X", "Y"}},
                                        {"Tridimensional",
                                         {"XX", "YY", "ZZ", "XY", "XZ", "YZ"},
                                         {"XX", "YY", "ZZ", "XY", "YX", "XZ", "ZX", "YZ", "ZY"},
                                         {"X", "Y", "Z"}}};
  }();
  return all;
}

}  // namespace

const MtestHypothesis* find_hypothesis(const std::string& name) {
  for (const MtestHypothesis& each : all_hypotheses())
    if (each.name == name) return &each;
  return nullptr;
}

const std::vector<std::string>& hypothesis_names() {
  static const std::vector<std::string> names = mapped(all_hypotheses(), &MtestHypothesis::name);
  return names;
}

std::vector<std::string> component_names(const MtestHypothesis& hypothesis, char letter) {
  const std::vector<std::string>& ends = letter == 'F' ? hypothesis.general : hypothesis.symmetric;
  return mapped(ends, [&](const std::string& end) { return letter + end; });
}

}  // namespace assay::drivers
