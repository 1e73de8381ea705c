// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/vortex3d.hpp"

#include <algorithm>
#include <cmath>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/registry.hpp"
#include "harness/numeric/norms.hpp"
#include "harness/numeric/number_text.hpp"

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
  const auto f = power_of(rest_of(std::hypot(from, Z), a), m);
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

/// The largest xi in the meridian plane: the best of many places, from which ever shorter steps climb.
double largest_xi_of(const Revolution& r) {
  constexpr int looks = 64;
  constexpr double shortest = 1e-9;  // of the size; of xi that is the square of it
  const auto [wide, high] = r.reach();
  double best = 0, R = 0, Z = 0;
  const auto climb = [&](double at_R, double at_Z) {
    const auto p = at_R < 0 ? std::nullopt : r.at(at_R, at_Z);
    const double xi = p ? 0.5 * at_R * std::hypot(at_R * p->h_R_by_R, p->h_Z) : 0;
    if (xi <= best) return false;
    best = xi, R = at_R, Z = at_Z;
    return true;
  };
  for (int i = 0; i <= looks; ++i) {
    for (int j = 0; j <= looks; ++j) climb(wide * i / looks, high * j / looks);
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

bool Revolution::has_smooth_edge() const {
  constexpr int smooth = 4;
  return profile_power >= smooth && (profile != Profile::drum || height_power.value_or(usual_power) >= smooth);
}

Tensor MeridianPoint::rotation(double alpha) const {
  const double cosine = std::cos(alpha), sine = std::sin(alpha);
  Tensor Q = (1 - cosine) * E_Z * E_Z.transpose();
  Q.diagonal().array() += cosine;
  const Vector3 n = sine * E_Z;
  Q(0, 1) -= n.z(), Q(1, 0) += n.z();
  Q(0, 2) += n.y(), Q(2, 0) -= n.y();
  Q(1, 2) -= n.x(), Q(2, 1) += n.x();
  return Q;
}

Tensor MeridianPoint::axes() const {
  const Vector3 E_R = R > 0 ? Vector3(radial / R) : E_Z.unitOrthogonal();
  Tensor axes;
  axes << c * E_R + s * E_Z, E_Z.cross(E_R), c * E_Z - s * E_R;
  return axes;
}

std::optional<MeridianPoint> Vortex3d::place(const Vector3& X) const {
  for (const Revolution& vortex : all()) {
    MeridianPoint p;
    p.center = vortex.center;
    p.E_Z = unit_along(vortex.axis);
    const Vector3 from = X - p.center;
    p.Z = from.dot(p.E_Z);
    p.radial = from - p.Z * p.E_Z;
    p.R = p.radial.norm();
    const auto profile = vortex.at(p.R, p.Z);
    if (!profile) continue;
    p.profile = *profile;
    const double h_R = p.R * profile->h_R_by_R;
    p.G = std::hypot(h_R, profile->h_Z);
    if (p.G > 0) p.c = h_R / p.G, p.s = profile->h_Z / p.G;
    p.xi = 0.5 * p.R * p.G;
    return p;
  }
  return std::nullopt;
}

ExactState state_of(const MeridianPoint& p, const AmplitudeValue& g) {
  const double h = p.profile.h, omega = g.rate * h;  // [rad/s]
  const Tensor Q = p.rotation(g.value * h);
  const Vector3 from_axis = Q * p.radial, across = p.E_Z.cross(from_axis);
  const Tensor shear = across * p.gradient().transpose();  // Q (E_Z x X) (x) k
  ExactState state;
  state.x = p.center + p.Z * p.E_Z + from_axis;
  state.v = omega * across;
  state.a = g.acceleration * h * across - omega * omega * from_axis;
  state.F = Q + g.value * shear;
  state.F_rate = g.rate * shear;
  for (int column = 0; column < 3; ++column)
    state.F_rate.col(column) += omega * p.E_Z.cross(Vector3(state.F.col(column)));
  return state;
}

ExactState Vortex3d::at(const Vector3& X, double t) const {
  if (const auto p = place(X)) return state_of(*p, amplitude.at(t));
  ExactState state;
  state.x = X;
  return state;
}

namespace {

/// The point that lies deepest in both, near the deepest of a lattice in the smaller one's box.
std::pair<double, Vector3> deepest_of(const Revolution& a, const Revolution& b) {
  constexpr int looks = 24;
  constexpr double shortest = 1e-7;  // of the size
  const auto size = [](const Revolution& r) { return std::hypot(r.reach()[0], r.reach()[1]); };
  const Revolution& smaller = size(a) < size(b) ? a : b;
  Vector3 X = smaller.center;
  double deepest = -HUGE_VAL;
  const auto look = [&](const Vector3& at) {
    const double depth = std::min(a.depth(at), b.depth(at));
    const bool deeper = depth > deepest;
    if (deeper) deepest = depth, X = at;
    return deeper;
  };
  const double half = size(smaller);
  for (int k = 0; k < looks * looks * looks; ++k) {
    const Vector3 share(k % looks, k / looks % looks, k / looks / looks);
    look(smaller.center + half * (2 * share / (looks - 1) - Vector3::Ones()));
  }
  for (double step = 2 * half / looks; step > shortest * half;) {
    const Vector3 from = X;
    bool deeper = false;
    for (int k = 0; k < 27; ++k) deeper |= look(from + step * Vector3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
    if (!deeper) step /= 2;
  }
  return {deepest, X};
}

}  // namespace

std::optional<Vortex3d::Overlap> Vortex3d::overlap() const {
  constexpr double touching = 1e-6;  // as deep: bodies whose edges touch have no point in common
  for (std::size_t i = 0; i < vortices.size(); ++i) {
    for (std::size_t j = i + 1; j < vortices.size(); ++j) {
      const auto [depth, X] = deepest_of(vortices[i], vortices[j]);
      if (depth > touching) return Overlap{i, j, X};
    }
  }
  return std::nullopt;
}

double Vortex3d::largest_xi() const {
  double largest = 0;
  for (const Revolution& vortex : all()) largest = std::max(largest, largest_xi_of(vortex));
  return largest;
}

Path Vortex3d::baseline() const {
  constexpr double beyond_rounding = 1e-14;
  Path path = Vortex{.amplitude = amplitude}.baseline();
  path.parameter = {0, largest_xi() * (1 + beyond_rounding)};
  path.recipe = recipe("vortex3d", *this);
  return path;
}

namespace {

class Vortex3dKind final : public MotionOf<Vortex3dKind, Vortex3d> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "vortex3d"; }
  double period() const override { return m.amplitude.period; }
  const Amplitude* amplitude() const override { return &m.amplitude; }
  bool is_homogeneous() const override { return false; }
  bool is_plane() const override { return false; }
  bool only_in_space() const override { return true; }
  bool turns_its_shear() const override { return true; }
  bool bears_tractions() const override { return false; }

  void keys(Keys& keys) override {
    m.one.keys(keys, m.vortices.empty());
    keys("vortices", "several disjoint vortices in one body, in place of the one: a list of maps", m.vortices);
    period_key(keys, m.amplitude.period);
    m.amplitude.keys(keys);
  }

  std::optional<MotionFault> fault(const MotionUse& use) const override {
    if (m.vortices.empty()) return fault_of(m.one, "motion.", use);
    std::optional<MotionFault> found;
    EachKey each([&](const KeyInfo& key, KeyType, const KeyValue&) -> EachKey::Answer {
      const std::string path = "motion." + std::string(key.name);
      if (use.gives(path)) found = MotionFault{path, "belongs to the items of motion.vortices, which is given"};
      return std::nullopt;
    });
    Revolution().keys(each);
    for (std::size_t k = 0; k < m.vortices.size() && !found; ++k)
      found = fault_of(m.vortices[k], "motion.vortices[" + std::to_string(k) + "].", use);
    if (found) return found;
    if (const auto both = m.overlap()) {
      const Vector3& X = both->X;
      return MotionFault{"motion.vortices[" + std::to_string(both->second) + "]",
                         "overlaps motion.vortices[" + std::to_string(both->first) + "], for both hold the point (" +
                             rounded_text(X.x(), 4) + ", " + rounded_text(X.y(), 4) + ", " + rounded_text(X.z(), 4) +
                             "): they must be disjoint"};
    }
    return std::nullopt;
  }

 private:
  static std::optional<MotionFault> fault_of(const Revolution& r, const std::string& path, const MotionUse& use) {
    const auto says = [&](const char* key, const std::string& what) { return MotionFault{path + key, what}; };
    const bool is_torus = r.profile == Revolution::Profile::torus, is_drum = r.profile == Revolution::Profile::drum;
    if (is_torus && !r.ring_radius) return says("ring_radius", "required of a torus and not given");
    if (is_drum && !r.height) return says("height", "required of a drum and not given");
    for (const char* key : {"ring_radius", "height", "height_power"}) {
      const bool of_torus = std::string_view(key) == "ring_radius";
      if (use.gives(path + key) && !(of_torus ? is_torus : is_drum))
        return says(key, std::string("belongs to a ") + (of_torus ? "torus" : "drum") + ", and profile is " +
                             names_of(r.profile)[static_cast<std::size_t>(r.profile)]);
    }
    if (is_torus && !(*r.ring_radius > r.radius))
      return says("ring_radius", "must be more than radius, so that the torus does not reach its axis, found " +
                                     number_text(*r.ring_radius) + " and " + number_text(r.radius));
    if (auto fault = fault_of_axis(r.axis)) return says("axis", fault->what);
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const Vortex3d& motion) { return std::make_unique<Vortex3dKind>(motion); }

void register_vortex3d(MotionRegistry& registry) {
  registry.motion(Vortex3d{});
  registry.path<Vortex3d>("vortex3d");
}

}  // namespace assay
