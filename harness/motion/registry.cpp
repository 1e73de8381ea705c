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
  const auto& makers = motion_registry().paths_;
  const auto found = makers.find(name);
  if (found == makers.end()) throw std::runtime_error("no recipe of a path");
  return found->second(reader);
}

}  // namespace assay
