// SPDX-License-Identifier: BSD-3-Clause
// Which other values of what the host tells are tried.
#include <algorithm>

#include "drivers/check/check_host.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;
using adapters::ForeignModel;
using adapters::HostValues;
using Value = HostVariation::Value;

/// In later steps than a point's first: 1 is what set-up code asks for, and rightly.
HostVariation counter(const std::string& name, const std::vector<int>& values,
                      const std::function<void(HostValues&, int)>& set, bool counts = true) {
  HostVariation variation{name, counts, {}};
  for (const int value : values) {
    variation.values.push_back({"at " + std::to_string(value), [=](HostValues& host) { set(host, value); }});
  }
  return variation;
}

/// Where another step of the analysis begins, KINC is 1 again: a set-up that asks for KINC alone begins anew.
Value second_step() {
  return {"where a second step begins (KSTEP 2, KINC 1)", [](HostValues& host) { host.step = 2, host.increment = 1; }};
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
void add_step_time(const ForeignModel& model, std::vector<HostVariation>& all) {
  HostVariation alone = multiples("the step time TIME(1)", &HostValues::step_time_times);
  alone.counts = !(model.flags & ASSAY_RATE_DEPENDENT);
  alone.of_later_steps = true;
  if (!alone.counts) alone.values.clear();
  const Value begins{"at 0, as where a second step begins", [](HostValues& host) { host.step_time_times = 0; }};
  alone.values.insert(alone.values.begin(), begins);
  all.push_back(alone);
  alone.values = {{"where a second step begins (TIME(1) 0, KSTEP 2, KINC 1)",
                   [](HostValues& host) { host.step_time_times = 0, host.step = 2, host.increment = 1; }}};
  alone.is_a_combination = true;
  all.push_back(alone);
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
  const auto add = [=](double by) {
    return [=](HostValues& host) {
      host.fields.resize(std::max(host.fields.size(), k + 1), 0.0);
      host.fields[k] += by;
    };
  };
  return {name, false, {{"for +1", add(1)}}};
}

void add_elements(const ForeignModel& model, std::vector<HostVariation>& all) {
  const bool umat = model.interface == ForeignInterface::umat;
  all.push_back(counter(umat ? "NPT" : "jblock(2)", {2, 4, 8}, [](HostValues& h, int v) { h.point = v; }));
  all.push_back(counter(umat ? "LAYER" : "jblock(3)", {2, 3}, [](HostValues& h, int v) { h.layer = v; }));
  all.push_back(counter(umat ? "KSPT" : "jblock(4)", {2, 3}, [](HostValues& h, int v) { h.section = v; }));
  const auto set_element = [](HostValues& h, int v) { h.element = v; };
  all.push_back(counter(umat ? "NOEL" : "jblock(5)", {2, 999, 100000}, set_element, false));
}

}  // namespace

std::vector<HostVariation> host_variations(const ForeignModel& model) {
  const bool umat = model.interface == ForeignInterface::umat;
  std::vector<HostVariation> all;
  if (umat) {
    all.push_back(counter("KINC", {3, 10, 100, 1000, 100000}, [](HostValues& h, int v) { h.increment = v; }));
    all.push_back(counter("KSTEP", {2, 3, 10, 100}, [](HostValues& h, int v) { h.step = v; }));
    all.back().values.push_back(second_step());
    add_step_time(model, all);
  } else if (!(model.flags & ASSAY_RATE_DEPENDENT)) {
    all.push_back(multiples("stepTime", &HostValues::step_time_times));
    all.back().counts = all.back().of_later_steps = true;
  }
  add_elements(model, all);
  all.push_back(temperatures(umat ? "TEMP" : "tempOld and tempNew", model.temperature));
  HostVariation output{(umat ? "what DDSDDE holds before the call" : "what stateNew holds before the call"), true, {}};
  output.of_an_output = true;
  output.values = {{"where it holds 1e6", [](HostValues& host) { host.outputs_before = 1e6; }}};
  all.push_back(output);
  if (umat) {
    all.push_back({"DTEMP", false, {{"for 1", [](HostValues& host) { host.temperature_rise = 1; }}}});
  }
  all.push_back(places(umat ? "COORDS" : "coordMp"));
  all.push_back(multiples(umat ? "CELENT" : "charLength", &HostValues::length));
  if (!umat) all.push_back(multiples("density", &HostValues::density_times));
  constexpr std::size_t most_fields = 4;
  const std::size_t fields = umat ? most_fields : std::clamp<std::size_t>(model.fields.size(), 1, most_fields);
  for (std::size_t k = 0; k < fields; ++k) {
    all.push_back(field((umat ? "PREDEF(" : "field ") + std::to_string(k + 1) + (umat ? ")" : ""), k));
  }
  return all;
}

}  // namespace assay::drivers
