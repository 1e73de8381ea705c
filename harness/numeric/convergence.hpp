// SPDX-License-Identifier: BSD-3-Clause
// Orders of convergence: fitted with their uncertainty, and whether they are those of the asymptotic range.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace assay {

/// A least-squares fit of log(error) against log(h).
struct FittedOrder {
  double order = 0;
  std::optional<double> lower, upper;  ///< 95 % confidence interval (Student's t); absent of two resolutions

  static void fields(auto& self, auto& archive) {
    archive("order", self.order);
    archive("lower", self.lower);
    archive("upper", self.upper);
  }
};

/// h: resolutions, in any order; error: of each, the same number of them. Absent of fewer than two different
/// resolutions, or where an h or an error is not above 0 and finite. The interval supposes that the deviations from a
/// power law are independent and equally large in log(error); those of a smooth next term are not.
std::optional<FittedOrder> fitted_order(const std::vector<double>& h, const std::vector<double>& error);

/// Observed order p of error ~ h^p from the resolution before, the coarsest first; absent of the first, and where an h
/// or an error is not above 0 and finite or the two resolutions are the same.
std::vector<std::optional<double>> pairwise_orders(const std::vector<double>& h, const std::vector<double>& error);

enum class AsymptoticRange { reached, not_reached, unknown };
constexpr std::array<const char*, 3> names_of(AsymptoticRange) { return {"reached", "not_reached", "unknown"}; }

/// The most by which the orders between the three finest resolutions may differ. On grids that are halved two orders of
/// an error C h^p (1 + a h), a > 0, never differ by more than 0.17, for the local order goes from p to p + 1 over many
/// of them: a wider bound would refuse none of these. At 0.1 the next term is a tenth of the leading one on the finest
/// grid, and the finer of the two orders misses p by 0.13.
inline constexpr double order_tolerance = 0.1;

/// Orders below are those of an error that tends to a floor: the lowest of the L2 norm is that of a jump, 1/2, here
/// less the tolerance.
inline constexpr double least_order = 0.5 - order_tolerance;

/// The three finest resolutions must span as much in h: 1.3 a grid (ASME V&V 20). Closer ones agree
/// in their orders whatever the range.
inline constexpr double least_span = 1.3 * 1.3;

struct RangeJudgement {
  AsymptoticRange range = AsymptoticRange::unknown;
  std::string sentence;  ///< "reached: orders 1.97 and 2.01 on the three finest differ by 0.04, at most 0.1"
};

/// Whether the two orders between the three finest resolutions agree (order_tolerance) and the error falls
/// (least_order). The coarsest first, as pairwise_orders. That orders agree is necessary and not sufficient: three
/// resolutions cannot tell a range from a chance.
RangeJudgement asymptotic_range(const std::vector<double>& h, const std::vector<double>& error);

}  // namespace assay
