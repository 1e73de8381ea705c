// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/clock.hpp"

#include <algorithm>

#include "drivers/output/number_format.hpp"
#include "drivers/output/numbers.hpp"

namespace assay::drivers {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

bool is_disturbed(const ClockReadings& clock) {
  return !clock.others.empty() && median(clock.others) > disturbing_share * cores_of(clock.machine);
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
