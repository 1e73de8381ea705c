// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/path_recipe.hpp"

#include <cmath>

#include "harness/motion/motion.hpp"
#include "harness/numeric/number_archive.hpp"

namespace assay {

// In the namespace of the motions, where an archive looks for them.
template <class Archive>
void fields(Archive& archive, Amplitude& g) {
  archive(g.type, g.peak, g.period);
}
template <class Archive>
void fields(Archive& archive, Vortex& m) {
  archive(m.inner, m.outer, m.profile_power, m.amplitude);
}
template <class Archive>
void fields(Archive& archive, Homogeneous& m) {
  archive(m.final, m.period);
}
template <class Archive>
void fields(Archive& archive, RotatingStretch& m) {
  archive(m.stretch, m.shear, m.rotation, m.axis, m.rotate, m.period);
}
template <class Archive>
void fields(Archive& archive, TwistingRing& m) {
  archive(m.twist, m.expansion);
}
template <class Archive>
void fields(Archive& archive, AxisAligned& m) {
  archive(m.amplitude, m.one_dimensional, m.given_speed);
}
template <class Archive>
void fields(Archive& archive, Rigid& m) {
  archive(m.velocity, m.spin, m.axis, m.period);
}

namespace {

enum class RecipeKind { vortex, homogeneous, rotating_stretch, table, twisting_ring, axis_aligned, rigid };

struct TableRecipe {
  std::vector<double> times;
  std::vector<Tensor> F;
  Interpolation interpolation = Interpolation::monotone;
};

struct SectionRecipe {
  AxisAligned motion;
  double cosine_of_Y = 1;
};

template <class Archive>
void fields(Archive& archive, TableRecipe& m) {
  archive(m.times, m.F, m.interpolation);
}
template <class Archive>
void fields(Archive& archive, SectionRecipe& m) {
  archive(m.motion, m.cosine_of_Y);
}

template <class Parts>
std::vector<double> written(RecipeKind kind, Parts parts) {
  NumberWriter writer;
  writer(kind, parts);
  return std::move(writer.numbers);
}

template <class Parts>
Parts read(NumberReader& reader) {
  Parts parts;
  reader(parts);
  return parts;
}

Path path_of(const SectionRecipe& recipe) { return recipe.motion.section(recipe.cosine_of_Y); }

Path path_of(const TableRecipe& recipe) {
  if (recipe.times.size() < 2 || recipe.F.size() != recipe.times.size() ||
      recipe.interpolation > Interpolation::spline) {
    throw std::runtime_error("no table");
  }
  return DeformationTable("", recipe.times, recipe.F, recipe.interpolation).baseline();
}

}  // namespace

std::vector<double> recipe_of(const Vortex& motion) { return written(RecipeKind::vortex, motion); }
std::vector<double> recipe_of(const Homogeneous& motion) { return written(RecipeKind::homogeneous, motion); }
std::vector<double> recipe_of(const RotatingStretch& motion) { return written(RecipeKind::rotating_stretch, motion); }
std::vector<double> recipe_of(const DeformationTable& motion) {
  return written(RecipeKind::table, TableRecipe{motion.times(), motion.rows(), motion.interpolation()});
}
std::vector<double> recipe_of(const TwistingRing& motion) { return written(RecipeKind::twisting_ring, motion); }
std::vector<double> recipe_of(const AxisAligned& motion, double cosine_of_Y) {
  return written(RecipeKind::axis_aligned, SectionRecipe{motion, cosine_of_Y});
}
std::vector<double> recipe_of(const Rigid& motion) { return written(RecipeKind::rigid, motion); }

Path path_of_recipe(std::span<const double> recipe) {
  NumberReader reader(recipe);
  switch (read<RecipeKind>(reader)) {
    case RecipeKind::vortex:
      return read<Vortex>(reader).baseline();
    case RecipeKind::homogeneous:
      return read<Homogeneous>(reader).baseline();
    case RecipeKind::rotating_stretch:
      return read<RotatingStretch>(reader).baseline();
    case RecipeKind::table:
      return path_of(read<TableRecipe>(reader));
    case RecipeKind::twisting_ring:
      return read<TwistingRing>(reader).baseline();
    case RecipeKind::axis_aligned:
      return path_of(read<SectionRecipe>(reader));
    case RecipeKind::rigid:
      return read<Rigid>(reader).baseline();
  }
  throw std::runtime_error("no recipe of a path");
}

}  // namespace assay
