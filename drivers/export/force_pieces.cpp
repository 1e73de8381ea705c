// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/force_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/exact/places.hpp"
#include "harness/numeric/chebyshev.hpp"

namespace assay::drivers {

namespace {

/// Of a piece in each direction. In powers the coefficients of degree n grow as (1 + sqrt 2)^n: 16 costs six digits of
/// sixteen, which is why a piece is rather halved than given a higher degree.
constexpr int force_degree = 16;
constexpr int force_nodes = force_degree + 1;
constexpr int checks = 29;  ///< radii and times of a piece at which it is compared, none of them a node

/// b at radii and times: radial and tangential [m/s^2].
using ForceValues = std::array<ForceMatrix, 2>;

ForceValues force_values(const ExactSolution& solution, const ForceFit& fit, const std::vector<double>& radii,
                         const std::vector<double>& times) {
  std::vector<Vector3> X;
  for (const double R : radii) X.emplace_back(R, 0, 0);
  const auto places = solution.places(X);
  const PolarMotion& polar = *solution.motion()->polar();
  ForceValues table;
  table.fill(ForceMatrix(radii.size(), times.size()));
  std::vector<std::array<double, 2>> b(radii.size());
  FieldViews wanted;
  wanted.dimension = 2;
  (fit.quasi_static ? wanted.static_force : wanted.b) = {b.front().data(), 2, 1};
  for (std::size_t k = 0; k < times.size(); ++k) {
    stop_if_interrupted();
    places->evaluate(*solution.slice(times[k]), 0, radii.size(), wanted);
    const double g = polar.turn().at(times[k]).value;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const double alpha = g * polar.profile(radii[i]).h;  // at (R, 0) the axes are E_R and E_Theta
      const double c = std::cos(alpha), s = std::sin(alpha);
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(k);
      table[0](row, column) = c * b[i][0] + s * b[i][1];
      table[1](row, column) = c * b[i][1] - s * b[i][0];
    }
  }
  return table;
}

double from_minus_1_to_1(const std::vector<double>& edges, std::size_t k, double x) {
  return (2 * x - (edges[k] + edges[k + 1])) / (edges[k + 1] - edges[k]);
}

/// The interval that holds x, the first or last one beyond all.
std::size_t interval_of(const std::vector<double>& edges, double x) {
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, x);
  return static_cast<std::size_t>(above - edges.begin()) - 1;
}

/// One attempt with given edges.
class Attempt {
 public:
  Attempt(const ExactSolution& solution, const ForceFit& fit, ForcePieces& pieces)
      : solution_(solution), fit_(fit), pieces_(pieces) {}

  /// Whether all pieces are good; where one is not, an interval of its is marked to be halved.
  bool succeeds() {
    halve_radius_.assign(pieces_.rings(), false), halve_time_.assign(pieces_.slabs(), false);
    pieces_.pieces.clear();
    pieces_.error = 0;
    bool good = true;
    for (std::size_t slab = 0; slab < pieces_.slabs(); ++slab)
      for (std::size_t ring = 0; ring < pieces_.rings(); ++ring) good = fits(slab, ring) && good;
    return good;
  }

  void halve() {
    halve_in(pieces_.radii, halve_radius_);
    halve_in(pieces_.times, halve_time_);
  }

 private:
  bool fits(std::size_t slab, std::size_t ring) {
    const Interval R{pieces_.radii[ring], pieces_.radii[ring + 1]}, t{pieces_.times[slab], pieces_.times[slab + 1]};
    const ForceValues table =
        force_values(solution_, fit_, chebyshev::nodes(R, force_nodes), chebyshev::nodes(t, force_nodes));
    const double least = fit_.tolerance * pieces_.largest;
    std::array<double, 2> tail{};
    auto& piece = pieces_.pieces.emplace_back();
    for (std::size_t c = 0; c < 2; ++c) {
      const ForceMatrix coefficients = chebyshev_coefficients(table[c]);
      piece[c] = separated(coefficients, least);
      const auto of_component = tails(coefficients);
      for (std::size_t d = 0; d < 2; ++d) tail[d] = std::max(tail[d], of_component[d]);
    }
    const double error = difference(slab, ring, R, t);
    pieces_.error = std::max(pieces_.error, error);
    if (error <= fit_.tolerance) return true;
    if (tail[0] >= tail[1]) halve_radius_[ring] = true;
    if (tail[1] >= tail[0]) halve_time_[slab] = true;
    return false;
  }

  double difference(std::size_t slab, std::size_t ring, const Interval& R, const Interval& t) const {
    std::vector<double> radii, times;
    for (const double at : chebyshev::gauss_nodes(checks)) {
      radii.push_back(R.lower + at * R.width());
      times.push_back(t.lower + at * t.width());
    }
    const ForceValues exact = force_values(solution_, fit_, radii, times);
    double largest = 0;
    for (std::size_t c = 0; c < 2; ++c)
      for (std::size_t i = 0; i < radii.size(); ++i)
        for (std::size_t k = 0; k < times.size(); ++k) {
          const double found = value_of(pieces_.piece(slab, ring)[c], from_minus_1_to_1(pieces_.radii, ring, radii[i]),
                                        from_minus_1_to_1(pieces_.times, slab, times[k]));
          largest =
              std::max(largest, std::abs(found - exact[c](static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k))));
        }
    return largest / pieces_.largest;
  }

  static void halve_in(std::vector<double>& edges, const std::vector<bool>& which) {
    std::vector<double> finer{edges.front()};
    for (std::size_t k = 0; k < which.size(); ++k) {
      if (which[k]) finer.push_back(0.5 * (edges[k] + edges[k + 1]));
      finer.push_back(edges[k + 1]);
    }
    edges = finer;
  }

  const ExactSolution& solution_;
  const ForceFit& fit_;
  ForcePieces& pieces_;
  std::vector<bool> halve_radius_, halve_time_;
};

/// The largest |b| of the pieces' nodes.
double largest_force(const ExactSolution& solution, const ForceFit& fit, const ForcePieces& pieces) {
  double largest = 0;
  for (std::size_t k = 0; k < pieces.slabs(); ++k) {
    const ForceValues table =
        force_values(solution, fit, chebyshev::nodes({pieces.radii.front(), pieces.radii.back()}, 4 * force_nodes),
                     chebyshev::nodes({pieces.times[k], pieces.times[k + 1]}, 2 * force_nodes));
    largest = std::max(largest, (table[0].array().square() + table[1].array().square()).maxCoeff());
  }
  return std::sqrt(largest);
}

}  // namespace

std::size_t ForcePieces::numbers() const {
  std::size_t count = 0;
  for (const auto& piece : pieces)
    for (const ForceSeries& series : piece)
      for (const ForceTerm& term : series) count += term.P.size() + term.Q.size();
  return count;
}

Polar ForcePieces::at(double R, double t) const {
  if (R < radii.front() || R > radii.back()) return {0, 0};
  t = std::clamp(t, times.front(), times.back());
  const std::size_t ring = interval_of(radii, R), slab = interval_of(times, t);
  const double s = from_minus_1_to_1(radii, ring, R), u = from_minus_1_to_1(times, slab, t);
  return {value_of(piece(slab, ring)[0], s, u), value_of(piece(slab, ring)[1], s, u)};
}

ForcePieces fit_force(const ExactSolution& solution, const ForceFit& fit) {
  const Vortex& vortex = *solution.motion().as<Vortex>();
  ForcePieces pieces;
  pieces.vortex = vortex, pieces.quasi_static = fit.quasi_static, pieces.tolerance = fit.tolerance;
  const auto begin = [&](bool at_reversals) {
    pieces.radii = {vortex.inner, vortex.outer};
    pieces.times = {0};
    if (at_reversals)
      for (const double t : vortex.amplitude.reversals(fit.end)) pieces.times.push_back(t);
    pieces.times.push_back(fit.end);
  };
  begin(true);
  pieces.largest = largest_force(solution, fit, pieces);
  if (!(pieces.largest > 0))
    throw InputError({}, fit.asked_by, "the body force is zero at all times: nothing is to be written");
  Attempt attempt(solution, fit, pieces);
  begin(false);  // where the load turns, only a material with a memory has a kink
  if (pieces.vortex.amplitude.type != Amplitude::Type::ramp && attempt.succeeds()) return pieces;
  begin(true);
  for (bool good = false; !good;) {
    if (pieces.rings() * pieces.slabs() > fit.most_pieces)
      throw InputError({}, fit.asked_by,
                       "the body force has kinks or is too steep: more than " + std::to_string(fit.most_pieces) +
                           " pieces of degree " + std::to_string(force_degree) +
                           " are needed for a relative error of " + rounded_text(fit.tolerance, 2) +
                           "; export --to csv writes it as a table instead");
    good = attempt.succeeds();
    if (!good) attempt.halve();
  }
  return pieces;
}

std::string fault_of_pieces(const Scene& scene) {
  if (!scene.motion.as<Vortex>())
    return "the expressions are those of the plane vortex, motion.type: vortex. For other motions use --to csv";
  if (scene.frame) return "the expressions are those of a frame at rest, without frame";
  return {};
}

}  // namespace assay::drivers
