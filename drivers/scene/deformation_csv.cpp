// SPDX-License-Identifier: BSD-3-Clause
// A table of F, read from a CSV file.
#include "drivers/scene/scene_reader.hpp"

#include "drivers/format/csv.hpp"
#include "drivers/format/csv_lines.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/units.hpp"
#include "drivers/text/words.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

namespace {

constexpr double rounding = 1e-12;          ///< of the F = I that another program wrote
constexpr std::size_t most_rows = 100'000;  ///< an interpolant holds them nine times

const char* const names[] = {"F11", "F12", "F13", "F21", "F22", "F23", "F31", "F32", "F33"};

[[noreturn]] void refuse(const CsvTable& table, std::size_t row, const std::string& key, const std::string& what) {
  throw InputError(Location{table.file, table.lines[row], 1}, key, what);
}

std::vector<Tensor> gradients(const CsvTable& table) {
  std::vector<Tensor> F(table.rows(), Tensor::Identity());
  int out_of_plane = 0;
  for (int c = 0; c < 9; ++c) {
    const auto* column = table.column(names[c]);
    if (!column) continue;
    if (c == 2 || c == 5 || c == 6 || c == 7) ++out_of_plane;
    for (std::size_t i = 0; i < F.size(); ++i) component(F[i], c) = (*column)[i];
  }
  if (out_of_plane != 0 && out_of_plane != 4) {
    throw InputError(Location{table.file, table.header_line, 1}, {}, "F13, F23, F31 and F32 only come together");
  }
  return F;
}

/// "t", or as it stands with its unit: "t [ms]".
std::string column_of_time(const std::string& text, const std::string& file) {
  CsvLines lines(text, file);
  for (const CsvField& field : lines.next().value_or(std::vector<CsvField>()))
    if (heading_of(field.text).name == "t") return field.text;
  return "t";
}

Scale scale_of_time(const std::string& word, const Location& where) {
  const auto unit = parse_unit(word);
  if (!unit || unit->dimension != parse_unit("s")->dimension)
    throw InputError(where, "", "'" + word + "' of the column 't' is no unit of a time", joined(unit_words("s")));
  return unit->scale;
}

void check_rows(const CsvTable& table, const std::vector<double>& t, const std::vector<Tensor>& F) {
  if (table.rows() < 2) refuse(table, 0, {}, "a path needs two rows at least");
  if (table.rows() > most_rows) refuse(table, most_rows, {}, "more than " + std::to_string(most_rows) + " rows");
  if (t[0] != 0) refuse(table, 0, "t", "the first row must be at t = 0, found " + number_text(t[0]));
  if (!((F[0] - Tensor::Identity()).cwiseAbs().maxCoeff() <= rounding)) {
    refuse(table, 0, {}, "the first row must be the undeformed state, F = I");
  }
  constexpr double least_share = 1e-12;  // of the path: times between closer rows could not be told apart
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!(t[i] > t[i - 1]))
      refuse(table, i, "t", "times must ascend, found " + number_text(t[i]) + " after " + number_text(t[i - 1]));
    if (t[i] - t[i - 1] < least_share * t.back())
      refuse(table, i, "t",
             "rows may not lie closer than 1e-12 of the whole, found " + number_text(t[i]) + " after " +
                 number_text(t[i - 1]));
    const double dt = t[i] - t[i - 1];
    if (!std::isfinite(1 / (dt * dt)))
      refuse(table, i, "t",
             "a time of " + rounded_text(dt, 3) + " s between rows leaves no number for their acceleration");
  }
}

}  // namespace

DeformationTable read_deformation_table(const std::string& file, Interpolation interpolation, const std::string& time) {
  const std::string text = read_input_file(file);
  const std::string times = column_of_time(text, file), unit = heading_of(times).unit;
  const CsvTable table = read_csv(text, file, {times, "F11", "F12", "F21", "F22"}, {"F13", "F23", "F31", "F32", "F33"});
  std::vector<double> t = *table.column(times);
  const Scale scale = scale_of_time(unit.empty() ? time : unit, {file, table.header_line, 1});
  for (double& each : t) each = scale.to_si(each);
  std::vector<Tensor> F = gradients(table);
  check_rows(table, t, F);
  F[0].setIdentity();
  DeformationTable path(file, t, F, interpolation);
  const DeformationTable::Determinant worst = path.smallest_determinant();
  if (!(worst.value > 0)) {
    const bool at_row = worst.t == t[worst.row + 1];
    refuse(table, worst.row + 1, {},
           std::string("det F <= 0 ") + (at_row ? "in this row" : "between this row and the one before") +
               ", at t = " + rounded_text(worst.t, 6) +
               (at_row || interpolation != Interpolation::spline
                    ? ""
                    : ": the spline swings beyond its rows; motion.interpolation: monotone does not"));
  }
  return path;
}

}  // namespace assay::drivers
