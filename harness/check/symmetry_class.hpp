// SPDX-License-Identifier: BSD-3-Clause
// Classes of material symmetry: their rotations, and how far a stiffness is from each about the axes that suit it best.
#pragma once

#include <string>
#include <vector>

#include "harness/check/stiffness.hpp"

namespace assay::check {

/// Those of assay_symmetry, and what is before and beyond them.
enum class SymmetryClass {
  none = 0,
  monoclinic = ASSAY_MONOCLINIC,
  orthotropic = ASSAY_ORTHOTROPIC,
  trigonal = ASSAY_TRIGONAL,
  tetragonal = ASSAY_TETRAGONAL,
  hexagonal = ASSAY_HEXAGONAL,
  transversely_isotropic = ASSAY_TRANSVERSELY_ISOTROPIC,
  cubic = ASSAY_CUBIC,
  isotropic,
};

/// What a material that is not isotropic declares by assay.symmetry/1; none where that says nothing.
SymmetryClass declared_class(const assay_material& table);

/// All but none, the most symmetric first.
const std::vector<SymmetryClass>& all_classes();

/// "transversely isotropic".
std::string name_of(SymmetryClass symmetry);

/// The rotations of a class in its own axes, of which all others are made; its principal axis is the third. For any
/// angle stands one that is no fraction of a turn.
const std::vector<Tensor>& generators_of(SymmetryClass symmetry);

/// The 60 rotations of an icosahedron: sums over them do not prefer a direction, up to the fifth order.
const std::vector<Tensor>& icosahedral_rotations();

/// The nearest stiffness of a class whose axes are the columns of `axes`.
Stiffness projected(const Stiffness& C, SymmetryClass symmetry, const Tensor& axes);

/// How far a stiffness is from a class about some axes: the largest component of the difference over the largest of the
/// stiffness.
double miss_of(const Stiffness& C, SymmetryClass symmetry, const Tensor& axes);

/// Axes of a class, as columns, and how far something is from it about them.
struct ClassFit {
  Tensor axes = Tensor::Identity();
  double miss = INFINITY;
};

/// About the axes that suit it best, and about all others that suit it as well, some of them where there are infinitely
/// many: a cube is orthotropic in four ways.
std::vector<ClassFit> fits_of(const Stiffness& C, SymmetryClass symmetry);

/// The most symmetric class that a stiffness is of, within a miss of `share`.
SymmetryClass class_of(const Stiffness& C, double share);

/// "about (0.6, 0.8, 0)", "about (0.6, 0.8, 0), (-0.8, 0.6, 0), (0, 0, 1)": the axes that a class has; empty of what is
/// isotropic.
std::string about(SymmetryClass symmetry, const Tensor& axes);

/// Whether the ring of a vortex may be of the material: its response is the same all around the axis E3, in its own
/// axes where these turn with the radius. It declares so, or declares transverse isotropy and is that at rest about E3.
bool serves_ring(const Material& material);

/// Of the modulus, or of the largest stress: as of the other tests of a stiffness.
inline constexpr double class_within = 1e-3;

}  // namespace assay::check
