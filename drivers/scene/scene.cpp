// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

Location Scene::place(const std::string& key) const {
  if (const auto found = places.find(key); found != places.end()) return found->second;
  const std::size_t end = key.find_last_of(".[");
  return end == std::string::npos ? Location{file} : place(key.substr(0, end));
}

namespace {

/// With what the scene says of the material at rest.
Path with_rest(Path path, const Scene& scene) {
  path.initial_cauchy = scene.initial_cauchy();
  if (!scene.material.direction) return path;
  const auto& d = *scene.material.direction;
  const Vector3 unit = unit_along({d[0], d[1], d[2]});
  path.material_direction = {unit.x(), unit.y(), unit.z()};
  return path;
}

/// Of cos(pi X) between two places [m].
Interval cosines(double lower, double upper) {
  const auto cosine = [](double X) { return std::cos(std::numbers::pi * X); };
  Interval range{std::min(cosine(lower), cosine(upper)), std::max(cosine(lower), cosine(upper))};
  for (double X = std::ceil(lower); X <= upper && X < lower + 2; ++X) {
    range.lower = std::min(range.lower, cosine(X));
    range.upper = std::max(range.upper, cosine(X));
  }
  return range;
}

}  // namespace

Path baseline_path(const Scene& scene) { return with_rest(scene.motion->baseline(), scene); }

std::vector<Path> baseline_paths(const Scene& scene) {
  const auto* box = scene.motion.as<AxisAligned>();
  if (!box || box->one_dimensional) return {baseline_path(scene)};
  constexpr int sections = 4;
  const Interval along_X = cosines(scene.body.lower[0], scene.body.upper[0]);
  const Interval along_Y = cosines(scene.body.lower[1], scene.body.upper[1]);
  const auto cosines_of_Z = box->s().z() == 0 ? std::vector<double>{1} : std::vector<double>{-1, 0, 1};
  std::vector<Path> paths;
  for (const double cosine_of_Z : cosines_of_Z) {
    for (int k = 0; k <= sections; ++k) {
      Path path = box->section(along_Y.lower + along_Y.width() * k / sections, cosine_of_Z);
      path.parameter = along_X;
      paths.push_back(with_rest(std::move(path), scene));
    }
  }
  return paths;
}

}  // namespace assay::drivers
