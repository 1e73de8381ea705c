// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/points_csv.hpp"

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

std::vector<SheetPoint> read_sheet_points(const std::string& file) {
  const CsvTable table = read_csv(read_input_file(file), file, {"xi", "t"});
  const auto *xi = table.column("xi"), *t = table.column("t");
  std::vector<SheetPoint> out;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if ((*t)[i] < 0) throw InputError(Location{file, table.lines[i], 1}, "t", "negative: histories begin at t = 0");
    out.push_back({(*xi)[i], (*t)[i], table.lines[i]});
  }
  return out;
}

}  // namespace assay::drivers
