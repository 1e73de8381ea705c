// SPDX-License-Identifier: BSD-3-Clause
// Which other values of what the host tells are tried.
#include <algorithm>

#include "drivers/check/check_foreign.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;
using adapters::ForeignModel;
using adapters::HostValues;
using Value = HostVariation::Value;
using Variations = std::vector<HostVariation>;

/// In later steps than a point's first: 1 is what set-up code asks for, and rightly.
HostVariation counter(const std::string& name, int HostValues::*place, const std::vector<int>& values,
                      bool counts = true) {
  HostVariation variation{name, counts, {}};
  for (const int value : values) {
    variation.values.push_back({"at " + std::to_string(value), [=](HostValues& host) { host.*place = value; }});
  }
  return variation;
}

/// KINC is 1 again where another step of the analysis begins: a set-up that asks for KINC alone begins anew.
Variations increments() {
  HostVariation increment{"KINC", true, {}};
  for (const int value : {3, 10, 100, 1000, 100000}) {
    increment.values.push_back({"at " + std::to_string(value), [=](HostValues& host) { host.increment = value; }});
  }
  HostVariation step = counter("KSTEP", &HostValues::step, {2, 3, 10, 100});
  step.values.push_back(
      {"where a second step begins (KSTEP 2, KINC 1)", [](HostValues& host) { host.step = 2, host.increment = 1; }});
  return {increment, step};
}

HostVariation multiples(const std::string& name, double HostValues::*place) {
  HostVariation variation{name, false, {}};
  for (const double times : {0.01, 0.5, 2.0, 10.0}) {
    variation.values.push_back(
        {"at " + rounded_text(times, 3) + " times its value", [=](HostValues& host) { host.*place *= times; }});
  }
  return variation;
}

/// TIME(1) begins at 0 with each step of the analysis, and TIME(2) goes on: a set-up that asks for TIME(1) alone begins
/// anew, of a point that is loaded. What depends on the rate may follow that clock, as creep by time hardening does.
Variations step_times(const ForeignModel& model) {
  HostVariation alone = multiples("the step time TIME(1)", &HostValues::step_time_times);
  alone.counts = !(model.flags & ASSAY_RATE_DEPENDENT);
  alone.of_later_steps = true;
  if (!alone.counts) alone.values.clear();
  const Value begins{"at 0, as where a second step begins", [](HostValues& host) { host.step_time_times = 0; }};
  alone.values.insert(alone.values.begin(), begins);
  HostVariation combined = alone;
  combined.values = {{"where a second step begins (TIME(1) 0, KSTEP 2, KINC 1)",
                      [](HostValues& host) { host.step_time_times = 0, host.step = 2, host.increment = 1; }}};
  combined.is_a_combination = true;
  return {alone, combined};
}

HostVariation places(const std::string& name) {
  HostVariation variation{name, false, {}};
  for (const std::array<double, 3>& place :
       {std::array{0.3, 0.7, 0.2}, std::array{10.0, -3.0, 2.0}, std::array{-400.0, 1000.0, 70.0}}) {
    const std::string words =
        "at (" + rounded_text(place[0], 4) + ", " + rounded_text(place[1], 4) + ", " + rounded_text(place[2], 4) + ")";
    variation.values.push_back({words, [=](HostValues& host) { host.place = place; }});
  }
  return variation;
}

HostVariation temperatures(const std::string& name, double usual) {
  const double other = 1.1 * usual + 1;
  return {name,
          false,
          {{"for +10", [](HostValues& host) { host.temperature += 10; }},
           {"at " + rounded_text(other, 4), [other](HostValues& host) { host.temperature = other; }}}};
}

HostVariation field(const std::string& name, std::size_t k) {
  const auto add_one = [=](HostValues& host) {
    host.fields.resize(std::max(host.fields.size(), k + 1), 0.0);
    host.fields[k] += 1;
  };
  return {name, false, {{"for +1", add_one}}};
}

HostVariation outputs(const std::string& name) {
  HostVariation variation{name, true, {{"where it holds 1e6", [](HostValues& host) { host.outputs_before = 1e6; }}}};
  variation.of_an_output = true;
  return variation;
}

}  // namespace

std::vector<HostVariation> host_variations(const ForeignModel& model) {
  const bool umat = model.interface == ForeignInterface::umat;
  Variations all;
  const auto add = [&all](const Variations& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (umat) {
    add(increments());
    add(step_times(model));
  } else if (!(model.flags & ASSAY_RATE_DEPENDENT)) {
    add({multiples("stepTime", &HostValues::step_time_times)});
    all.back().counts = all.back().of_later_steps = true;
  }
  add({counter(umat ? "NPT" : "jblock(2)", &HostValues::point, {2, 4, 8}),
       counter(umat ? "LAYER" : "jblock(3)", &HostValues::layer, {2, 3}),
       counter(umat ? "KSPT" : "jblock(4)", &HostValues::section, {2, 3}),
       counter(umat ? "NOEL" : "jblock(5)", &HostValues::element, {2, 999, 100000}, false),
       temperatures(umat ? "TEMP" : "tempOld and tempNew", model.temperature),
       outputs(umat ? "what DDSDDE holds before the call" : "what stateNew holds before the call")});
  if (umat) add({{"DTEMP", false, {{"for 1", [](HostValues& host) { host.temperature_rise = 1; }}}}});
  add({places(umat ? "COORDS" : "coordMp"), multiples(umat ? "CELENT" : "charLength", &HostValues::length)});
  if (!umat) add({multiples("density", &HostValues::density_times)});
  constexpr std::size_t most_fields = 4;
  const std::size_t fields = umat ? most_fields : std::clamp<std::size_t>(model.fields.size(), 1, most_fields);
  for (std::size_t k = 0; k < fields; ++k) {
    add({field((umat ? "PREDEF(" : "field ") + std::to_string(k + 1) + (umat ? ")" : ""), k)});
  }
  return all;
}

}  // namespace assay::drivers
