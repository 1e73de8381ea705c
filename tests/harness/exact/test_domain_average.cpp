// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/polar_average.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/gauss.hpp"
#include "tests/harness/exact/made_up_curve.hpp"
#include "tests/harness/exact/vortex_force.hpp"

namespace assay::test_domain_average {
namespace {

constexpr double density = 1000;
constexpr Annulus ring{0.75, 1.25};

using MadeUpResponse = std::function<MadeUpCurve(double t)>;

/// A response made up so that nothing cancels: neither symmetric nor zero at xi = 0 where `pressure` is not, with a
/// kink of the given strength where |xi| = front.
struct MadeUp {
  double pressure = 0, kink = 0, front = 0.4;

  void at(double xi, double t, Tensor& tau, Tensor& dtau) const {
    tau.setZero(), dtau.setZero();
    tau(0, 0) = pressure + 300 * std::sin(2 * xi + t) - 300 * std::sin(t), dtau(0, 0) = 600 * std::cos(2 * xi + t);
    tau(0, 1) = 500 * xi * (1 + 0.2 * xi), dtau(0, 1) = 500 * (1 + 0.4 * xi);
    tau(1, 0) = 700 * xi - 100 * xi * xi * xi, dtau(1, 0) = 700 - 300 * xi * xi;
    tau(1, 1) = pressure + 200 * (std::exp(0.3 * xi) - 1), dtau(1, 1) = 60 * std::exp(0.3 * xi);
    if (std::abs(xi) <= front) return;
    const double side = xi < 0 ? -1 : 1;
    for (const auto& [i, j, k] : {std::tuple{0, 0, 1.0}, {0, 1, -2.0}, {1, 0, 1.5}}) {
      tau(i, j) += kink * k * (xi - side * front);
      dtau(i, j) += kink * k;
    }
  }

  MadeUpResponse response(bool tells_fronts) const {
    return [this, tells_fronts](double t) {
      const auto tau = [this, t](double xi) {
        Tensor value, slope;
        at(xi, t, value, slope);
        return value;
      };
      return MadeUpCurve(tau, tells_fronts ? std::vector<double>{-front, front} : std::vector<double>{});
    };
  }
};

/// Pointwise b in E_x, E_y.
Point pointwise(const Vortex& vortex, const MadeUp& model, double t, const Point& X) {
  const double R = std::hypot(X[0], X[1]);
  const RingProfile profile = vortex.profile(R);
  Tensor tau, dtau;
  model.at(profile.xi, t, tau, dtau);
  const Polar b = body_force(vortex, density, R, t, tau, dtau);
  const double theta = std::atan2(X[1], X[0]) + vortex.amplitude.at(t).value * profile.h;
  return {std::cos(theta) * b.r - std::sin(theta) * b.theta, std::sin(theta) * b.r + std::cos(theta) * b.theta};
}

/// T.N per length for an edge in direction d, by (20).
Point traction(const Vortex& vortex, const MadeUp& model, double t, const Point& X, const Point& normal) {
  const double R = std::hypot(X[0], X[1]);
  if (R < ring.inner || R > ring.outer) return {};
  Tensor tau, dtau;
  model.at(vortex.profile(R).xi, t, tau, dtau);
  const Vector3 T_N = rotated_to(vortex, {X[0], X[1], 0}, t, tau) * Vector3(normal[0], normal[1], 0);
  return {T_N.x(), T_N.y()};
}

/// Mean of pointwise b over a cell of the first quadrant, zero outside the ring: in polar coordinates, where every arc
/// of the cell has its angles. Radii are split where the integrand kinks.
Point brute_force(const Vortex& vortex, const MadeUp& model, double t, const Rectangle& r, std::vector<double> cuts) {
  const double low = std::max(ring.inner, std::hypot(r.lower[0], r.lower[1]));
  const double high = std::min(ring.outer, std::hypot(r.upper[0], r.upper[1]));
  cuts.insert(cuts.end(), {low, high, std::hypot(r.lower[0], r.upper[1]), std::hypot(r.upper[0], r.lower[1])});
  std::sort(cuts.begin(), cuts.end());
  Point sum{};
  constexpr int panels = 20;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double from = std::max(cuts[k], low), width = (std::min(cuts[k + 1], high) - from) / panels;
    for (int panel = 0; width > 0 && panel < panels; ++panel) {
      for (const GaussPoint& radial : gauss_rule<8>()) {
        const double R = from + width * (panel + 0.5 * (1 + radial.at));
        const double first = std::max(std::acos(std::min(1.0, r.upper[0] / R)), std::asin(r.lower[1] / R));
        const double last = std::min(std::acos(r.lower[0] / R), std::asin(std::min(1.0, r.upper[1] / R)));
        for (const GaussPoint& along : gauss_rule<8>()) {
          const double angle = first + 0.5 * (1 + along.at) * (last - first);
          const Point b = pointwise(vortex, model, t, {R * std::cos(angle), R * std::sin(angle)});
          const double w = 0.25 * radial.weight * along.weight * width * (last - first) * R;
          for (std::size_t d = 0; d < 2; ++d) sum[d] += w * b[d];
        }
      }
    }
  }
  for (double& s : sum) s /= r.area();
  return sum;
}

/// The same for a cell inside the ring and a smooth response.
Point plain_brute_force(const Vortex& vortex, const MadeUp& model, double t, const Rectangle& r) {
  Point sum{};
  constexpr int panels = 2;
  for (int k = 0; k < panels * panels; ++k) {
    for (const GaussPoint& p : gauss_rule<8>()) {
      for (const GaussPoint& q : gauss_rule<8>()) {
        const Point s{(k % panels + 0.5 * (1 + p.at)) / panels, (k / panels + 0.5 * (1 + q.at)) / panels};
        const Point b =
            pointwise(vortex, model, t,
                      {r.lower[0] + s[0] * (r.upper[0] - r.lower[0]), r.lower[1] + s[1] * (r.upper[1] - r.lower[1])});
        for (std::size_t d = 0; d < 2; ++d) sum[d] += 0.25 * p.weight * q.weight * b[d] / (panels * panels);
      }
    }
  }
  return sum;
}

/// Without any split: two Gauss points a whole edge, T = 0 outside the ring. The inertia is taken from `averaged`.
Point unsplit(const Vortex& vortex, const MadeUp& model, double t, const Rectangle& r, const Point& averaged_inertia) {
  Point flux{};
  for (const std::size_t along : {std::size_t{0}, std::size_t{1}}) {
    for (const int side : {-1, 1}) {
      const double length = r.upper[along] - r.lower[along];
      for (const GaussPoint& p : gauss_rule<2>()) {
        Point X{}, normal{};
        X[along] = r.lower[along] + 0.5 * (1 + p.at) * length;
        X[1 - along] = side < 0 ? r.lower[1 - along] : r.upper[1 - along];
        normal[1 - along] = side;
        const Point f = traction(vortex, model, t, X, normal);
        for (std::size_t d = 0; d < 2; ++d) flux[d] += 0.5 * p.weight * length * f[d];
      }
    }
  }
  return {averaged_inertia[0] - flux[0] / (density * r.area()), averaged_inertia[1] - flux[1] / (density * r.area())};
}

const std::span<const GaussPoint> two_points = gauss_rule<2>(), eight_points = gauss_rule<8>();

std::vector<Point> averages(const Vortex& vortex, const MadeUpResponse& response, double t,
                            const ReferenceDomains& domains, std::span<const GaussPoint> rule = two_points) {
  PolarAverage average(vortex, density, domains, rule);
  std::vector<double> x(domains.places.size()), y(x.size());
  average.evaluate(response(t), t, x, y);
  std::vector<Point> b;
  for (std::size_t p = 0; p < x.size(); ++p) b.push_back({x[p], y[p]});
  return b;
}

std::vector<Rectangle> quadrant(int across) {  // cells of side 1.25 / across
  std::vector<Rectangle> cells;
  const double h = 1.25 / across;
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < across; ++i) cells.push_back({{i * h, j * h}, {(i + 1) * h, (j + 1) * h}});
  }
  return cells;
}

bool crossed(const Rectangle& r, double R) {
  return std::hypot(r.lower[0], r.lower[1]) < R && std::hypot(r.upper[0], r.upper[1]) > R;
}
bool straddles(const Rectangle& r) { return crossed(r, ring.inner) || crossed(r, ring.outer); }
bool inside(const Rectangle& r) {
  return std::hypot(r.lower[0], r.lower[1]) >= ring.inner && std::hypot(r.upper[0], r.upper[1]) <= ring.outer;
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }
double size(const Point& a) { return std::hypot(a[0], a[1]); }

Vortex paper_vortex() {
  Vortex vortex;
  vortex.amplitude.peak = 1;
  return vortex;
}

TEST(DomainAverage, IsTheMeanOfPointwiseForceInsideTheRing) {
  const Vortex vortex = paper_vortex();
  const MadeUp model{.pressure = 50};
  for (const double t : {0.0, 0.3, 0.7}) {
    const std::vector<Rectangle> cells = quadrant(25);
    const auto b = averages(vortex, model.response(false), t, domains_of(cells, ring, false), eight_points);
    int tested = 0;
    for (std::size_t p = 0; p < cells.size(); p += 3) {
      if (!inside(cells[p])) continue;
      const Point brute = plain_brute_force(vortex, model, t, cells[p]);
      EXPECT_LE(distance(b[p], brute), 1e-8 * size(brute)) << cells[p].lower[0] << " " << cells[p].lower[1];
      ++tested;
    }
    EXPECT_GT(tested, 40);
  }
}

/// Largest error of b over the cells that `chosen` picks, with so many cells across the quadrant [m/s^2].
template <class Chosen>
double largest_error(const Vortex& vortex, const MadeUp& model, int across, bool fronts, const Chosen& chosen,
                     const std::vector<double>& cuts, std::span<const GaussPoint> rule = two_points) {
  const double t = 0.3;
  const std::vector<Rectangle> cells = quadrant(across);
  const auto b = averages(vortex, model.response(fronts), t, domains_of(cells, ring, false), rule);
  double worst = 0;
  for (std::size_t p = 0; p < cells.size(); ++p) {
    if (!chosen(cells[p])) continue;
    const bool plain = inside(cells[p]) && cuts.empty();
    const Point brute =
        plain ? plain_brute_force(vortex, model, t, cells[p]) : brute_force(vortex, model, t, cells[p], cuts);
    worst = std::max(worst, distance(b[p], brute));
  }
  return worst;
}

TEST(DomainAverage, TwoGaussPointsAnEdgeAreOfFourthOrder) {
  const Vortex vortex = paper_vortex();
  const auto error = [&](int across) { return largest_error(vortex, {}, across, false, inside, {}); };
  const double coarse = error(50), fine = error(100);
  EXPECT_GT(coarse / fine, 10);
  EXPECT_LT(coarse, 0.3);  // of some 100 m/s^2
}

TEST(DomainAverage, TheAccelerationIsNotWhatLimitsIt) {
  const Vortex vortex = paper_vortex();
  const MadeUpResponse nothing = [](double) { return MadeUpCurve([](double) { return Tensor::Zero(); }); };
  const double t = 0.35;
  for (const int across : {10, 25, 50}) {
    const std::vector<Rectangle> cells = quadrant(across);
    const auto b = averages(vortex, nothing, t, domains_of(cells, ring, false));
    double worst = 0, largest = 0;
    for (std::size_t p = 0; p < cells.size(); ++p) {
      if (!inside(cells[p]) && !straddles(cells[p])) continue;
      Point sum{};
      for_each_area_point(common_boundary(cells[p], ring), [&](const Point& X, double w) {
        const Vector3 a = vortex.at({X[0], X[1], 0}, t).a;
        sum[0] += w * a.x() / cells[p].area(), sum[1] += w * a.y() / cells[p].area();
      });
      worst = std::max(worst, distance(b[p], sum));
      largest = std::max(largest, size(sum));
    }
    EXPECT_LT(worst, 1e-6 * largest) << across;
  }
}

TEST(DomainAverage, EdgesSplitAtTheRingConvergeAndUnsplitOnesDoNot) {
  const Vortex vortex = paper_vortex();
  const MadeUp model;
  std::vector<double> split, plain;
  for (const int across : {50, 100}) {
    split.push_back(largest_error(vortex, model, across, false, straddles, {}));
    double worst = 0;
    for (const Rectangle& cell : quadrant(across)) {
      if (!straddles(cell)) continue;
      Point inertia{};
      for_each_area_point(common_boundary(cell, ring), [&](const Point& X, double w) {
        const Vector3 a = vortex.at({X[0], X[1], 0}, 0.3).a;
        inertia[0] += w * a.x() / cell.area(), inertia[1] += w * a.y() / cell.area();
      });
      const Point whole = unsplit(vortex, model, 0.3, cell, inertia);
      worst = std::max(worst, distance(whole, brute_force(vortex, model, 0.3, cell, {})));
    }
    plain.push_back(worst);
  }
  EXPECT_GT(split[0] / split[1], 5);
  EXPECT_LT(plain[0] / plain[1], 1.5);  // negative control
  EXPECT_GT(plain[1], 50 * split[1]);
}

TEST(LongDomainAverage, EdgesSplitAtFrontsConvergeAndUnsplitOnesDoNot) {
  const Vortex vortex = paper_vortex();
  const MadeUp model{.kink = 2000};
  const RadiiOfXi radii_of_xi(vortex);
  std::vector<double> radii = radii_of_xi(model.front);
  for (const double R : radii_of_xi(-model.front)) radii.push_back(R);
  ASSERT_EQ(radii.size(), 4u);
  for (const double R : radii) EXPECT_NEAR(std::abs(vortex.profile(R).xi), model.front, 1e-12);
  const auto at_front = [&](const Rectangle& r) {
    return inside(r) && std::any_of(radii.begin(), radii.end(), [&](double R) { return crossed(r, R); });
  };
  const auto error = [&](int across, bool fronts, std::span<const GaussPoint> rule) {
    return largest_error(vortex, model, across, fronts, at_front, radii, rule);
  };
  EXPECT_LT(error(25, true, eight_points), 1e-5);  // b of some 100 m/s^2
  EXPECT_GT(error(50, true, two_points) / error(100, true, two_points), 5);
  EXPECT_LT(error(50, false, two_points) / error(100, false, two_points), 1.2);  // negative control
  EXPECT_GT(error(25, false, eight_points), 0.1);
}

// In a ramp that is held nothing accelerates: what is left telescopes to the tractions of the outer boundary.
TEST(DomainAverage, TheForcesOfAQuarterRingAddUpToTheTractionsOnItsBoundary) {
  Vortex vortex;
  vortex.amplitude = {Amplitude::Type::ramp, 0.8, 1};
  const MadeUp model{.pressure = 80, .kink = 2000};
  const double t = 1.5;
  for (const bool clipped : {true, false}) {
    const std::vector<Rectangle> cells = quadrant(25);
    const ReferenceDomains domains = domains_of(cells, ring, clipped);
    const auto b = averages(vortex, model.response(false), t, domains);
    Point total{}, expected{};
    double scale = 0;
    for (std::size_t p = 0; p < cells.size(); ++p) {
      const auto& shape = domains.shapes[domains.places[p].shape];
      if (shape.boundary.empty()) continue;
      for (std::size_t d = 0; d < 2; ++d) total[d] += density * shape.volume * b[p][d];
      scale += density * shape.volume * size(b[p]);
    }
    const auto add = [&](const Point& X, const Point& normal, double weight) {
      const Point f = traction(vortex, model, t, X, normal);
      for (std::size_t d = 0; d < 2; ++d) expected[d] -= weight * f[d];
    };
    const double h = 0.05;
    for (int i = 15; i < 25; ++i) {  // the two straight faces, by the same two points an edge
      for (const GaussPoint& p : gauss_rule<2>()) {
        const double R = h * (i + 0.5 * (1 + p.at));
        add({R, 0}, {0, -1}, 0.5 * h * p.weight);
        add({0, R}, {-1, 0}, 0.5 * h * p.weight);
      }
    }
    for (const double R : {ring.inner, ring.outer}) {
      for (const GaussPoint& p : gauss_rule<8>()) {
        const double angle = 0.25 * std::numbers::pi * (1 + p.at), sign = R == ring.outer ? 1 : -1;
        const Point e{std::cos(angle), std::sin(angle)};
        if (clipped) add({R * e[0], R * e[1]}, {sign * e[0], sign * e[1]}, 0.25 * std::numbers::pi * R * p.weight);
      }
    }
    for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(total[d], expected[d], 1e-12 * scale) << clipped;
    EXPECT_GT(size(expected), 1e-3 * scale);
  }
}

// The force at a point is not the torque over a domain: the sum over particles converges at second order.
TEST(DomainAverage, TheTorqueOfTheClippedRingConvergesToTheRateOfAngularMomentum) {
  const Vortex vortex = paper_vortex();
  const double t = 0.3;
  double exact = 0;  // integral of rho R^2 g'' h dA; the boundary bears no shear
  const int panels = 50;
  for (int k = 0; k < panels; ++k) {
    for (const GaussPoint& p : gauss_rule<8>()) {
      const double R = 0.75 + 0.5 * (k + 0.5 * (1 + p.at)) / panels;
      exact += 0.25 / panels * p.weight * 2 * std::numbers::pi * density * std::pow(R, 3) *
               vortex.amplitude.at(t).acceleration * vortex.profile(R).h;
    }
  }
  // angular momentum balances only for a symmetric Kirchhoff stress tau F^T
  const MadeUpResponse symmetric = [&](double time) {
    return MadeUpCurve([g = vortex.amplitude.at(time).value](double xi) {
      const double gamma = 2 * g * xi;
      const double s11 = -90 * gamma * gamma, s12 = 400 * gamma, s22 = 120 * gamma * gamma;
      Tensor tau = Tensor::Zero();  // sigma F^-T with F^-T = [[1, -gamma], [0, 1]]
      tau(0, 0) = s11, tau(0, 1) = s12 - gamma * s11;
      tau(1, 0) = s12, tau(1, 1) = s22 - gamma * s12;
      return tau;
    });
  };
  const auto error = [&](int across) {
    const std::vector<Rectangle> cells = quadrant(across);
    const ReferenceDomains domains = domains_of(cells, ring, true);
    const auto b = averages(vortex, symmetric, t, domains);
    double torque = 0;
    for (std::size_t p = 0; p < cells.size(); ++p) {
      const auto& shape = domains.shapes[domains.places[p].shape];
      if (!(shape.volume > 0)) continue;
      const Point X = moments_of(shape.boundary).centroid;
      const Vector3 x = vortex.at({X[0], X[1], 0}, t).x;
      torque += 4 * density * shape.volume * (x.x() * b[p][1] - x.y() * b[p][0]);
    }
    return std::abs(torque - exact) / std::abs(exact);
  };
  EXPECT_GT(error(25) / error(50), 3);
  EXPECT_LT(error(50), 2e-2);
}

TEST(DomainAverage, IsTheSameForSectorsAsForTheClippedPartsOfTheirRing) {
  const Vortex vortex = paper_vortex();
  const MadeUp model{.pressure = 30};
  const double t = 0.4;
  // one sector a quadrant from edge to edge is the quadrant of the ring, and so is one clipped cell
  const std::vector<Sector> sectors{{0.75, 1.25, -std::numbers::pi / 4, std::numbers::pi / 4}};
  const auto polar = averages(vortex, model.response(false), t, domains_of(sectors, std::vector<int>{4}), eight_points);
  const auto clipped = averages(vortex, model.response(false), t,
                                domains_of(std::vector<Rectangle>{{{0, 0}, {1.3, 1.3}}}, ring, true), eight_points);
  ASSERT_EQ(polar.size(), 4u);
  EXPECT_LT(distance(polar[0], clipped[0]), 1e-9 * size(clipped[0]));
  EXPECT_EQ(polar[1][0], -polar[0][1]);
  EXPECT_EQ(polar[1][1], polar[0][0]);
}

TEST(DomainAverage, IntegratesAnEdgeOnceAndAsksForARadiusOnce) {
  std::vector<Rectangle> cells;
  for (int j = -20; j < 20; ++j) {
    for (int i = -20; i < 20; ++i) cells.push_back({{i / 16.0, j / 16.0}, {(i + 1) / 16.0, (j + 1) / 16.0}});
  }
  const Vortex vortex = paper_vortex();
  const PolarAverage average(vortex, density, domains_of(cells, ring, false));
  std::size_t in_ring = 0;
  for (const Rectangle& r : cells) in_ring += r.lower[0] >= 0 && r.lower[1] >= 0 && (inside(r) || straddles(r));
  EXPECT_LT(average.edges(), 2.4 * static_cast<double>(in_ring));          // of four a cell
  EXPECT_LT(average.radii(), 1.1 * static_cast<double>(average.edges()));  // two a edge, shared with the mirror image
}

}  // namespace
}  // namespace assay::test_domain_average
