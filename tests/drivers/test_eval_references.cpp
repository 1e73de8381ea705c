// SPDX-License-Identifier: BSD-3-Clause
// eval against fields that another program found: 80-bit numbers, histories by extrapolated midpoint steps with the
// switches of plasticity located, DIV(P) by differences of tenth order in Cartesian coordinates. It shares nothing with
// this one but the motions' definitions and the materials' rate equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_eval_references {
namespace {

constexpr double digits = 3e-9;  ///< of the largest component of a field: 8 digits are promised
const std::string folder = tree_folder() + "/tests/drivers/references/";

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".csv") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> header_of(const std::string& file) {
  const std::string text = read_bytes(file);
  std::vector<std::string> names{""};
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == ',')
      names.emplace_back();
    else
      names.back() += c;
  }
  return names;
}

/// Its points, as eval takes them.
std::string points_of(const CsvTable& table) {
  std::string header, text;
  for (const char* name : {"X", "Y", "Z", "t", "NX", "NY", "NZ"}) {
    if (table.column(name)) header += (header.empty() ? "" : ",") + std::string(name);
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::string row;
    for (const char* name : {"X", "Y", "Z", "t", "NX", "NY", "NZ"}) {
      if (const auto* column = table.column(name)) row += (row.empty() ? "" : ",") + number_text((*column)[i]);
    }
    text += row + "\n";
  }
  return header + "\n" + text;
}

class EvalReferences : public testing::TestWithParam<std::string> {};

TEST_P(EvalReferences, AgreesToEightDigits) {
  const ScratchFolder scratch;
  const std::string file = folder + GetParam() + ".csv";
  const CsvTable expected = read_csv(read_bytes(file), file, header_of(file));
  EvalOptions options;
  options.scene = folder + GetParam() + ".yaml";
  options.points = scratch.write("points.csv", points_of(expected));
  options.out = scratch / "exact.csv";
  ASSERT_EQ(eval(options), 0);
  const CsvTable found = read_csv(read_bytes(options.out), options.out, header_of(options.out));
  ASSERT_EQ(found.rows(), expected.rows());
  std::map<char, double> scale, difference;  // of fields, by their first letter
  for (const std::string& name : header_of(file)) {
    if (name[0] == 'N') continue;
    ASSERT_TRUE(found.column(name)) << name;
    for (std::size_t i = 0; i < expected.rows(); ++i) {
      const double wanted = (*expected.column(name))[i];
      scale[name[0]] = std::max(scale[name[0]], std::abs(wanted));
      difference[name[0]] = std::max(difference[name[0]], std::abs((*found.column(name))[i] - wanted));
    }
  }
  const bool unstressed = GetParam().starts_with("rigid");
  for (const auto& [field, error] : difference) {
    const double size = unstressed && field == 'P' ? 1e3 : scale[field];  // of Young's modulus
    EXPECT_LE(error, digits * size) << field;
  }
}

/// Plastic rings take many steps of a history.
std::vector<std::string> cases_that_take(bool long_) {
  std::vector<std::string> chosen = cases();
  std::erase_if(chosen, [&](const std::string& name) { return name.starts_with("ring_j2") != long_; });
  return chosen;
}
const auto name_of_case = [](const auto& which) { return which.param; };
INSTANTIATE_TEST_SUITE_P(Cases, EvalReferences, testing::ValuesIn(cases_that_take(false)), name_of_case);
INSTANTIATE_TEST_SUITE_P(LongCases, EvalReferences, testing::ValuesIn(cases_that_take(true)), name_of_case);

}  // namespace
}  // namespace assay::drivers::test_eval_references
