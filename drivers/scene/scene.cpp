// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

Location Scene::place(const std::string& key) const {
  if (const auto found = places.find(key); found != places.end()) return found->second;
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? Location{file} : place(key.substr(0, dot));
}

Path baseline_path(const Scene& scene) {
  Path path = baseline_of(scene.motion);
  if (!scene.material.direction) return path;
  const auto& d = *scene.material.direction;
  const Vector3 unit = Vector3(d[0], d[1], d[2]).stableNormalized();
  path.material_direction = {unit.x(), unit.y(), unit.z()};
  return path;
}

}  // namespace assay::drivers
