// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/vortex3d.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/registry.hpp"
#include "harness/numeric/norms.hpp"

namespace assay {

Tensor MeridianPoint::rotation(double alpha) const { return Eigen::AngleAxisd(alpha, E_Z).toRotationMatrix(); }

Tensor MeridianPoint::axes() const {
  const Vector3 E_R = R > 0 ? Vector3(radial / R) : E_Z.unitOrthogonal();
  Tensor axes;
  axes << c * E_R + s * E_Z, E_Z.cross(E_R), c * E_Z - s * E_R;
  return axes;
}

namespace {

/// Absent outside the vortex. E_Z: along its axis [1].
std::optional<MeridianPoint> place_in(const Revolution& vortex, const Vector3& E_Z, const Vector3& X) {
  MeridianPoint p;
  p.center = vortex.center;
  p.E_Z = E_Z;
  const Vector3 from = X - p.center;
  p.Z = from.dot(p.E_Z);
  p.radial = from - p.Z * p.E_Z;
  p.R = p.radial.norm();
  const auto profile = vortex.at(p.R, p.Z);
  if (!profile) return std::nullopt;
  p.profile = *profile;
  const double h_R = p.R * profile->h_R_by_R;
  p.G = std::sqrt(h_R * h_R + profile->h_Z * profile->h_Z);
  if (p.G > 0) p.c = h_R / p.G, p.s = profile->h_Z / p.G;
  p.xi = 0.5 * p.R * p.G;
  return p;
}

}  // namespace

VortexFinder::VortexFinder(const Vortex3d& motion)
    : vortices_(motion.all().begin(), motion.all().end()), boxes_(vortices_) {
  for (const Revolution& vortex : vortices_) along_.push_back(unit_along(vortex.axis));
}

std::optional<MeridianPoint> VortexFinder::place(const Vector3& X) const {
  if (vortices_.size() == 1) return place_in(vortices_[0], along_[0], X);
  std::optional<MeridianPoint> found;
  boxes_.around(X, [&](std::size_t k) {
    if (found && found->vortex < k) return;
    if (auto here = place_in(vortices_[k], along_[k], X)) found = here, found->vortex = k;
  });
  return found;
}

std::optional<MeridianPoint> Vortex3d::place(const Vector3& X) const {
  const std::span<const Revolution> vortices_here = all();
  for (std::size_t k = 0; k < vortices_here.size(); ++k) {
    auto found = place_in(vortices_here[k], unit_along(vortices_here[k].axis), X);
    if (!found) continue;
    found->vortex = k;
    return found;
  }
  return std::nullopt;
}

Vector3 acceleration_of(const MeridianPoint& p, const AmplitudeValue& g, const Tensor& Q) {
  const double h = p.profile.h, omega = g.rate * h;  // [rad/s]
  const Vector3 from_axis = Q * p.radial;
  return g.acceleration * h * p.E_Z.cross(from_axis) - omega * omega * from_axis;
}

ExactState state_of(const MeridianPoint& p, const AmplitudeValue& g) {
  const double h = p.profile.h, omega = g.rate * h;  // [rad/s]
  const Tensor Q = p.rotation(g.value * h);
  const Vector3 from_axis = Q * p.radial, across = p.E_Z.cross(from_axis);
  const Tensor shear = across * p.gradient().transpose();  // Q (E_Z x X) (x) k
  ExactState state;
  state.x = p.center + p.Z * p.E_Z + from_axis;
  state.v = omega * across;
  state.a = acceleration_of(p, g, Q);
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

std::optional<Vortex3d::Overlap> Vortex3d::overlap() const {
  const BodyBoxes boxes(vortices);
  for (std::size_t i = 0; i < vortices.size(); ++i) {
    std::optional<Overlap> found;
    boxes.meeting(vortices[i], [&](std::size_t j) {
      if (j <= i || (found && found->second < j)) return;
      if (const auto X = common_point(vortices[i], vortices[j])) found = Overlap{i, j, *X};
    });
    if (found) return found;
  }
  return std::nullopt;
}

double Vortex3d::largest_xi() const {
  double largest = 0;
  std::set<Revolution::Shape> seen;  // vortices of one shape are sought once
  for (const Revolution& vortex : all()) {
    if (seen.insert(vortex.shape()).second) largest = std::max(largest, largest_xi_of(vortex));
  }
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
  /// Distances from axis and centre are kept: what turned is turned back.
  std::optional<Vector3> reference_of(const Vector3& x, double t) const override {
    const auto p = m.place(x);
    return p ? state_of(*p, {.value = -m.amplitude.at(t).value}).x : x;
  }
  const Amplitude* amplitude() const override { return &m.amplitude; }
  bool is_homogeneous() const override { return false; }
  bool is_plane() const override { return false; }
  bool only_in_space() const override { return true; }
  bool turns_its_shear() const override { return true; }
  bool bears_tractions() const override { return false; }
  double length() const override {
    double shortest = HUGE_VAL;
    for (const Revolution& vortex : m.all()) shortest = std::min(shortest, vortex.length());
    return shortest;
  }

  void keys(Keys& keys) override {
    m.one.keys(keys, m.vortices.empty(), usual_profile_power);
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
      const auto place = [&](double x) { return use.text(x, "m", 4); };
      return MotionFault{"motion.vortices[" + std::to_string(both->second) + "]",
                         "overlaps motion.vortices[" + std::to_string(both->first) + "], for both hold the point (" +
                             place(X.x()) + ", " + place(X.y()) + ", " + place(X.z()) + "): they must be disjoint"};
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
                                     use.text(*r.ring_radius, "m") + " and " + use.text(r.radius, "m"));
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
