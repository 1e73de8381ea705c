// SPDX-License-Identifier: BSD-3-Clause
// The vortex in three dimensions by brute force: positions in complex numbers, their gradient by complex steps, the
// stress of the point's own history in Cartesian axes, its divergence by differences. Nothing of a baseline is used.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "harness/history/point_driver.hpp"
#include "harness/material/checked_update.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::turning_body {

using Complex = std::complex<double>;
using Complex3 = Eigen::Matrix<Complex, 3, 1>;

/// h as a polynomial, beyond the edge, too: what is smooth inside has its limit on the edge.
inline Complex profile_of(const Revolution& r, const Complex3& from_center) {
  const Vector3 n = r.axis / r.axis.norm();
  const Complex Z = n.x() * from_center.x() + n.y() * from_center.y() + n.z() * from_center.z();
  Complex square = -Z * Z;
  for (int d = 0; d < 3; ++d) square += from_center(d) * from_center(d);  // R^2
  const double a = r.radius;
  const auto power = [](const Complex& base, int m) {
    Complex product = 1;
    for (int k = 0; k < m; ++k) product *= base;
    return product;
  };
  switch (r.profile) {
    case Revolution::Profile::ball:
      return r.strength * power(1.0 - (square + Z * Z) / (a * a), r.profile_power);
    case Revolution::Profile::torus: {
      const Complex out = std::sqrt(square) - *r.ring_radius;
      return r.strength * power(1.0 - (out * out + Z * Z) / (a * a), r.profile_power);
    }
    case Revolution::Profile::drum:
      return r.strength * power(1.0 - square / (a * a), r.profile_power) *
             power(1.0 - Z * Z / (*r.height * *r.height), r.height_power.value_or(4));
  }
  return 0;
}

/// Rodrigues' rotation of X about the axis through the centre by g h.
inline Complex3 position(const Revolution& r, const Complex& g, const Complex3& X) {
  const Complex3 n = (r.axis / r.axis.norm()).cast<Complex>();
  const Complex3 from = X - r.center.cast<Complex>();
  const Complex alpha = g * profile_of(r, from);
  const Complex3 across(n(1) * from(2) - n(2) * from(1), n(2) * from(0) - n(0) * from(2),
                        n(0) * from(1) - n(1) * from(0));
  const Complex along = n(0) * from(0) + n(1) * from(1) + n(2) * from(2);  // without conjugation
  return r.center.cast<Complex>() + std::cos(alpha) * from + std::sin(alpha) * across +
         (1.0 - std::cos(alpha)) * along * n;
}

inline Tensor gradient(const Revolution& r, double g, const Vector3& X) {
  constexpr double step = 1e-30;
  Tensor F;
  for (int j = 0; j < 3; ++j) {
    Complex3 at = X.cast<Complex>();
    at(j) += Complex(0, step);
    F.col(j) = position(r, g, at).imag() / step;
  }
  return F;
}

/// Central difference of eighth order.
auto difference(const auto& f, double h) {
  const auto pair = [&](int k) { return (f(k * h) - f(-k * h)).eval(); };
  return ((pair(1) * (4.0 / 5) - pair(2) * (1.0 / 5) + pair(3) * (4.0 / 105) - pair(4) * (1.0 / 280)) / h).eval();
}

class BruteForce {
 public:
  BruteForce(const Revolution& vortex, const Amplitude& amplitude, std::shared_ptr<const Material> material,
             double density, double step)
      : vortex_(vortex), amplitude_(amplitude), material_(std::move(material)), density_(density), step_(step) {}

  Tensor F(const Vector3& X, double t) const { return gradient(vortex_, amplitude_.at(t).value, X); }
  /// g' dF/dg.
  Tensor F_rate(const Vector3& X, double t) const {
    constexpr double step = 0.02;
    const AmplitudeValue g = amplitude_.at(t);
    return g.rate * difference([&](double dg) { return gradient(vortex_, g.value + dg, X); }, step);
  }
  Vector3 x(const Vector3& X, double t) const {
    return position(vortex_, amplitude_.at(t).value, X.cast<Complex>()).real();
  }
  /// g' dx/dg.
  Vector3 v(const Vector3& X, double t) const {
    constexpr double step = 1e-30;
    const AmplitudeValue g = amplitude_.at(t);
    return g.rate * position(vortex_, Complex(g.value, step), X.cast<Complex>()).imag() / step;
  }
  Vector3 a(const Vector3& X, double t) const {
    return difference([&](double dt) { return v(X, t + dt); }, time_step);
  }

  /// Of the point's own F(t).
  Tensor P(const Vector3& X, double t) const {
    if (material_->is_function_of_F()) {
      const std::vector<double> rest = material_->initial_state(1, {}, {});
      const Tensor now = F(X, t);
      return first_piola_kirchhoff(stepped(*material_, 0, t, Tensor::Identity(), now, rest, 1).cauchy, now);
    }
    Path path;
    path.name = "own";
    path.parameter = {0, 1};
    path.curved = [&, X](double xi, double at) {
      if (xi == 0) {  // a shear beside it: what errors of a point without stress are small against
        const AmplitudeValue g = amplitude_.at(at);
        PathPoint beside;
        beside.F(1, 0) = g.value, beside.F_rate(1, 0) = g.rate;
        return beside;
      }
      return PathPoint{F(X, at), F_rate(X, at)};
    };
    path.reversals = [g = amplitude_](double end) { return g.reversals(end); };
    const Histories found =
        integrate_histories(*material_, path, std::array{0.0, 1.0}, std::array{t}, {.tolerance = history_tolerance});
    return tensor_at(found.tau[0].data(), 2, 1);
  }

  Vector3 body_force(const Vector3& X, double t) const {
    Vector3 divergence = Vector3::Zero();
    for (int j = 0; j < 3; ++j) {
      divergence += difference([&](double dx) { return P(X + dx * Vector3::Unit(j), t); }, step_).col(j);
    }
    return a(X, t) - divergence / density_;
  }

 private:
  static constexpr double time_step = 4e-3, history_tolerance = 1e-13;
  Revolution vortex_;
  Amplitude amplitude_;
  std::shared_ptr<const Material> material_;
  double density_, step_;
};

inline std::vector<Revolution> shapes(int power, const Vector3& axis, const Vector3& center) {
  Revolution ball{.radius = 1, .profile_power = power, .axis = axis, .center = center};
  Revolution torus = ball, drum = ball;
  torus.profile = Revolution::Profile::torus, torus.ring_radius = 0.6, torus.radius = 0.35;
  drum.profile = Revolution::Profile::drum, drum.height = 0.7, drum.height_power = power == 2 ? 3 : power;
  drum.strength = -0.8;
  return {ball, torus, drum};
}

inline std::string name_of(const Revolution& r) { return names_of(r.profile)[static_cast<std::size_t>(r.profile)]; }

/// Random places in the body, on its axis, on the circles where Grad h = 0, on its edge.
inline std::vector<Vector3> places_in(const Revolution& r, int random, unsigned seed) {
  const Vector3 n = r.axis.normalized(), e = n.unitOrthogonal(), f = n.cross(e);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto place = [&](double R, double Z) {
    const double angle = 2 * std::numbers::pi * share(generator);
    return Vector3(r.center + R * (std::cos(angle) * e + std::sin(angle) * f) + Z * n);
  };
  std::vector<Vector3> places;
  const auto [wide, high] = r.reach();
  while (static_cast<int>(places.size()) < random) {
    const double R = wide * share(generator), Z = high * (2 * share(generator) - 1);
    if (r.at(R, Z)) places.push_back(place(R, Z));
  }
  const double a = r.radius;
  switch (r.profile) {
    case Revolution::Profile::ball:
      for (const double Z : {0.0, 0.4, -0.9}) places.push_back(place(0, Z));
      for (const double angle : {0.0, 0.5, 1.2}) places.push_back(place(a * std::cos(angle), a * std::sin(angle)));
      break;
    case Revolution::Profile::torus:
      for (int k = 0; k < 3; ++k) places.push_back(place(*r.ring_radius, 0));
      places.push_back(place(*r.ring_radius + 1e-6, -2e-6));
      for (const double angle : {0.0, 1.1, 3.0})
        places.push_back(place(*r.ring_radius + a * std::cos(angle), a * std::sin(angle)));
      break;
    case Revolution::Profile::drum:
      for (const double Z : {0.0, 0.3, -0.69}) places.push_back(place(0, Z));
      places.push_back(place(1e-6, 1e-6));
      for (const double Z : {0.0, 0.4}) places.push_back(place(a, Z));
      for (const double R : {0.2, 0.8}) places.push_back(place(R, *r.height));
      break;
  }
  return places;
}

/// Largest deviations and largest values over some points.
struct Largest {
  double deviation = 0, value = 0;
  void see(const auto& found, const auto& wanted) {
    deviation = std::max(deviation, (found - wanted).norm());
    value = std::max(value, wanted.norm());
  }
  double relative() const { return deviation / value; }
};

}  // namespace assay::turning_body
