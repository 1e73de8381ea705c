// SPDX-License-Identifier: BSD-3-Clause
// Which other values of what the host tells are tried.
#include <algorithm>

#include "drivers/check/check_foreign.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignInterface;
using adapters::ForeignModel;
using adapters::HostValues;
using Value = HostVariation::Value;
using Variations = std::vector<HostVariation>;

/// One value after the other.
template <class T>
HostVariation varied(const std::string& name, bool counts, const std::vector<T>& values,
                     const std::function<std::string(const T&)>& words,
                     const std::function<void(HostValues&, const T&)>& set) {
  HostVariation variation{name, counts, {}};
  for (const T& value : values)
    variation.values.push_back({"at " + words(value), [=](HostValues& host) { set(host, value); }});
  return variation;
}

/// In later steps than a point's first: 1 is what set-up code asks for, and rightly.
HostVariation counter(const std::string& name, const std::vector<int>& values,
                      const std::function<void(HostValues&, int)>& set, bool counts = true) {
  return varied<int>(
      name, counts, values, [](int value) { return std::to_string(value); }, set);
}

/// KINC is 1 again where another step of the analysis begins: a set-up that asks for KINC alone begins anew.
Variations increments() {
  HostVariation step = counter("KSTEP", {2, 3, 10, 100}, [](HostValues& host, int v) { host.step = v; });
  step.values.push_back(
      {"where a second step begins (KSTEP 2, KINC 1)", [](HostValues& host) { host.step = 2, host.increment = 1; }});
  return {counter("KINC", {3, 10, 100, 1000, 100000}, [](HostValues& host, int v) { host.increment = v; }), step};
}

HostVariation multiples(const std::string& name, double HostValues::*place) {
  return varied<double>(
      name, false, {0.01, 0.5, 2.0, 10.0}, [](double times) { return rounded_text(times, 3) + " times its value"; },
      [=](HostValues& host, double times) { host.*place *= times; });
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
  using Place = std::array<double, 3>;
  const auto words = [](const Place& at) {
    return "(" + rounded_text(at[0], 4) + ", " + rounded_text(at[1], 4) + ", " + rounded_text(at[2], 4) + ")";
  };
  return varied<Place>(name, false, {{0.3, 0.7, 0.2}, {10, -3, 2}, {-400, 1000, 70}}, words,
                       [](HostValues& host, const Place& place) { host.place = place; });
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

/// Of Ansys' USERMAT.
Variations of_usermat(const ForeignModel& model) {
  return {counter("isubst", {3, 10, 1000}, [](HostValues& host, int v) { host.increment = v; }),
          counter("ldstep", {2, 3, 100}, [](HostValues& host, int v) { host.step = v; }),
          counter("kDomIntPt", {2, 4, 8}, [](HostValues& host, int v) { host.point = v; }),
          counter("kLayer", {2, 3}, [](HostValues& host, int v) { host.layer = v; }),
          counter("kSectPt", {2, 3}, [](HostValues& host, int v) { host.section = v; }),
          counter(
              "elemId", {2, 999, 100000}, [](HostValues& host, int v) { host.element = v; }, false),
          temperatures("Temp", model.temperature),
          {"dTemp", false, {{"for 1", [](HostValues& host) { host.temperature_rise = 1; }}}},
          outputs("what dsdePl holds before the call"),
          places("coords")};
}

Variations of_lsdyna(const ForeignModel& model) {
  return {counter(
              "idele", {2, 999, 100000}, [](HostValues& host, int v) { host.element = v; }, false),
          temperatures("temper", model.temperature), multiples("elsiz", &HostValues::length)};
}

}  // namespace

std::vector<HostVariation> host_variations(const ForeignModel& model) {
  if (model.interface == ForeignInterface::usermat) return of_usermat(model);
  if (model.interface == ForeignInterface::lsdyna) return of_lsdyna(model);
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
  add({counter(umat ? "NPT" : "jblock(2)", {2, 4, 8}, [](HostValues& host, int v) { host.point = v; }),
       counter(umat ? "LAYER" : "jblock(3)", {2, 3}, [](HostValues& host, int v) { host.layer = v; }),
       counter(umat ? "KSPT" : "jblock(4)", {2, 3}, [](HostValues& host, int v) { host.section = v; }),
       counter(
           umat ? "NOEL" : "jblock(5)", {2, 999, 100000}, [](HostValues& host, int v) { host.element = v; }, false),
       temperatures(umat ? "TEMP" : "tempOld and tempNew", model.temperature),
       outputs(umat ? "what DDSDDE holds before the call" : "what stateNew holds before the call")});
  if (umat) add({{"DTEMP", false, {{"for 1", [](HostValues& host) { host.temperature_rise = 1; }}}}});
  add({places(umat ? "COORDS" : "coordMp"), multiples(umat ? "CELENT" : "charLength", &HostValues::length)});
  if (!umat) add({multiples("density", &HostValues::density_times)});
  constexpr std::size_t most_fields = 4;
  const std::size_t fields = umat ? most_fields : std::clamp<std::size_t>(model.fields.size(), 1, most_fields);
  for (std::size_t k = 0; k < fields; ++k)
    add({field((umat ? "PREDEF(" : "field ") + std::to_string(k + 1) + (umat ? ")" : ""), k)});
  return all;
}

}  // namespace assay::drivers
