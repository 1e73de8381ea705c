// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/registry.hpp"

namespace assay {

#define ASSAY_MOTION(name) void register_##name(MotionRegistry&);
#include "motion_list.inc"
#undef ASSAY_MOTION

std::vector<Motion> MotionRegistry::samples() const {
  std::vector<Motion> all;
  for (const auto& [order, sample] : samples_) all.push_back(sample);
  return all;
}

MotionRegistry::PathMaker MotionRegistry::path_maker(const std::string& name) const {
  const auto found = paths_.find(name);
  return found == paths_.end() ? nullptr : found->second;
}

const MotionRegistry& motion_registry() {
  static const MotionRegistry all = [] {
    MotionRegistry registry;
#define ASSAY_MOTION(name) register_##name(registry);
#include "motion_list.inc"
#undef ASSAY_MOTION
    return registry;
  }();
  return all;
}

Path path_of_recipe(std::span<const double> recipe) {
  NumberReader reader(recipe);
  std::string name;
  reader(name);
  if (const auto maker = motion_registry().path_maker(name)) return maker(reader);
  throw std::runtime_error("no recipe of a path");
}

}  // namespace assay
