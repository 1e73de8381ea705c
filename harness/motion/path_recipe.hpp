// SPDX-License-Identifier: BSD-3-Clause
// A path as numbers, for another process to make the same.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "harness/motion/path.hpp"
#include "harness/numeric/number_archive.hpp"

namespace assay {

/// What a motion keeps in its path's `recipe`. name: under which its file registers who makes the path again.
template <class Parts>
std::vector<double> recipe(std::string name, Parts parts) {
  NumberWriter writer;
  writer(name, parts);
  return std::move(writer.numbers);
}

/// The path of a recipe as its motion makes it: range and material direction may have been changed since. Throws
/// std::runtime_error where it is no recipe.
Path path_of_recipe(std::span<const double> recipe);

}  // namespace assay
