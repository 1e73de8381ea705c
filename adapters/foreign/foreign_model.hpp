// SPDX-License-Identifier: BSD-3-Clause
// A model behind somebody else's interface, in plain values: what a description says of it.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "harness/assay_material.h"

namespace assay::adapters {

enum class ForeignInterface {
  umat,     ///< of Abaqus/Standard
  vumat,    ///< of Abaqus/Explicit
  mfront,   ///< generic behaviours
  usermat,  ///< of Ansys
  lsdyna,   ///< umat41 to umat50
};
constexpr std::array<const char*, 5> names_of(ForeignInterface) {
  return {"umat", "vumat", "mfront", "usermat", "lsdyna"};
}

/// How a step becomes a strain increment and a rotation.
enum class Kinematics {
  objective,  ///< polar decomposition of the step, logarithmic strain: second order, objective at any step
  abaqus,     ///< Hughes and Winget: first order in simple shear, as the program that the model was written for
};
constexpr std::array<const char*, 2> names_of(Kinematics) { return {"objective", "abaqus"}; }

/// In which axes a UMAT is given tensors.
enum class Axes {
  fixed,         ///< those of space: a model of a material with directions turns them itself
  corotational,  ///< they turn with the polar rotation of F, as with Abaqus' *ORIENTATION
};
constexpr std::array<const char*, 2> names_of(Axes) { return {"fixed", "corotational"}; }

/// One material constant, in the model's own units. A value that is NaN must be given.
struct ForeignProperty {
  std::string name, unit = {}, doc = {};
  double value = NAN, lower = -INFINITY, upper = INFINITY;
};

/// One state variable, in the order in which the model keeps them.
struct ForeignVariable {
  enum class Kind {
    scalar,
    vector,
    symmetric_tensor,  ///< like a stress
    strain,            ///< like a strain: shear components as the interface has them for strains
    tensor,
    mandel,  ///< shear components times sqrt(2), as MFront keeps tensors
  };
  std::string name;
  Kind kind = Kind::scalar;
  std::string unit = {}, doc = {};
  std::vector<double> initial = {};  ///< one value for all components, or one for each; empty: zero
  bool kind_is_said = true;          ///< or it stands as a scalar because nobody has said what it is
};

constexpr std::array<const char*, 6> names_of(ForeignVariable::Kind) {
  return {"scalar", "vector", "symmetric_tensor", "strain", "tensor", "mandel"};
}

/// A field of the host: PREDEF, or an external state variable of MFront.
struct ForeignField {
  std::string name;
  double value = 0;
};

/// SI units in one unit of the model: a stress of 1 MPa is stress = 1e6.
struct ModelUnits {
  double stress = 1;  ///< [Pa]
  double time = 1;    ///< [s]
  double length = 1;  ///< [m]
};

/// What DDSDDE of a law in F holds: Abaqus asks for the modulus of the Jaumann rate of J sigma, over J. The others are
/// for those who look for what a wrong one is.
enum class Moduli { jaumann, truesdell, jaumann_of_tau, truesdell_of_tau };

struct ForeignModel {
  std::string library;  ///< absolute path
  std::string symbol;   ///< entry point; of MFront the behaviour's name
  std::string name;     ///< of the table; [a-z0-9_]+
  std::string doc, version, licence;
  std::vector<ForeignProperty> properties;
  std::vector<ForeignVariable> state;
  std::vector<int> components{6};  ///< NTENS that the model serves: 6, 4 (plane strain) or both; or 3 (plane stress)
  double thickness = 0.5;          ///< of plane stress: Poisson's ratio of the change of thickness
  ModelUnits units;
  std::vector<ForeignField> fields;
  std::vector<std::string> varying = {};      ///< names of fields, and of the temperature, that a path may change
  std::string hypothesis = "Tridimensional";  ///< of MFront: which function of the behaviour is called
  double temperature = 0;                     ///< in the model's own scale
  double characteristic_length = 1;           ///< CELENT, charLength, in units of the model
  double density = 1000;                      ///< [kg/m^3], for interfaces that hand it on
  std::string material_name = "ASSAY";        ///< CMNAME
  std::string folder = {};                    ///< GETOUTDIR; empty: that of the library
  ForeignInterface interface = ForeignInterface::umat;
  Kinematics kinematics = Kinematics::objective;
  Axes axes = Axes::fixed;
  Moduli moduli = Moduli::jaumann;
  int symmetry = ASSAY_ISOTROPIC;  ///< of the ABI
  int material_class = 0;          ///< of assay_symmetry, of what is anisotropic; 0: none is declared
  std::uint32_t flags = 0;         ///< of the ABI
  int step = 1;                    ///< KSTEP
  int arguments = 18;              ///< of a routine of LS-DYNA; 12, 13 or 16 in older releases
  int element = 1, point = 1;      ///< NOEL, NPT
  bool each_its_element = false;   ///< NOEL counts points, as they begin
  bool finite_strain = false;      ///< the tangent is that of J sigma (Jaumann), and the model may read F alone
  bool strain_is_said = true;      ///< or which tangent it is has not been said
  bool components_are_said = true;
  bool symmetry_is_said = true;
  bool flags_are_said = true;
  bool units_are_said = true;
  bool temperature_is_said = false;
};

}  // namespace assay::adapters
