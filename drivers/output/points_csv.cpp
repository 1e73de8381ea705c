// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/points_csv.hpp"

#include <algorithm>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

void require_time(double t, const CsvTable& table, std::size_t row) {
  if (t < 0) throw InputError(Location{table.file, table.lines[row], 1}, "t", "negative: histories begin at t = 0");
}

}  // namespace

ReferencePoints read_reference_points(const std::string& file) {
  const CsvTable table =
      read_csv(read_input_file(file), file, {"X", "Y", "t"}, {"Z", "NX", "NY", "NZ", "HX", "HY", "HZ"});
  const auto *X = table.column("X"), *Y = table.column("Y"), *Z = table.column("Z"), *t = table.column("t");
  const auto *NX = table.column("NX"), *NY = table.column("NY"), *NZ = table.column("NZ");
  const auto *HX = table.column("HX"), *HY = table.column("HY"), *HZ = table.column("HZ");
  const auto require_together = [&](auto* X_of, auto* Y_of, auto* Z_of, const std::string& letter) {
    if (!X_of == !Y_of && (X_of || !Z_of)) return;
    const std::string both = letter + "X and " + letter + "Y";
    throw InputError(Location{file, table.header_line, 1}, {},
                     Z_of ? letter + "Z only comes with " + both : both + " only come together",
                     "X, Y, Z, t, NX, NY, NZ, HX, HY, HZ");
  };
  require_together(NX, NY, NZ, "N");
  require_together(HX, HY, HZ, "H");
  ReferencePoints out;
  out.has_z = Z != nullptr;
  out.has_normals = NX != nullptr, out.has_third_normal = NZ != nullptr;
  out.has_boxes = HX != nullptr, out.has_third_edge = HZ != nullptr;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    ReferencePoint point{(*X)[i], (*Y)[i], Z ? (*Z)[i] : 0, (*t)[i]};
    if (NX) point.NX = (*NX)[i], point.NY = (*NY)[i];
    if (NZ) point.NZ = (*NZ)[i];
    if (HX) point.HX = (*HX)[i], point.HY = (*HY)[i];
    point.HZ = HZ ? (*HZ)[i] : point.HX;
    point.line = table.lines[i];
    if (HX && !(std::min({point.HX, point.HY, point.HZ}) > 0))
      throw InputError(Location{file, table.lines[i], 1}, {}, "the half edges HX, HY, HZ must be greater than 0");
    if (NX && point.NX == 0 && point.NY == 0 && point.NZ == 0) {
      throw InputError(Location{file, table.lines[i], 1}, {},
                       std::string("the normal NX,NY") + (NZ ? ",NZ" : "") + " has no length");
    }
    require_time(point.t, table, i);
    out.points.push_back(point);
  }
  return out;
}

std::vector<SheetPoint> read_sheet_points(const std::string& file) {
  const CsvTable table = read_csv(read_input_file(file), file, {"xi", "t"});
  const auto *xi = table.column("xi"), *t = table.column("t");
  std::vector<SheetPoint> out;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    require_time((*t)[i], table, i);
    out.push_back({(*xi)[i], (*t)[i], table.lines[i]});
  }
  return out;
}

}  // namespace assay::drivers
