// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/figure_names.hpp"

#include <cmath>

#include "drivers/result/result_json.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

std::pair<std::string, std::string> name_and_unit(const std::string& key) {
  const Field figure = figure_of_result(key);
  if (figure.name.empty()) return {key, ""};
  return {figure.name, figure.unit == "1" ? "" : figure.unit};
}

double rounded_power(int k) { return parse_number("1e" + std::to_string(k)).value_or(k < 0 ? 0.0 : HUGE_VAL); }

}  // namespace assay::drivers
