// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/errors_csv.hpp"

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

std::string errors_csv(const std::vector<ErrorSample>& history) {
  std::vector<std::string> names{"t"};
  for (const ErrorNorm& norm : error_norms) names.emplace_back(norm.column);
  CsvText out(names);
  for (const ErrorSample& at : history) {
    std::vector<double> row{at.t};
    for (const ErrorNorm& norm : error_norms) row.push_back(norm.of(at));
    out.row(row);
  }
  return out.text();
}

std::vector<std::array<double, 2>> displacement_history(std::string_view text) {
  std::vector<std::array<double, 2>> history;
  if (!text.starts_with("t,l2,")) return history;
  const std::string file = "errors.csv";
  try {
    CsvLines lines(text, file);
    lines.next();
    while (const auto fields = lines.next()) {
      if (fields->size() < 3) continue;  // a torn row
      const auto t = parse_number((*fields)[0].text), l2 = parse_number((*fields)[1].text);
      if (t && l2) history.push_back({*t, *l2});
    }
  } catch (const InputError&) {
    history.clear();
  }
  return history;
}

}  // namespace assay::drivers
