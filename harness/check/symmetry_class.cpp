// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/symmetry_class.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "harness/check/symmetry_axes.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay::check {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

Tensor half_turn_about(int axis) { return turn_about(Vector3::Unit(axis), full_turn / 2); }

/// About the third axis by the n-th part of a turn, and half a turn across.
std::vector<Tensor> dihedral(double n) { return {turn_about(Vector3::UnitZ(), full_turn / n), half_turn_about(0)}; }

std::vector<Tensor> icosahedral() {
  return {turn_about({0, 1, std::numbers::phi}, full_turn / 5), turn_about({1, 1, 1}, full_turn / 3)};
}

/// Of finitely many rotations the same stiffnesses are invariant: those have no component that turns by more than four
/// times an angle.
std::vector<Tensor> finite_generators_of(SymmetryClass symmetry) {
  if (symmetry == SymmetryClass::transversely_isotropic) return dihedral(5);
  if (symmetry == SymmetryClass::isotropic) return icosahedral();
  return generators_of(symmetry);
}

/// All products of some rotations.
std::vector<Tensor> group_of(const std::vector<Tensor>& generators) {
  constexpr double same = 1e-9;
  std::vector<Tensor> group{Tensor::Identity()};
  for (std::size_t k = 0; k < group.size(); ++k) {
    for (const Tensor& g : generators) {
      const Tensor product = g * group[k];
      const auto is_same = [&](const Tensor& other) { return distance(other, product) < same; };
      if (std::none_of(group.begin(), group.end(), is_same)) group.push_back(product);
    }
  }
  return group;
}

/// The mean over the rotations of a class, of the 36 components of a stiffness in Mandel's form.
Projector projector_of(SymmetryClass symmetry) {
  const std::vector<Tensor> group = group_of(finite_generators_of(symmetry));
  Projector mean = Projector::Zero();
  for (const Tensor& Q : group) {
    const Stiffness K = rotation_in_mandel(Q);
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) mean.block<6, 6>(6 * i, 6 * j) += K(i, j) * K;
    }
  }
  return mean / static_cast<double>(group.size());
}

const Projector& kept_projector_of(SymmetryClass symmetry) {
  static const std::map<SymmetryClass, Projector> all = [] {
    std::map<SymmetryClass, Projector> made;
    for (const SymmetryClass each : all_classes()) made.emplace(each, projector_of(each));
    return made;
  }();
  return all.at(symmetry);
}

/// In the axes of the class.
Stiffness projected_there(const Stiffness& M, SymmetryClass symmetry) {
  Stiffness result;
  Eigen::Map<Components>(result.data()) = kept_projector_of(symmetry) * Eigen::Map<const Components>(M.data());
  return result;
}

/// What a stiffness without symmetry becomes: the same about all axes of which a class has the same rotations.
Stiffness sample_of(SymmetryClass symmetry, const Tensor& axes) {
  Stiffness any;
  for (int k = 0; k < 36; ++k) any(k) = std::sin(1.0 + k * k);
  return projected(any, symmetry, axes);
}

/// Which of its axes a class has: none, the principal one, that and those of half turns, all three.
enum class Axes { none, principal, with_half_turns, all };

struct ClassRow {
  const char* name;
  std::vector<Tensor> generators;
  Axes axes;
};

const ClassRow& row_of(SymmetryClass symmetry) {
  static const Vector3 x = Vector3::UnitX(), z = Vector3::UnitZ();
  static const ClassRow rows[] = {
      {"without a class", {}, Axes::none},
      {"monoclinic", {half_turn_about(2)}, Axes::principal},
      {"orthotropic", dihedral(2), Axes::all},
      {"trigonal", dihedral(3), Axes::with_half_turns},
      {"tetragonal", dihedral(4), Axes::with_half_turns},
      {"hexagonal", dihedral(6), Axes::principal},
      {"transversely isotropic", {turn_about(z, turning_angle), half_turn_about(0)}, Axes::principal},
      {"cubic", {turn_about(z, full_turn / 4), turn_about(x, full_turn / 4)}, Axes::all},
      {"isotropic", {turn_about({1, 2, 3}, turning_angle), turn_about({2, -1, 1}, turning_angle)}, Axes::none}};
  return rows[static_cast<std::size_t>(symmetry)];
}

std::string in_words(Vector3 axis) {
  constexpr double nothing = 5e-4, digits = 1e3;
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis(largest) < 0) axis = -axis;
  std::string text;
  for (int i = 0; i < 3; ++i) {
    const double shown = std::abs(axis(i)) < nothing ? 0 : std::round(digits * axis(i)) / digits;
    text += (i ? ", " : "(") + rounded_text(shown, 6);
  }
  return text + ")";
}

}  // namespace

SymmetryClass declared_class(const assay_material& table) {
  if (table.symmetry == ASSAY_ISOTROPIC) return SymmetryClass::none;
  const auto* said = static_cast<const assay_symmetry*>(extension_of(&table, ASSAY_EXTENSION_SYMMETRY));
  if (!said || said->struct_size < sizeof(assay_symmetry)) return SymmetryClass::none;
  const bool known = said->material_class >= ASSAY_MONOCLINIC && said->material_class <= ASSAY_CUBIC;
  return known ? static_cast<SymmetryClass>(said->material_class) : SymmetryClass::none;
}

const std::vector<SymmetryClass>& all_classes() {
  using enum SymmetryClass;
  static const std::vector<SymmetryClass> all{
      isotropic, cubic, transversely_isotropic, hexagonal, tetragonal, trigonal, orthotropic, monoclinic};
  return all;
}

std::string name_of(SymmetryClass symmetry) { return row_of(symmetry).name; }

const std::vector<Tensor>& generators_of(SymmetryClass symmetry) { return row_of(symmetry).generators; }

const std::vector<Tensor>& icosahedral_rotations() {
  static const std::vector<Tensor> all = group_of(icosahedral());
  return all;
}

Stiffness projected(const Stiffness& C, SymmetryClass symmetry, const Tensor& axes) {
  const Stiffness K = rotation_in_mandel(axes);
  return without_mandel(K * projected_there(K.transpose() * in_mandel(C) * K, symmetry) * K.transpose());
}

double miss_of(const Stiffness& C, SymmetryClass symmetry, const Tensor& axes) {
  return size_of(C - projected(C, symmetry, axes)) / size_of(C);
}

std::vector<ClassFit> fits_of(const Stiffness& C, SymmetryClass symmetry) {
  constexpr double as_well = 10, rounding = 1e-9, same = 1e-4;  // misses alike; of the components of `sample_of`
  const Projector off = Projector::Identity() - kept_projector_of(symmetry);
  std::vector<ClassFit> found;
  for (const Tensor& axes : best_axes(in_mandel(C), off)) found.push_back({axes, miss_of(C, symmetry, axes)});
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.miss < b.miss; });
  std::vector<ClassFit> distinct;
  std::vector<Stiffness> samples;
  for (const ClassFit& fit : found) {
    if (fit.miss > as_well * found.front().miss + rounding) break;
    const Stiffness sample = sample_of(symmetry, fit.axes);
    const auto is_same = [&](const Stiffness& other) { return size_of(other - sample) < same; };
    if (std::any_of(samples.begin(), samples.end(), is_same)) continue;
    samples.push_back(sample);
    distinct.push_back(fit);
  }
  return distinct;
}

SymmetryClass class_of(const Stiffness& C, double share) {
  for (const SymmetryClass each : all_classes()) {
    if (each == SymmetryClass::hexagonal) continue;  // the same stiffnesses as transversely isotropic
    if (fits_of(C, each).front().miss <= share) return each;
  }
  return SymmetryClass::none;
}

std::string about(SymmetryClass symmetry, const Tensor& axes) {
  switch (row_of(symmetry).axes) {
    case Axes::none:
      return "";
    case Axes::principal:
      return "about " + in_words(axes.col(2));
    case Axes::with_half_turns:
      return "about " + in_words(axes.col(2)) + " and, by half turns, " + in_words(axes.col(0));
    case Axes::all:
      break;
  }
  return "about " + in_words(axes.col(0)) + ", " + in_words(axes.col(1)) + ", " + in_words(axes.col(2));
}

bool serves_ring(const Material& material) {
  constexpr auto symmetry = SymmetryClass::transversely_isotropic;
  if (material.table().symmetry != ASSAY_ANISOTROPIC) return true;
  if (declared_class(material.table()) != symmetry) return false;
  try {
    return miss_of(probed(material, 0, 1).stiffness, symmetry, Tensor::Identity()) <= class_within;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace assay::check
