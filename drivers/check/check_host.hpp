// SPDX-License-Identifier: BSD-3-Clause
// What the answer of a UMAT or VUMAT depends on that a host of one point keeps constant: the same steps again with
// other counters, places, temperatures, lengths.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/host_values.hpp"
#include "drivers/check/check_report.hpp"
#include "drivers/material/material_choice.hpp"

namespace assay::drivers {

inline constexpr const char* host_test = "calls.host";

/// One thing that the host tells, and other values of it.
struct HostVariation {
  struct Value {
    std::string words;  ///< "at 10"
    std::function<void(adapters::HostValues&)> set;
  };
  std::string name;  ///< as the interface has it
  bool counts;       ///< how far the host is, by which no material can tell anything
  std::vector<Value> values;
  bool of_later_steps = counts;   ///< in a point's first step set-up code looks at it, and rightly
  bool is_a_combination = false;  ///< with counters that are tried alone: it tells nothing where one of these does
  bool of_an_output = false;      ///< which the material is to set, whatever it held
};

/// Of that interface, one after the other.
std::vector<HostVariation> host_variations(const adapters::ForeignModel& model);

/// What another value of one thing has done to the same steps.
struct HostEffect {
  double stress = 0;    ///< largest change, of the largest stress
  double tangent = 0;   ///< largest change of the tangent, of its largest component
  bool state = false;   ///< whether the state is another
  bool taken = true;    ///< whether the same steps are taken
  bool process = true;  ///< whether the process has come back
  bool matters() const { return stress > 0 || tangent > 0 || state || !taken || !process; }
};

struct HostFinding {
  check::TestResult test;
  std::vector<Dependence> depends_on;
};

/// strain, pressure: of the battery's histories. Nothing for other interfaces.
std::optional<HostFinding> depends_on_host(const ResolvedMaterial& material, double strain, double pressure);

}  // namespace assay::drivers
