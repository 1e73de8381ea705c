// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/clock.hpp"

#include <algorithm>

#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

bool is_disturbed(const ClockReadings& clock) {
  return !clock.others.empty() && median(clock.others) > disturbing_share * cores_of(clock.machine);
}

MeasuredLoad load_of(const StudyFindings& findings) {
  MeasuredLoad load;
  double busy = 0, seconds = 0;
  for (const StudyCase& one : findings.cases) {
    const ClockReadings& clock = one.clock;
    if (!clock.alone || clock.others.empty()) continue;
    ++load.timed;
    if (is_disturbed(clock)) ++load.disturbed;
    double length = 0;
    for (std::size_t k = 0; k < clock.others.size(); ++k) length += k < clock.wall_s.size() ? clock.wall_s[k] : 1;
    busy += length * median(clock.others) / cores_of(clock.machine);
    seconds += length;
  }
  if (seconds > 0) load.share = std::min(1.0, busy / seconds);
  return load;
}

std::string load_sentence(const StudyFindings& findings) {
  const MeasuredLoad load = load_of(findings);
  if (!load.noticeable() || findings.cost_unit != "s") return {};
  return "times were measured while other programs used " + rounded_text(100 * load.share, 2) +
         " % of the processors, and more than " + rounded_text(100 * disturbing_share, 3) + " % beside " +
         std::to_string(load.disturbed) + " of " + std::to_string(load.timed) + " cases: compare them with care";
}

std::string disturbing_text() { return rounded_text(100 * disturbing_share, 3) + " % of the machine"; }

int cores_of(const std::string& machine) {
  const std::size_t comma = machine.rfind(", ");
  const std::size_t end = machine.find(' ', comma == machine.npos ? 0 : comma + 2);
  if (comma == machine.npos || end == machine.npos) return 1;
  const auto cores = parse_integer(machine.substr(comma + 2, end - comma - 2)).value_or(1);
  return static_cast<int>(std::clamp<std::int64_t>(cores, 1, 1 << 20));
}

}  // namespace assay::drivers
