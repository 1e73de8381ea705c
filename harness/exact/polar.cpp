// SPDX-License-Identifier: BSD-3-Clause
// The exact solution of a polar motion. What depends on R alone is computed once for each distinct radius.
//
// Points move as x = E_R rho exp(i alpha) in the complex plane, so that
//   a = X f,  f = exp(i alpha) z / R,  z = a_r + i a_theta = rho (i alpha.. - alpha.^2) + rho.. + 2 i rho. alpha.
//   da = dX f + X f' dR,  R f' = exp(i alpha) (z' + i alpha' z - z/R)                       [1/s^2]
// of which f = exp(i alpha) (i alpha.. - alpha.^2) is the vortex's (29).
#include "harness/exact/polar.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "harness/exact/places.hpp"
#include "harness/exact/polar_average.hpp"

namespace assay {

BaselineStress balanced(const RingProfile& p, double g, const Tensor& tau, const Tensor& dtau_dxi) {
  constexpr double error_at_most = 1e-5;
  const double gamma = 2 * g * p.xi, gamma_slope = 2 * g;  // sigma12 = tau12 + gamma tau11, sigma21 = tau21
  const double pushed = gamma * tau(0, 0), pushed_slope = gamma * dtau_dxi(0, 0) + gamma_slope * tau(0, 0);
  const double half = 0.5 * (tau(0, 1) + pushed - tau(1, 0));
  const double half_slope = 0.5 * (dtau_dxi(0, 1) + pushed_slope - dtau_dxi(1, 0));
  BaselineStress result{tau, dtau_dxi};
  if (std::abs(half) > error_at_most * tau.cwiseAbs().maxCoeff()) return result;
  if (std::abs(half_slope) > error_at_most * dtau_dxi.cwiseAbs().maxCoeff()) return result;
  result.tau(1, 0) += half;
  result.tau(0, 1) = result.tau(1, 0) - pushed;
  result.dtau_dxi(1, 0) += half_slope;
  result.dtau_dxi(0, 1) = result.dtau_dxi(1, 0) - pushed_slope;
  return result;
}

Polar divergence_piola(const RingProfile& p, double g, double R, const Tensor& given, const Tensor& given_slope) {
  const auto [tau, dtau_dxi] = balanced(p, g, given, given_slope);
  return {p.xi_prime * dtau_dxi(0, 0) - g * p.h_prime * tau(1, 0) + (tau(0, 0) - tau(1, 1)) / R,   // (26)
          p.xi_prime * dtau_dxi(1, 0) + g * p.h_prime * tau(0, 0) + (tau(0, 1) + tau(1, 0)) / R};  // (27)
}

Polar body_force(const RingProfile& p, const AmplitudeValue& g, double density, double R, const Tensor& tau,
                 const Tensor& dtau_dxi) {
  if (p.h == 0 && p.xi_prime == 0) return {};
  const double omega = g.rate * p.h;  // (30)
  const Polar divergence = divergence_piola(p, g.value, R, tau, dtau_dxi);
  return {-R * omega * omega - divergence.r / density,             // (32)
          R * g.acceleration * p.h - divergence.theta / density};  // (33), sign of the inertia term corrected
}

namespace {

/// exp(i alpha) (r + i theta).
Point along_reference(double alpha, const Polar& v) {
  const double c = std::cos(alpha), s = std::sin(alpha);
  return {c * v.r - s * v.theta, s * v.r + c * v.theta};
}

/// The rectangles around the points, or the domains that were given.
ReferenceDomains domains_of(const ExactPoints& points, const Annulus& ring) {
  return points.domains ? *points.domains : domains_of(rectangles_around(points.X, points.Y, points.half), ring, false);
}

class PolarInstant final : public ExactInstant {
 public:
  PolarInstant(const Motion& motion, double density, std::shared_ptr<const Response> response, double rest,
               const ExactPoints& points, const Asked& asked)
      : ExactInstant(points.X, points.Y),
        motion_(motion),
        density_(density),
        response_(std::move(response)),
        asked_(asked) {
    if (points.averages()) {
      const ReferenceDomains domains = domains_of(points, motion_->polar()->ring());
      if (asked.force) average_.emplace(motion_, density, domains, gauss_rule<2>(), rest);
      if (asked.motion) means_.emplace(motion_, domains);
    }
    if (average_ && !asked.motion && !asked.stress && !asked.inertia) return;  // then nothing is at points
    points_ = RingPoints(points.X, points.Y);
    rings_ = RingsInMotion(motion, points_.radius);
    for (const double R : points_.radius) {
      xi_.push_back(ring_parameter(motion_, R).value);
      profile_.push_back(motion_->polar()->profile(R));
    }
    if (asked.motion || asked.stress) ring_.resize(xi_.size());
    if (asked.inertia) inertia_.resize(xi_.size());
    if (asked.force) force_.resize(xi_.size());
  }

  void set_time(double t) override {
    t_ = t;
    rings_.set_time(t);
    for (std::size_t k = 0; k < ring_.size(); ++k) ring_[k] = ring_at(k);
    for (std::size_t k = 0; k < inertia_.size(); ++k) inertia_[k] = inertia_at(k);
    if (means_) means_->set_time(t);
    if (!asked_.stress) return;
    const auto response = response_->at_time(t);
    Tensor tau, slope;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      Ring& ring = ring_[k];
      response->at(xi_[k], tau, slope);
      Tensor B = Tensor::Identity();
      B(0, 0) = ring.B[0], B(1, 0) = ring.B[2], B(1, 1) = ring.B[3];
      ring.sigma = plane_stress(cauchy_stress(tau, B));
      ring.tau = in_plane(tau);
    }
  }

  PlaneState state(std::size_t p) const override {
    const Ring& ring = ring_[points_.ring[p]];
    const Plane q = first_axes(p), r = axes(p);
    const Plane sigma =
        product(product(r, {ring.sigma[0], ring.sigma[1], ring.sigma[2], ring.sigma[3]}), transposed(r));
    return {times_X(ring.x, p),
            times_X(ring.v, p),
            product(product(r, ring.B), transposed(q)),
            {sigma[0], sigma[1], sigma[2], sigma[3], ring.sigma[4]}};
  }
  Point displacement(std::size_t p) const override {
    const Point x = times_X(ring_[points_.ring[p]].x, p);
    return {x[0] - X_[p], x[1] - Y_[p]};
  }
  Point velocity(std::size_t p) const override { return times_X(ring_[points_.ring[p]].v, p); }
  Plane F_rate(std::size_t p) const override {
    return product(product(axes(p), ring_[points_.ring[p]].B_rate), transposed(first_axes(p)));
  }
  Plane first_piola_kirchhoff(std::size_t p) const override {
    return product(product(axes(p), ring_[points_.ring[p]].tau), transposed(first_axes(p)));  // (20)
  }

  PlaneInertia inertia(std::size_t p) const override {
    const std::uint32_t ring = points_.ring[p];
    const auto& [f, slope] = inertia_[ring];
    const double R = points_.radius[ring], c = points_.cos_theta[p], s = points_.sin_theta[p];
    const Point across{slope[0] * c - slope[1] * s, slope[1] * c + slope[0] * s};  // X f' of (c, s)
    return {{R * (f[0] * c - f[1] * s), R * (f[1] * c + f[0] * s)},
            {f[0] + across[0] * c, -f[1] + across[0] * s, f[1] + across[1] * c, f[0] + across[1] * s}};
  }

  void body_force(std::span<double> b_x, std::span<double> b_y, const InPieces& pieces) override {
    const auto response = response_->at_time(t_);
    if (average_) return average_->evaluate(*response, t_, b_x, b_y, pieces);
    const bool widens = motion_->polar()->widens();
    const AmplitudeValue g = motion_->polar()->turn().at(t_);
    Tensor tau, slope;
    for (std::size_t k = 0; k < xi_.size(); ++k) {
      const double R = points_.radius[k];
      response->at(xi_[k], tau, slope);
      // where a ring widens, xi is R
      force_[k] = along_reference(g.value * profile_[k].h,  // (5)
                                  widens ? rings_[k].body_force(density_, R, tau, slope)
                                         : assay::body_force(profile_[k], g, density_, R, tau, slope));
    }
    for (std::size_t i = 0; i < points_.ring.size(); ++i) {
      const Point& b = force_[points_.ring[i]];
      b_x[i] = points_.cos_theta[i] * b[0] - points_.sin_theta[i] * b[1];
      b_y[i] = points_.sin_theta[i] * b[0] + points_.cos_theta[i] * b[1];
    }
  }

  PlaneMean mean(std::size_t p) const override {
    return means_ ? means_->at(p, {X_[p], Y_[p]}) : ExactInstant::mean(p);
  }
  bool moves(std::size_t p) const override {
    return motion_->polar()->widens() || motion_->polar()->ring().holds(points_.radius[points_.ring[p]]);
  }
  double measure(std::size_t p, const Plane& F) const override {
    if (motion_->polar()->widens()) return ExactInstant::measure(p, F);
    return product(product(transposed(axes(p)), F), first_axes(p))[2];
  }

 private:
  /// Of a distinct radius: what its points share, as factors of X and E_z x X, and baseline components.
  struct Ring {
    Point x{}, v{};
    double cos_alpha = 1, sin_alpha = 0;
    Plane B{}, B_rate{};  ///< B_rate: of F_rate = r B_rate q^T
    Plane tau{};
    std::array<double, 5> sigma{};
  };
  /// f and R f' at a distinct radius: along X and E_z x X [1/s^2].
  struct Factor {
    Point f{}, slope{};
  };

  Ring ring_at(std::size_t k) const {
    const double R = points_.radius[k];
    const RingKinematics now = rings_[k];
    Ring ring;
    ring.cos_alpha = std::cos(now.alpha), ring.sin_alpha = std::sin(now.alpha);
    const Tensor B = now.baseline(R);
    const double along = R > 0 ? now.rho_rate / R : now.rho_slope_rate, across = B(1, 1) * now.alpha_rate;
    const double c = ring.cos_alpha, s = ring.sin_alpha;
    ring.x = {B(1, 1) * c, B(1, 1) * s};
    ring.v = {c * along - s * across, s * along + c * across};
    ring.B = in_plane(B);
    ring.B_rate = {now.rho_slope_rate - now.alpha_rate * B(1, 0), -now.alpha_rate * B(1, 1),
                   now.rho_rate * now.alpha_slope + now.rho * now.alpha_slope_rate + now.alpha_rate * B(0, 0), along};
    return ring;
  }

  Factor inertia_at(std::size_t k) const {
    using namespace std::complex_literals;
    const RingKinematics ring = rings_[k];
    const double R = points_.radius[k];
    const Polar a = ring.acceleration(), a_slope = ring.acceleration_slope();
    const std::complex<double> z = a.r + 1i * a.theta, z_slope = a_slope.r + 1i * a_slope.theta;
    const std::complex<double> turn = std::polar(1.0, ring.alpha), f = turn * (R > 0 ? z / R : z_slope);
    const std::complex<double> slope = turn * (z_slope + 1i * ring.alpha_slope * z) - f;
    return {{f.real(), f.imag()}, {slope.real(), slope.imag()}};
  }

  Point times_X(const Point& factor, std::size_t p) const {
    return {factor[0] * X_[p] - factor[1] * Y_[p], factor[1] * X_[p] + factor[0] * Y_[p]};
  }
  Plane first_axes(std::size_t p) const { return rotation(points_.cos_theta[p], points_.sin_theta[p]); }  ///< q
  Plane axes(std::size_t p) const {                                                                       ///< r (17)
    const Ring& ring = ring_[points_.ring[p]];
    return product(rotation(ring.cos_alpha, ring.sin_alpha), first_axes(p));
  }

  Motion motion_;
  double density_;
  std::shared_ptr<const Response> response_;
  Asked asked_;
  double t_ = 0;
  RingPoints points_;
  RingsInMotion rings_;     // at each distinct radius
  std::vector<double> xi_;  // the baseline's parameter there
  std::vector<RingProfile> profile_;
  std::vector<Ring> ring_;
  std::vector<Factor> inertia_;
  std::vector<Point> force_;  // along E_R, E_Theta
  std::optional<PolarAverage> average_;
  std::optional<PolarMeans> means_;
};

class PolarSolution final : public ExactSolution {
 public:
  PolarSolution(const Motion& motion, double density, std::shared_ptr<const Response> response, double rest)
      : ExactSolution(motion, density), response_(std::move(response)), rest_(rest) {}

  std::unique_ptr<const ExactSlice> slice(double t) const override { return slice_of_ring(*this, density_, t); }
  std::unique_ptr<const ExactPlaces> places(std::vector<Vector3> X) const override {
    return places_of_ring(motion_, std::move(X));
  }
  std::unique_ptr<ExactInstant> instant(const ExactPoints& points, const Asked& asked) const override {
    return std::make_unique<PolarInstant>(motion_, density_, response_, rest_, points, asked);
  }
  bool is_axisymmetric() const override { return true; }
  const Response* response() const override { return response_.get(); }

  /// Of histories that are taken along.
  std::optional<StressSource> source() const override {
    const Shadow* shadow = response_ ? response_->shadow() : nullptr;
    if (!shadow) return std::nullopt;
    return StressSource{shadow->radii(), shadow->error(), "shadow histories", "", shadow->calls()};
  }

 private:
  std::shared_ptr<const Response> response_;
  double rest_;  ///< stress in the plane at rest [Pa]
};

}  // namespace

ExactSolutionPtr exact_polar(const Motion& motion, double density, std::shared_ptr<const Response> response,
                             const Tensor& initial_cauchy) {
  return std::make_shared<const PolarSolution>(motion, density, std::move(response), initial_cauchy(0, 0));
}

}  // namespace assay
