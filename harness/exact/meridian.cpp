// SPDX-License-Identifier: BSD-3-Clause
// The exact solution of the vortex in three dimensions. One sheet serves all points: a point has its own xi.
#include "harness/exact/meridian.hpp"

#include <algorithm>
#include <cmath>

#include "harness/exact/places.hpp"
#include "harness/exact/polar.hpp"
#include "harness/numeric/gauss.hpp"

namespace assay {

MeridianResponse meridian_response(const ResponseAtTime& response, double xi, double first_front) {
  return meridian_responses(response, {&xi, 1}, first_front).front();
}

std::vector<MeridianResponse> meridian_responses(const ResponseAtTime& response, std::span<const double> xi,
                                                 double first_front) {
  constexpr double near_rest = 0.01;  // a mean over so little is exact to rounding
  constexpr unsigned all_nine = (1u << 9) - 1;
  const std::size_t n = xi.size();
  std::vector<MeridianResponse> found(n);
  std::vector<double> tau(9 * n), slopes(9 * n), places;
  std::vector<std::size_t> near;
  response.many(xi, all_nine, tau.data(), slopes.data());
  for (std::size_t i = 0; i < n; ++i) {
    found[i].dtau_dxi = tensor_at(slopes.data(), n, i);
    if (xi[i] > near_rest || xi[i] >= first_front) {
      found[i].tau_by_xi = tensor_at(tau.data(), n, i) / xi[i];
      continue;
    }
    near.push_back(i);
    for (const GaussPoint& point : gauss_rule<3>()) places.push_back(0.5 * (1 + point.at) * xi[i]);
  }
  if (near.empty()) return found;
  tau.resize(9 * places.size()), slopes.resize(9 * places.size());
  response.many(places, all_nine, tau.data(), slopes.data());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const GaussPoint& point = gauss_rule<3>()[k % gauss_rule<3>().size()];
    found[near[k / gauss_rule<3>().size()]].tau_by_xi +=
        0.5 * point.weight * tensor_at(slopes.data(), places.size(), k);
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

ExactState at_rest(const Vector3& X) {
  ExactState state;
  state.x = X;
  return state;
}

class MeridianSlice final : public ExactSlice {
 public:
  MeridianSlice(const Vortex3d& motion, const VortexFinder& finder, double density, const Response* response, double t)
      : finder_(finder), density_(density), g_(motion.amplitude.at(t)) {
    for (const Revolution& vortex : motion.all()) has_edge_ |= !vortex.has_smooth_edge();
    if (!response) return;
    response_ = response->at_time(t);
    fronts_ = response_->fronts();
    if (!fronts_.empty()) first_front_ = fronts_.front();
  }

  ExactPoint at(const Vector3& X) const override {
    const auto p = finder_.place(X);
    if (!p) return {at_rest(X), {}};
    PointFields fields;
    put(*p, response_ ? meridian_response(*response_, p->xi, first_front_) : MeridianResponse(), 0,
        PointFields::views(&fields));
    ExactPoint found = fields.point();
    found.state.F_rate = state_of(*p, g_).F_rate;
    return found;
  }

  void put(const MeridianPoint& p, const MeridianResponse& response, std::size_t point, const FieldViews& out) const {
    const Tensor Q = p.rotation(g_.value * p.profile.h);
    ExactPoint found;
    auto& [state, stress] = found;
    if (out.x || out.v || out.F || out.sigma) state = state_of(p, g_);
    if (out.a || out.b) state.a = acceleration_of(p, g_, Q);
    if (out.any_stress()) {
      const Tensor B = p.axes();
      if (out.P || out.sigma) stress.first_piola_kirchhoff = Q * B * (p.xi * response.tau_by_xi) * B.transpose();
      if (out.sigma) stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, state.F);
      if (out.b || out.static_force) stress.static_force = static_force(p, Q, B, response);
      stress.body_force = state.a + stress.static_force;
    }
    out.put(point, found);
  }

  Vector3 displacement_of(const MeridianPoint& p) const {
    return p.rotation(g_.value * p.profile.h) * p.radial - p.radial;
  }

  /// Of n points that lie in a vortex.
  std::vector<MeridianResponse> responses(std::span<const double> xi) const {
    return response_ ? meridian_responses(*response_, xi, first_front_) : std::vector<MeridianResponse>(xi.size());
  }

  Tensor first_piola_kirchhoff(const Vector3& X) const override {
    const auto p = finder_.place(X);
    if (!p || !response_) return Tensor::Zero();
    Tensor tau, slope;
    response_->at(p->xi, tau, slope);
    const Tensor B = p->axes();
    return p->rotation(g_.value * p->profile.h) * B * tau * B.transpose();
  }

  ExactState state(const Vector3& X) const override {
    const auto p = finder_.place(X);
    return p ? state_of(*p, g_) : at_rest(X);
  }

  /// F = Q M, M = I + g E_Z x X (x) k: F.. = Q.. M + 2 Q. M. + Q M.., Q. = w W Q, Q.. = (w. W + w^2 W^2) Q, w = g. h.
  Tensor acceleration_gradient(const Vector3& X) const override {
    const auto p = finder_.place(X);
    if (!p) return Tensor::Zero();
    const double omega = g_.rate * p->profile.h, omega_rate = g_.acceleration * p->profile.h;  // [rad/s], [rad/s^2]
    Tensor W;
    for (int d = 0; d < 3; ++d) W.col(d) = p->E_Z.cross(Vector3::Unit(d));
    const Tensor Q = p->rotation(g_.value * p->profile.h), shear = p->around() * p->gradient().transpose();
    return (omega_rate * W + omega * omega * W * W) * Q * (Tensor::Identity() + g_.value * shear) +
           2 * omega * g_.rate * W * Q * shear + g_.acceleration * Q * shear;
  }
  bool moves(const Vector3& X) const override { return finder_.place(X).has_value(); }
  double measure(const Vector3& X, const Tensor& F) const override {
    const auto p = finder_.place(X);
    if (!p) return 0;
    const Tensor B = p->axes(), Q = p->rotation(g_.value * p->profile.h);
    return (B.transpose() * Q.transpose() * F * B)(1, 0);
  }

  bool has_parts(Smooth of) const override { return has_edge_ || (of == Smooth::stress && !fronts_.empty()); }
  std::size_t part(const Vector3& X, Smooth of) const override {
    const auto p = finder_.place(X);
    if (of == Smooth::motion) return has_edge_ && p ? p->vortex + 1 : 0;
    const double xi = p ? p->xi : 0;
    const auto fronts =
        static_cast<std::size_t>(std::lower_bound(fronts_.begin(), fronts_.end(), xi) - fronts_.begin());
    return has_edge_ && p ? fronts + (fronts_.size() + 1) * (p->vortex + 1) : fronts;
  }

 private:
  Vector3 static_force(const MeridianPoint& p, const Tensor& Q, const Tensor& B,
                       const MeridianResponse& response) const {
    return -(Q * (B * divergence_piola(p, g_.value, response))) / density_;
  }

  const VortexFinder& finder_;
  double density_;
  AmplitudeValue g_;
  std::shared_ptr<const ResponseAtTime> response_;
  std::vector<double> fronts_;  ///< xi
  double first_front_ = HUGE_VAL;
  bool has_edge_ = false;  ///< where b is not smooth
};

class MeridianPlaces final : public ExactPlaces {
 public:
  MeridianPlaces(const VortexFinder& finder, std::vector<Vector3> X) : ExactPlaces(std::move(X)) {
    place_.reserve(size()), moved_.reserve(size());
    for (std::size_t p = 0; p < size(); ++p) {
      const auto place = finder.place(this->X(p));
      place_.push_back(place ? static_cast<std::uint32_t>(moved_.size()) : nowhere);
      if (place) moved_.push_back(*place);
    }
    std::vector<std::pair<double, std::uint32_t>> by_xi;
    order_.reserve(size());
    for (std::size_t begin = 0; begin < size(); begin += at_once) {  // neighbours in xi are of one range of a sheet
      by_xi.clear();
      for (std::size_t p = begin; p < std::min(begin + at_once, size()); ++p) {
        by_xi.emplace_back(place_[p] == nowhere ? -1 : moved_[place_[p]].xi, static_cast<std::uint32_t>(p));
      }
      std::sort(by_xi.begin(), by_xi.end());
      for (const auto& [xi, p] : by_xi) order_.push_back(p);
    }
  }

  void evaluate(const ExactSlice& slice, std::size_t first, std::size_t count, const FieldViews& out) const override {
    const auto& now = static_cast<const MeridianSlice&>(slice);
    std::vector<double> xi;
    std::vector<std::size_t> points;
    for (std::size_t begin = first / at_once * at_once; begin < first + count; begin += at_once) {
      xi.clear(), points.clear();
      for (std::size_t k = begin; k < std::min(begin + at_once, size()); ++k) {
        const std::uint32_t p = order_[k];
        if (p < first || p >= first + count) continue;
        if (place_[p] == nowhere) {
          out.put(p - first, {at_rest(X(p)), {}});
          continue;
        }
        xi.push_back(moved_[place_[p]].xi), points.push_back(p);
      }
      std::vector<MeridianResponse> responses;
      if (out.any_stress()) responses = now.responses(xi);
      responses.resize(points.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        now.put(moved_[place_[points[i]]], responses[i], points[i] - first, out);
      }
    }
  }

  bool moves(const ExactSlice&, std::size_t point) const override { return place_[point] != nowhere; }
  Vector3 displacement(const ExactSlice& now, std::size_t point) const override {
    if (place_[point] == nowhere) return Vector3::Zero();
    return static_cast<const MeridianSlice&>(now).displacement_of(moved_[place_[point]]);
  }

 private:
  static constexpr std::size_t at_once = 512;
  static constexpr auto nowhere = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> place_;  ///< of each point among those that move
  std::vector<std::uint32_t> order_;  ///< of the points of each piece, by xi
  std::vector<MeridianPoint> moved_;
};

class MeridianSolution final : public ExactSolution {
 public:
  MeridianSolution(const Vortex3d& motion, double density, std::shared_ptr<const Response> response)
      : ExactSolution(motion, density), vortex_(motion), finder_(motion), response_(std::move(response)) {}

  std::unique_ptr<const ExactSlice> slice(double t) const override {
    return std::make_unique<MeridianSlice>(vortex_, finder_, density_, response_.get(), t);
  }
  std::unique_ptr<const ExactPlaces> places(std::vector<Vector3> X) const override {
    return std::make_unique<MeridianPlaces>(finder_, std::move(X));
  }

  std::unique_ptr<ExactInstant> instant(const ExactPoints&, const Asked&) const override {
    throw std::logic_error("an instant is plane, and vortex3d is not");
  }
  const Response* response() const override { return response_.get(); }
  ExactState state(const Vector3& X, double t) const override {
    const auto p = finder_.place(X);
    return p ? state_of(*p, vortex_.amplitude.at(t)) : at_rest(X);
  }

 private:
  Vortex3d vortex_;
  VortexFinder finder_;
  std::shared_ptr<const Response> response_;
};

}  // namespace

ExactSolutionPtr exact_meridian(const Vortex3d& motion, double density, std::shared_ptr<const Response> response) {
  return std::make_shared<const MeridianSolution>(motion, density, std::move(response));
}

}  // namespace assay
