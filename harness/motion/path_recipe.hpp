// SPDX-License-Identifier: BSD-3-Clause
// A path as numbers, for another process to make the same.
#pragma once

#include <span>
#include <vector>

#include "harness/motion/path.hpp"

namespace assay {

struct AxisAligned;
class DeformationTable;
struct Homogeneous;
struct Rigid;
struct RotatingStretch;
struct TwistingRing;
struct Vortex;

/// What a motion keeps in its path's `recipe`.
std::vector<double> recipe_of(const Vortex& motion);
std::vector<double> recipe_of(const Homogeneous& motion);
std::vector<double> recipe_of(const RotatingStretch& motion);
std::vector<double> recipe_of(const DeformationTable& motion);
std::vector<double> recipe_of(const TwistingRing& motion);
std::vector<double> recipe_of(const AxisAligned& motion, double cosine_of_Y);  ///< of a section
std::vector<double> recipe_of(const Rigid& motion);

/// The path of a recipe as its motion makes it: range and material direction may have been changed since. Throws
/// std::runtime_error where it is no recipe.
Path path_of_recipe(std::span<const double> recipe);

}  // namespace assay
