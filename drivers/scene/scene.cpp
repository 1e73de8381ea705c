// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

Location Scene::place(const std::string& key) const {
  if (const auto found = places.find(key); found != places.end()) return found->second;
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? Location{file} : place(key.substr(0, dot));
}

}  // namespace assay::drivers
