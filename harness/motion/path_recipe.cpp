// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/path_recipe.hpp"

#include "harness/motion/registry.hpp"

namespace assay {

Path path_of_recipe(std::span<const double> recipe) {
  NumberReader reader(recipe);
  std::string name;
  reader(name);
  if (const auto maker = motion_registry().path_maker(name)) return maker(reader);
  throw std::runtime_error("no recipe of a path");
}

}  // namespace assay
