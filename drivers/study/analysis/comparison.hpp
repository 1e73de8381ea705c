// SPDX-License-Identifier: BSD-3-Clause
// Two studies, case by case: what fails, what costs more, what is less accurate, beyond noise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

/// Errors of the same binary are the same bit for bit; another compiler or order of summation rounds otherwise. One bit
/// of the density moved the errors of configs/paper/vortex_cpdi.yaml and configs/methods/best_*.yaml by at most 1e-14
/// relative; where rounding turns a decision of an adaptive sheet, they move by its tolerance, 1e-8 by default.
inline constexpr double rounding_relative = 1e-6;

/// Errors below, in the study's unit, are rounding themselves: homogeneous deformation under tractions leaves up to
/// 4e-12 m.
inline constexpr double rounding_absolute = 1e-11;

enum class Standing { compared, new_failure, fixed, still_fails, only_in_a, only_in_b };
constexpr std::array<const char*, 6> names_of(Standing) {
  return {"compared", "new_failure", "fixed", "still_fails", "only_in_a", "only_in_b"};
}

/// A figure in A and in B.
struct ComparedFigure {
  Figure a, b;
  double bound = 0;  ///< relative, of the smaller; differences below are noise or rounding
  int trend = 0;     ///< -1: less in B, 1: more, beyond the bound; 0: the same, or not judged

  ASSAY_FIELDS(a, b, bound, trend)
};

struct ComparedCase {
  std::string label;
  std::optional<std::size_t> a, b;  ///< indices into the cases of A and of B
  Standing standing = Standing::compared;
  std::string outcome_a, outcome_b;  ///< empty where it is not there
  ComparedFigure error, cost;
  bool noise_measured = true;  ///< of the cost; false: one of the two was run once
  bool cost_judged = true;     ///< false: times of different machines, disturbed ones, or of one key
  bool is_worse() const;
  bool is_better() const;
  bool is_same() const { return !is_worse() && !is_better() && standing == Standing::compared; }

  static void fields(auto& self, auto& archive) {
    ASSAY_MEMBERS(label, standing);
    archive("worse", self.is_worse());
    archive("outcome_a", or_null(self.outcome_a));
    archive("outcome_b", or_null(self.outcome_b));
    ASSAY_MEMBERS(error, cost, noise_measured, cost_judged);
  }
};

/// The cheapest case that meets a level of error.
struct ComparedDigit {
  double error = 0;
  std::string a, b;         ///< labels; empty: none
  bool changed = false;     ///< not the same case
  bool told_apart = false;  ///< and in B the case of A is dearer beyond noise, or does not meet the level

  static void fields(auto& self, auto& archive) {
    archive("error", self.error);
    archive("a", or_null(self.a));
    archive("b", or_null(self.b));
    ASSAY_MEMBERS(changed, told_apart);
  }
};

/// An expectation that both studies have.
struct ComparedExpectation {
  std::string where, key, expected, found;
  bool holds = false;  ///< in B, and not in A; or the reverse

  ASSAY_FIELDS(where, key, expected, found, holds)
};

struct Comparison {
  std::vector<ComparedCase> cases;  ///< those of A in its order, then those only in B; not what is n/a in both
  std::vector<ComparedDigit> digits;
  std::vector<ComparedExpectation> expectations;  ///< those whose outcome changed
  std::vector<std::string> entered, left;         ///< labels of cases that are on the front of B, or of A, alone
  std::vector<std::string> warnings;

  int count(Standing standing) const;
  int costs(int trend) const;   ///< cases with that trend of cost
  int errors(int trend) const;  ///< cases with that trend of error
  int broken(bool mended = false) const;
  /// A new failure, an expectation that fails, a case that is missing, slower or less accurate.
  bool is_worse() const;
};

/// Cases are matched by their values on the axes, numbers as numbers; those of the error budget by their label too. A
/// case that is n/a or missing counts as not there. Times of different machines are not judged. Throws InputError where
/// the studies measure different errors or costs.
Comparison compared(const StudyFindings& A, const StudyFindings& B);

}  // namespace assay::drivers
