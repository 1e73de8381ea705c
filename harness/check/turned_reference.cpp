// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/turned_reference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/check/judge.hpp"
#include "harness/check/march.hpp"

namespace assay::check {

namespace {

constexpr int increments = 64;  ///< in each piece of a path between reversals, as in coarse marches of a Course

struct Orientation {
  Vector3 axis = Vector3::UnitX();
  double angle = 0;  ///< [rad]
  Tensor R() const { return turn_about(axis, angle); }
};

/// The first is the baseline itself.
std::vector<Orientation> orientations_of(const Material& material) {
  const Vector3 z = Vector3::UnitZ();
  if (material.has(ASSAY_IN_PLANE)) return {{}, {z, 0.9}, {z, 0.4}, {z, 2.1}};
  return {{}, {{1, 2, 3}, 0.9}, {{3, -1, 2}, 2.1}, {{-2, 3, 1}, 0.4}};
}

/// Ends of equal increments of each piece [s].
std::vector<double> times_of(const Path& path, double end, int count) {
  std::vector<double> pieces = path.reversals(end), times{0};
  pieces.push_back(end);
  for (const double last : pieces) {
    const double first = times.back();
    for (int k = 1; k <= count; ++k) times.push_back(first + (last - first) * k / count);
  }
  return times;
}

/// Orientations, of which the first is the baseline, as the points of one batch. Throws MaterialFailure.
TurnedReference found_in(const Material& material, const Path& path, double end, int count,
                         const std::vector<Orientation>& all) {
  const double xi = std::max(path.parameter.lower, path.parameter.upper,
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
  const auto& d = path.material_direction;
  Batch batch;
  for (const Orientation& each : all) {
    batch.states.push_back(state_at_rest(material, 0, each.R() * Vector3(d[0], d[1], d[2])));
  }
  const auto all_at = [&](double t) {
    const Tensor F = path.deformation_gradient(xi, t);
    std::vector<Tensor> turned;
    for (const Orientation& each : all) turned.push_back(rotated(each.R(), F));
    return turned;
  };
  TurnedReference found;
  double largest = 0;
  const std::vector<double> times = times_of(path, end, count);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const auto stresses =
        batch.step(material, times[k], times[k + 1] - times[k], all_at(times[k]), all_at(times[k + 1]));
    largest = std::max(largest, size_of(stresses.front()));
    for (std::size_t p = 1; p < all.size(); ++p) {
      const Tensor error = rotated(all[p].R().transpose(), stresses[p]) - stresses.front();
      Eigen::Index i = 0, j = 0;
      const double here = error.cwiseAbs().maxCoeff(&i, &j);
      if (!(here > found.difference)) continue;
      const std::string name = "s" + std::to_string(std::min(i, j) + 1) + std::to_string(std::max(i, j) + 1);
      found = {here, all[p].axis, all[p].angle, name};
    }
  }
  if (found.difference > 0) found.difference /= largest;
  return found;
}

std::string in_brackets(const Vector3& v) {
  return "(" + rounded(v.x(), 3) + ", " + rounded(v.y(), 3) + ", " + rounded(v.z(), 3) + ")";
}

/// The path whose largest eps is that of a moderate shear, whatever the scene's amplitude: neither rounding nor a
/// stress without bounds is compared then. Nothing where nothing moves.
std::optional<Path> at_moderate_shear(const Path& path, double end) {
  constexpr double moderate = 0.1;
  if (!path.straight()) return path;
  const Interval g = path.amplitude_range(end);
  const double largest = std::max(std::abs(g.lower), std::abs(g.upper));
  const double xi = moderate / largest;
  if (!(largest > 0) || path.parameter.width() == 0 || !std::isfinite(xi)) return std::nullopt;
  Path scaled = path;
  scaled.parameter = {0, xi};
  return scaled;
}

/// Whether the baseline's stress is rounding beside that of a stretch: a fluid's, which is isotropic.
bool bears_no_shear(const Material& material, const Path& path, double end) {
  constexpr double of_rounding = 1e-9;
  const auto stress_at = [&](const Tensor& F) {
    Batch batch;
    batch.states.push_back(state_at_rest(material, 0, Vector3::UnitX()));
    return size_of(batch.step(material, 0, end, {Tensor::Identity()}, {F}).front());
  };
  Tensor stretch = Tensor::Identity();
  stretch(0, 0) = 1.01;
  return if_taken(
      [&] {
        return stress_at(path.deformation_gradient(path.parameter.upper, 0.3 * end)) < of_rounding * stress_at(stretch);
      },
      false);
}

bool is_along_an_axis(const Vector3& direction) {
  constexpr double rounding = 1e-12;
  const Vector3 sizes = direction.normalized().cwiseAbs();
  return (sizes.array() > rounding).count() == 1;
}

}  // namespace

std::optional<TurnedReference> turned_reference(const Material& material, const Path& path, double end) {
  constexpr double falls = 0.25;  // as of other tests that compare two frames
  const std::vector<Orientation> all = orientations_of(material);
  const auto in = [&](int count, const std::vector<Orientation>& some) -> std::optional<TurnedReference> {
    try {
      return found_in(material, path, end, count, some);
    } catch (const MaterialFailure& failure) {
      if (failure.final) throw;
      return std::nullopt;
    }
  };
  int count = increments;
  std::optional<TurnedReference> found;
  for (const int finer : {1, 4, 16}) {
    found = in(count = finer * increments, all);
    if (found) break;
  }
  if (!found) {
    if (!in(count, {all.front()})) return std::nullopt;
    const auto refused = std::find_if(all.begin() + 1, all.end(), [&](const Orientation& each) {
      return !in(count, {all.front(), each});
    });
    if (refused == all.end()) return std::nullopt;
    return TurnedReference{INFINITY, refused->axis, refused->angle};
  }
  if (found->is_isotropic() || found->difference > converging_limit) return found;
  // An integrator that chooses its own steps by components of the strain takes others in another frame.
  const std::optional<TurnedReference> finer = in(16 * count, all);
  found->falls = finer && finer->difference <= falls * found->difference;
  return found;
}

std::optional<std::string> reason_against_axis(const Material& material, const Path& path, double end) {
  const auto& d = path.material_direction;
  const Vector3 direction(d[0], d[1], d[2]);
  if (has_direction(material.table()) && !is_along_an_axis(direction)) {
    return "the direction " + in_brackets(direction) +
           " of the model is along no axis of the baseline; a motion about an axis needs it along [1, 0, 0], [0, 1, 0] "
           "or [0, 0, 1]";
  }
  const auto moderate = at_moderate_shear(path, end);
  if (!moderate || bears_no_shear(material, *moderate, end)) return std::nullopt;
  const std::optional<TurnedReference> found = turned_reference(material, *moderate, end);
  if (!found || found->is_isotropic()) return std::nullopt;
  const std::string turn = "turned by " + rounded(found->angle) + " rad about " + in_brackets(found->axis);
  const std::string how = std::isinf(found->difference)
                              ? "it refuses the same shear " + turn
                              : turn + " the same shear gives a stress that differs by " + percent(found->difference) +
                                    " (" + found->component + ")";
  return "the model is not isotropic in its reference configuration: " + how +
         "; a motion about an axis needs an isotropic model, or one whose only direction assay fills in";
}

}  // namespace assay::check
