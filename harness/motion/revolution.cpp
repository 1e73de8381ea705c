// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/revolution.hpp"

#include <algorithm>
#include <cmath>

#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

/// Points this close to the edge [of 1 - s^2] count as on it: the rounding of a place must not put it outside.
constexpr double edge_rounding = 1e-14;

/// q^m of q = 1 - s^2 and its first two derivatives with respect to s^2.
struct Power {
  double value = 0, slope = 0, second = 0;
};

std::optional<Power> power_of(double q, int m) {
  if (q < -edge_rounding) return std::nullopt;
  q = std::max(q, 0.0);
  double lower = 1;  // q^(m - 2): 1 for m = 2, on the edge too
  for (int k = 2; k < m; ++k) lower *= q;
  return Power{lower * q * q, -m * lower * q, m * (m - 1) * lower};
}

/// 1 - x^2/a^2, exactly 0 on the edge.
double rest_of(double x, double a) { return (a - x) * (a + x) / (a * a); }

/// h = q^m with s^2 = ((R - R0)^2 + Z^2)/a^2.
std::optional<MeridianProfile> round_profile(double R, double Z, double R0, double a, int m) {
  const double from = R - R0;
  const auto f = power_of(rest_of(std::sqrt(from * from + Z * Z), a), m);
  if (!f) return std::nullopt;
  const double scale = 2 / (a * a), s_R = scale * from, s_Z = scale * Z;  // derivatives of s^2
  return MeridianProfile{f->value,
                         f->slope * (R0 == 0 ? scale : s_R / R),
                         f->slope * s_Z,
                         f->second * s_R * s_R + f->slope * scale,
                         f->second * s_R * s_Z,
                         f->second * s_Z * s_Z + f->slope * scale};
}

/// h = f(R) e(Z).
std::optional<MeridianProfile> drum_profile(double R, double Z, double a, int m, double c, int k) {
  const auto f = power_of(rest_of(R, a), m), e = power_of(rest_of(std::abs(Z), c), k);
  if (!f || !e) return std::nullopt;
  const double along_R = 2 / (a * a), along_Z = 2 / (c * c), s_R = along_R * R, s_Z = along_Z * Z;
  return MeridianProfile{f->value * e->value,
                         f->slope * along_R * e->value,
                         f->value * e->slope * s_Z,
                         (f->second * s_R * s_R + f->slope * along_R) * e->value,
                         f->slope * s_R * e->slope * s_Z,
                         f->value * (e->second * s_Z * s_Z + e->slope * along_Z)};
}

}  // namespace

std::optional<MeridianProfile> Revolution::at(double R, double Z) const {
  auto p = profile == Profile::drum
               ? drum_profile(R, Z, radius, profile_power, height.value_or(radius), height_power.value_or(usual_power))
               : round_profile(R, Z, profile == Profile::torus ? ring_radius.value_or(0) : 0, radius, profile_power);
  if (!p || strength == 1) return p;
  for (double* part : {&p->h, &p->h_R_by_R, &p->h_Z, &p->h_RR, &p->h_RZ, &p->h_ZZ}) *part *= strength;
  return p;
}

double Revolution::depth(const Vector3& X) const {
  const Vector3 n = unit_along(axis), from = X - center;
  const double Z = from.dot(n), R = (from - Z * n).norm();
  if (profile == Profile::drum) return std::min(rest_of(R, radius), rest_of(std::abs(Z), height.value_or(radius)));
  return rest_of(std::hypot(R - (profile == Profile::torus ? ring_radius.value_or(0) : 0), Z), radius);
}

std::array<double, 2> Revolution::reach() const {
  const bool is_torus = profile == Profile::torus;
  return {radius + (is_torus ? ring_radius.value_or(0) : 0),
          profile == Profile::drum ? height.value_or(radius) : radius};
}

Vector3 Revolution::half_box() const {
  const Vector3 along = unit_along(axis).cwiseAbs();
  const Vector3 across = (1 - along.array().square()).max(0).sqrt();
  if (profile == Profile::drum) return radius * across + height.value_or(radius) * along;
  if (profile == Profile::torus) return ring_radius.value_or(0) * across + Vector3::Constant(radius);
  return Vector3::Constant(radius);
}

double Revolution::length() const {
  const double along_R = profile_length(radius, profile_power);
  if (profile != Profile::drum) return along_R;
  return std::min(along_R, profile_length(height.value_or(radius), height_power.value_or(usual_power)));
}

bool Revolution::has_smooth_edge() const {
  constexpr int smooth = 4;
  return profile_power >= smooth && (profile != Profile::drum || height_power.value_or(usual_power) >= smooth);
}

// The best of many places, from which ever shorter steps climb.
double largest_xi_of(const Revolution& r) {
  constexpr int looks = 64;
  constexpr double shortest = 1e-9;  // of the size; of xi that is the square of it
  const auto [outer, high] = r.reach();
  const double inner = r.profile == Revolution::Profile::torus ? outer - 2 * r.radius : 0, wide = outer - inner;
  double best = 0, R = inner, Z = 0;
  const auto climb = [&](double at_R, double at_Z) {
    const auto p = at_R < 0 ? std::nullopt : r.at(at_R, at_Z);
    const double xi = p ? 0.5 * at_R * std::hypot(at_R * p->h_R_by_R, p->h_Z) : 0;
    if (xi <= best) return false;
    best = xi, R = at_R, Z = at_Z;
    return true;
  };
  for (int i = 0; i <= looks; ++i) {
    for (int j = 0; j <= looks; ++j) climb(inner + wide * i / looks, high * j / looks);
  }
  for (double step = 1.0 / looks; step > shortest;) {
    const double R0 = R, Z0 = Z;
    bool climbs = false;
    for (const double i : {-1, 0, 1}) {
      for (const double j : {-1, 0, 1}) climbs |= climb(R0 + i * step * wide, std::abs(Z0 + j * step * high));
    }
    if (!climbs) step /= 2;
  }
  return best;
}

}  // namespace assay
