// SPDX-License-Identifier: BSD-3-Clause
// Whether an error that should be rounding grows exponentially.
#include "drivers/simulation/health.hpp"

#include <cmath>
#include <span>

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t most_looked_at = 200;  ///< samples: every pair of them bounds a stretch
constexpr std::size_t fewest_samples = 7;    ///< of a stretch
constexpr double least_factor = 1e3;         ///< rounding that adds up step by step grows less in the same time
const double nearness = std::log(3.0);       ///< to the line, of all samples: t^2 strays further in such a stretch

struct Moment {
  double t, log_error;
};

std::vector<Moment> moments_of(const std::vector<ErrorSample>& history) {
  std::vector<Moment> points;
  const std::size_t stride = history.size() / most_looked_at + 1;
  for (std::size_t k = 0; k < history.size(); k += stride) {
    const double error = history[k].displacement.l2;
    if (error > 0 && std::isfinite(error)) points.push_back({history[k].t, std::log(error)});
  }
  return points;
}

/// The line of least squares through points; nothing where one is further from it than `nearness`.
std::optional<double> slope_of(std::span<const Moment> points) {
  double t = 0, y = 0, tt = 0, ty = 0;
  const auto n = static_cast<double>(points.size());
  for (const Moment& p : points) t += p.t / n, y += p.log_error / n;
  for (const Moment& p : points) tt += (p.t - t) * (p.t - t), ty += (p.t - t) * (p.log_error - y);
  const double slope = ty / tt;
  for (const Moment& p : points) {
    if (!(std::abs(p.log_error - y - slope * (p.t - t)) <= nearness)) return std::nullopt;
  }
  return slope;
}

}  // namespace

std::optional<GrowthFigures> growth_of(const std::vector<ErrorSample>& history) {
  const std::vector<Moment> points = moments_of(history);
  std::optional<GrowthFigures> best;
  double most = std::log(least_factor);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + fewest_samples - 1; j < points.size(); ++j) {
      const double grown = points[j].log_error - points[i].log_error;
      if (!(grown > most)) continue;
      const auto slope = slope_of(std::span(points).subspan(i, j - i + 1));
      if (!slope) continue;
      most = grown;
      best = GrowthFigures{*slope, points[i].t, points[j].t};
    }
  }
  return best;
}

std::string growth_sentence(const GrowthFigures& growth, mpm::TractionForm form, const Units& units) {
  const bool reference = form == mpm::TractionForm::reference;
  const std::string rate = rounded_text(units.scale("1/s").from_si(growth.rate), 3);
  return "the error grows as exp(" + rate + " t/" + units.time + ") from t = " + units.text(growth.from, "s", 3) +
         " to " + units.text(growth.to, "s", 3) + ": the exact motion is not stable under tractions of the " +
         (reference ? "reference form, P N dA0; take traction.form: follower"
                    : "follower form, sigma n ds; take traction.form: reference");
}

}  // namespace assay::drivers
