// SPDX-License-Identifier: BSD-3-Clause
// Points of a polar motion at one time. What depends on R alone is computed once for each radius of a piece of some
// hundred points, for all radii at once; a point then turns it by its own angle.
//
// Of a point X = R e(Theta), with alpha the turn at R and t:
//   x = rho e(Theta + alpha) = X (rho/R) exp(i alpha)     in the complex plane; v and a likewise
//   F = r B q^T, P = r tau q^T, sigma = r (tau B^T/J) r^T, b = r (b_r, b_theta, b_z)    r at Theta + alpha, q at Theta
#include <algorithm>
#include <cmath>

#include "harness/exact/places.hpp"
#include "harness/exact/polar.hpp"
#include "harness/exact/polar_radii.hpp"

namespace assay {

namespace {

constexpr std::size_t piece_points = 512;  ///< the columns of their radii stay in the fast caches

/// Components 11, 12, 21, 22 and 31 of tau and its slope, which DIV(T) has.
constexpr unsigned of_force = 1u << 0 | 1u << 1 | 1u << 3 | 1u << 4 | 1u << 6;
constexpr unsigned all_nine = (1u << 9) - 1;

class PolarSlice final : public ExactSlice {
 public:
  PolarSlice(const ExactSolution& solution, double rho0, double time)
      : solution_(solution), density(rho0), t(time), ring_(solution.motion()->polar()->ring()) {
    const PolarMotion& polar = *solution.motion()->polar();
    turn = polar.turn().at(time);
    if (polar.widens()) widening = polar.widening(time);
    if (!solution.response()) return;
    response = solution.response()->at_time(time);
    fronts_ = response->fronts();
  }
  ExactPoint at(const Vector3& X) const override {
    PointFields fields;
    solution_.places({X})->evaluate(*this, 0, 1, PointFields::views(&fields));
    ExactPoint found = fields.point();
    found.state.F_rate = solution_.state(X, t).F_rate;
    return found;
  }
  ExactState state(const Vector3& X) const override { return solution_.state(X, t); }
  double length() const override { return solution_.motion()->length(); }
  bool moves(const Vector3& X) const override {
    return solution_.motion()->polar()->widens() || ring_.holds(std::hypot(X.x(), X.y()));
  }
  double measure(const Vector3& X, const Tensor& F) const override;
  bool has_parts(Smooth) const override { return true; }
  std::size_t part(const Vector3& X, Smooth of) const override {
    const double R = std::hypot(X.x(), X.y());
    if (!ring_.holds(R)) return 0;
    if (of == Smooth::motion) return 1;
    const double xi = ring_parameter(solution_.motion(), R).value;
    return 1 + static_cast<std::size_t>(std::lower_bound(fronts_.begin(), fronts_.end(), xi) - fronts_.begin());
  }

 private:
  const ExactSolution& solution_;

 public:
  double density, t;  ///< rho0 [kg/m^3], [s]
  AmplitudeValue turn, widening;
  std::shared_ptr<const ResponseAtTime> response;  ///< null: the motion alone is known

 private:
  Annulus ring_;
  std::vector<double> fronts_;  ///< xi
};

/// r of the angle whose cosine and sine these are.
Tensor turned_axes(double c, double s) {
  Tensor r;
  r << c, -s, 0, s, c, 0, 0, 0, 1;
  return r;
}

double PolarSlice::measure(const Vector3& X, const Tensor& F) const {
  if (solution_.motion()->polar()->widens()) return F.determinant();
  const double R = std::hypot(X.x(), X.y()), c = R > 0 ? X.x() / R : 1, s = R > 0 ? X.y() / R : 0;
  const double alpha = ring_kinematics(solution_.motion(), R, t).alpha;
  const Tensor q = turned_axes(c, s), r = turned_axes(std::cos(alpha), std::sin(alpha)) * q;
  return (r.transpose() * F * q)(1, 0);  // (17)
}

/// The radii of a piece at one time.
class RadiiNow {
 public:
  RadiiNow(const PolarSlice& now, const FieldViews& out) : now_(now), out_(out) {}

  void set(const RadiusColumns& radii) {
    radii_ = &radii;
    const std::size_t n = radii.R.size();
    cosine_.resize(n), sine_.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double alpha = now_.turn.value * radii.h[k];  // (5)
      cosine_[k] = std::cos(alpha), sine_[k] = std::sin(alpha);
    }
    if (!now_.response || !out_.any_stress()) return;
    tau_.assign(9 * n, 0), slopes_.assign(9 * n, 0);
    now_.response->many(radii.xi, out_.P || out_.sigma ? all_nine : of_force, tau_.data(), slopes_.data());
    if (!out_.b && !out_.static_force) return;
    force_.set(radii, tau_, slopes_, now_.turn.value, now_.density);
  }

  /// Of a point that lies on radius k at the angle whose cosine and sine are c, s.
  void write(std::size_t p, std::size_t k, const Vector3& X, double c, double s) const {
    const double R = radii_->R[k], cosine = cosine_[k], sine = sine_[k];
    const double c_now = c * cosine - s * sine, s_now = s * cosine + c * sine;
    if (out_.b || out_.static_force) put_forces(p, k, c_now, s_now);
    if (!out_.x && !out_.v && !out_.a && !out_.F && !out_.P && !out_.sigma) return;
    const RingKinematics ring = kinematics(k);
    const double stretch = R > 0 ? ring.rho / R : ring.rho_slope;
    const auto turn = [&](double along, double across) {  // of X, in the plane
      const double a = cosine * along - sine * across, b = sine * along + cosine * across;
      return std::array{a * X.x() - b * X.y(), b * X.x() + a * X.y()};
    };
    const auto put = [&](const FieldView& view, const std::array<double, 2>& plane, double z) {
      view.at(p, 0) = plane[0], view.at(p, 1) = plane[1];
      if (out_.dimension == 3) view.at(p, 2) = z;
    };
    if (out_.x) put(out_.x, turn(stretch, 0), X.z());
    if (out_.v) put(out_.v, turn(R > 0 ? ring.rho_rate / R : ring.rho_slope_rate, stretch * ring.alpha_rate), 0);
    if (out_.a) {
      const Polar a = R > 0 ? ring.acceleration() : ring.acceleration_slope();
      put(out_.a, R > 0 ? turn(a.r / R, a.theta / R) : turn(a.r, a.theta), 0);
    }
    if (!out_.F && !out_.P && !out_.sigma) return;
    const Tensor q = turned_axes(c, s), r = turned_axes(c_now, s_now), B = ring.baseline(R);
    put_nine(out_.F, p, r * B * q.transpose());
    if (!out_.P && !out_.sigma) return;
    const Tensor tau = tau_.empty() ? Tensor(Tensor::Zero()) : tensor_at(tau_.data(), radii_->R.size(), k);
    put_nine(out_.P, p, r * tau * q.transpose());  // (20)
    if (!out_.sigma) return;
    const Tensor sigma = r * cauchy_stress(tau, B) * r.transpose();
    for (std::size_t i = 0; i < 6; ++i) out_.sigma.at(p, i) = component(sigma, symmetric[i]);
  }

 private:
  static constexpr std::array<int, 6> symmetric{0, 4, 8, 1, 2, 5};

  static void put_nine(const FieldView& view, std::size_t p, const Tensor& value) {
    for (int i = 0; view && i < 9; ++i) view.at(p, static_cast<std::size_t>(i)) = component(value, i);
  }

  RingKinematics kinematics(std::size_t k) const {
    const RingProfile profile{radii_->h[k], radii_->h_prime[k], 0, 0};
    RingKinematics ring = RingKinematics::turned(radii_->R[k], profile, now_.turn);
    if (!radii_->radial.empty()) ring.widen(radii_->radial[k], now_.widening);
    return ring;
  }

  /// (32) and (33), where a ring widens with its own inertia; along z that of a direction out of the plane.
  void put_forces(std::size_t p, std::size_t k, double c, double s) const {
    const double R = radii_->R[k];
    Polar a{-R * (now_.turn.rate * radii_->h[k]) * (now_.turn.rate * radii_->h[k]),
            R * now_.turn.acceleration * radii_->h[k]};
    if (out_.b && !radii_->radial.empty()) a = kinematics(k).acceleration();
    const bool stressed = !force_.r.empty();
    const double r = stressed ? force_.r[k] : 0, theta = stressed ? force_.theta[k] : 0;
    const double z = stressed && R > 0 ? force_.z[k] : 0;
    const auto put = [&](const FieldView& view, double along_r, double along_theta) {
      if (!view) return;
      view.at(p, 0) = c * along_r - s * along_theta, view.at(p, 1) = s * along_r + c * along_theta;
      if (out_.dimension == 3) view.at(p, 2) = z;
    };
    put(out_.b, a.r + r, a.theta + theta);
    put(out_.static_force, r, theta);
  }

  const PolarSlice& now_;
  const FieldViews& out_;
  const RadiusColumns* radii_ = nullptr;
  std::vector<double> cosine_, sine_;  ///< of alpha
  std::vector<double> tau_, slopes_;   ///< [c * n + k]
  ForceColumns force_;
};

class PolarPlaces final : public ExactPlaces {
 public:
  PolarPlaces(const Motion& motion, std::vector<Vector3> X) : ExactPlaces(std::move(X)) {
    for (std::size_t begin = 0; begin < size(); begin += piece_points) {
      add_piece(motion, begin, std::min(begin + piece_points, size()));
    }
  }

  void evaluate(const ExactSlice& slice, std::size_t first, std::size_t count, const FieldViews& out) const override {
    const auto& now = static_cast<const PolarSlice&>(slice);
    RadiiNow radii(now, out);
    RadiusColumns some;
    std::vector<std::uint32_t> place;
    for (std::size_t begin = first; begin < first + count;) {
      const std::size_t end = std::min(first + count, (begin / piece_points + 1) * piece_points);
      const RadiusColumns& piece = pieces_[begin / piece_points];
      const bool whole = end - begin == piece_points || (begin % piece_points == 0 && end == size());
      if (!whole) select(piece, begin, end, some, place);
      radii.set(whole ? piece : some);
      for (std::size_t p = begin; p < end; ++p) {
        radii.write(p - first, whole ? radius_[p] : place[radius_[p]], X(p), cosine_[p], sine_[p]);
      }
      begin = end;
    }
  }

 private:
  void add_piece(const Motion& motion, std::size_t begin, std::size_t end) {
    std::vector<double> all, distinct;
    for (std::size_t p = begin; p < end; ++p) all.push_back(std::hypot(X(p).x(), X(p).y()));
    distinct = all;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    RadiusColumns& piece = pieces_.emplace_back();
    for (const double R : distinct) piece.add(motion, R);
    for (std::size_t p = begin; p < end; ++p) {
      const double R = all[p - begin];
      const auto found = std::lower_bound(distinct.begin(), distinct.end(), R);
      radius_.push_back(static_cast<std::uint32_t>(found - distinct.begin()));
      cosine_.push_back(R > 0 ? X(p).x() / R : 1), sine_.push_back(R > 0 ? X(p).y() / R : 0);
    }
  }

  /// The radii of these points alone. place: of a radius of the piece among them.
  void select(const RadiusColumns& piece, std::size_t begin, std::size_t end, RadiusColumns& some,
              std::vector<std::uint32_t>& place) const {
    constexpr auto none = static_cast<std::uint32_t>(-1);
    place.assign(piece.R.size(), none);
    for (std::size_t p = begin; p < end; ++p) place[radius_[p]] = 0;
    some.clear();
    for (std::size_t k = 0; k < place.size(); ++k) {
      if (place[k] == none) continue;
      place[k] = static_cast<std::uint32_t>(some.R.size());
      some.add(piece, k);
    }
  }

  std::vector<RadiusColumns> pieces_;
  std::vector<std::uint32_t> radius_;  ///< of each point among those of its piece
  std::vector<double> cosine_, sine_;  ///< of Theta
};

}  // namespace

std::unique_ptr<const ExactSlice> slice_of_ring(const ExactSolution& solution, double density, double t) {
  return std::make_unique<PolarSlice>(solution, density, t);
}

std::unique_ptr<const ExactPlaces> places_of_ring(const Motion& motion, std::vector<Vector3> X) {
  return std::make_unique<PolarPlaces>(motion, std::move(X));
}

}  // namespace assay
