// SPDX-License-Identifier: BSD-3-Clause
// How far the figures that decide are from their limits: of what is right, and of what is planted.
#pragma once

#include <string>
#include <vector>

#include "tests/harness/check/mutants.hpp"

namespace assay::check_tests {

/// Of one subject: measure over threshold of the test that decides; 0 where that test says yes or no.
struct Margin {
  std::string subject;
  std::string kind;   ///< of model
  std::string cause;  ///< empty: nothing is planted
  std::string test;   ///< of a good model: the closest to its limit; of a mutant: the farthest beyond it
  double figure = 0;
};

Margin margin_of(const Subject& subject, const check::Report& report);

/// A row of the table of docs/check.md.
struct MarginRow {
  std::string what;  ///< cause, or name of the good model
  std::size_t planted = 0;
  double figure = 0;            ///< of the mutant that is the closest to the limit
  std::vector<Margin> closest;  ///< those that are about as close, the closest first; the figures of a good model

  std::string text() const;
  /// Compilers change figures by rounding, which is amplified by some mutants: true within a factor of two.
  bool agrees_with(const std::string& line) const;
};

/// The causes in the order in which a diagnosis lists them, then the good models.
std::vector<MarginRow> margin_rows(const std::vector<Margin>& margins);

}  // namespace assay::check_tests
