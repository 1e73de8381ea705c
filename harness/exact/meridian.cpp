// SPDX-License-Identifier: BSD-3-Clause
// The exact solution of the vortex in three dimensions. One sheet serves all points: a point has its own xi.
#include "harness/exact/meridian.hpp"

#include <algorithm>
#include <cmath>

#include "harness/exact/exact_fields.hpp"
#include "harness/exact/polar.hpp"
#include "harness/numeric/gauss.hpp"

namespace assay {

MeridianResponse meridian_response(const ResponseAtTime& response, double xi, double first_front) {
  constexpr double near_rest = 0.01;  // a mean over so little is exact to rounding
  MeridianResponse found;
  Tensor tau;
  response.at(xi, tau, found.dtau_dxi);
  if (xi > near_rest || xi >= first_front) {
    found.tau_by_xi = tau / xi;
    return found;
  }
  for (const GaussPoint& point : gauss_rule<3>()) {
    Tensor slope;
    response.at(0.5 * (1 + point.at) * xi, tau, slope);
    found.tau_by_xi += 0.5 * point.weight * slope;
  }
  return found;
}

Vector3 divergence_piola(const MeridianPoint& p, double g, const MeridianResponse& given) {
  const auto [tau, slope] = balanced({.xi = p.xi}, g, p.xi * given.tau_by_xi, given.dtau_dxi);
  const Tensor by_xi = p.xi > 0 ? Tensor(tau / p.xi) : given.tau_by_xi;
  const MeridianProfile& h = p.profile;
  const double c = p.c, s = p.s, h_R = p.R * h.h_R_by_R, beta = g * p.G;
  const double H_NN = c * c * h.h_RR + 2 * c * s * h.h_RZ + s * s * h.h_ZZ;
  const double H_MM = s * s * h.h_RR - 2 * c * s * h.h_RZ + c * c * h.h_ZZ;
  const double H_NM = c * s * (h.h_ZZ - h.h_RR) + (c * c - s * s) * h.h_RZ;
  const double xi_N = 0.5 * (h_R + p.R * H_NN), xi_M = 0.5 * (p.R * H_NM - h.h_Z);
  const double along_M = 0.5 * p.R * H_MM, along_N = 0.5 * p.R * H_NM;  // xi phi_M, xi phi_N
  const double turned = beta * p.xi;
  const double t11 = by_xi(0, 0), t22 = by_xi(1, 1), t33 = by_xi(2, 2), t12 = by_xi(0, 1), t21 = by_xi(1, 0);
  return {slope(0, 0) * xi_N + (t11 - t33) * along_M + 0.5 * (t11 - t22) * h_R - turned * t21 * c,
          slope(1, 0) * xi_N + t21 * along_M + 0.5 * (t12 + t21) * h_R + turned * t11 * c,
          slope(2, 2) * xi_M + (t11 - t33) * along_N + 0.5 * (t22 - t33) * h.h_Z + turned * t21 * s};
}

namespace {

class MeridianSlice final : public ExactSlice {
 public:
  MeridianSlice(const Vortex3d& motion, double density, const Response* response, double t)
      : motion_(motion), density_(density), g_(motion.amplitude.at(t)) {
    for (const Revolution& vortex : motion.all()) has_edge_ |= !vortex.has_smooth_edge();
    if (!response) return;
    response_ = response->at_time(t);
    fronts_ = response_->fronts();
    if (!fronts_.empty()) first_front_ = fronts_.front();
  }

  ExactPoint at(const Vector3& X) const override {
    const auto p = motion_.place(X);
    if (!p) return {at_rest(X), {}};
    ExactPoint found{state_of(*p, g_), {}};
    ExactStress& stress = found.stress;
    MeridianResponse response;
    if (response_) response = meridian_response(*response_, p->xi, first_front_);
    const Tensor B = p->axes(), QB = p->rotation(g_.value * p->profile.h) * B;
    stress.first_piola_kirchhoff = QB * (p->xi * response.tau_by_xi) * B.transpose();
    stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, found.state.F);
    stress.static_force = -(QB * divergence_piola(*p, g_.value, response)) / density_;
    stress.body_force = found.state.a + stress.static_force;
    return found;
  }

  Tensor first_piola_kirchhoff(const Vector3& X) const override {
    const auto p = motion_.place(X);
    if (!p || !response_) return Tensor::Zero();
    Tensor tau, slope;
    response_->at(p->xi, tau, slope);
    const Tensor B = p->axes();
    return p->rotation(g_.value * p->profile.h) * B * tau * B.transpose();
  }

  ExactState state(const Vector3& X) const override {
    const auto p = motion_.place(X);
    return p ? state_of(*p, g_) : at_rest(X);
  }

  bool has_parts() const override { return has_edge_ || !fronts_.empty(); }
  std::size_t part(const Vector3& X) const override {
    const auto p = motion_.place(X);
    const double xi = p ? p->xi : 0;
    const auto fronts =
        static_cast<std::size_t>(std::lower_bound(fronts_.begin(), fronts_.end(), xi) - fronts_.begin());
    return has_edge_ && p ? fronts + (fronts_.size() + 1) * (p->vortex + 1) : fronts;
  }

 private:
  static ExactState at_rest(const Vector3& X) {
    ExactState state;
    state.x = X;
    return state;
  }

  const Vortex3d& motion_;
  double density_;
  AmplitudeValue g_;
  std::shared_ptr<const ResponseAtTime> response_;
  std::vector<double> fronts_;  ///< xi
  double first_front_ = HUGE_VAL;
  bool has_edge_ = false;  ///< where b is not smooth
};

class MeridianSolution final : public ExactSolution {
 public:
  MeridianSolution(const Vortex3d& motion, double density, std::shared_ptr<const Response> response)
      : ExactSolution(motion, density), vortex_(motion), response_(std::move(response)) {}

  std::vector<ExactPoint> at(std::span<const PlaceAndTime> points, const Between& between) const override {
    std::vector<ExactPoint> found;
    std::unique_ptr<const ExactSlice> now;
    double t = 0;
    for (const PlaceAndTime& point : points) {
      if (between) between(static_cast<double>(found.size()) / static_cast<double>(points.size()), "points");
      if (!now || point.t != t) now = slice(t = point.t);
      found.push_back(now->at(point.X));
    }
    return found;
  }

  std::unique_ptr<const ExactSlice> slice(double t) const override {
    return std::make_unique<MeridianSlice>(vortex_, density_, response_.get(), t);
  }

  std::unique_ptr<ExactInstant> instant(const ExactPoints&, const Asked&) const override {
    throw std::logic_error("an instant is plane, and vortex3d is not");
  }
  const Response* response() const override { return response_.get(); }

 private:
  Vortex3d vortex_;
  std::shared_ptr<const Response> response_;
};

}  // namespace

ExactSolutionPtr exact_meridian(const Vortex3d& motion, double density, std::shared_ptr<const Response> response) {
  return std::make_shared<const MeridianSolution>(motion, density, std::move(response));
}

}  // namespace assay
