// SPDX-License-Identifier: BSD-3-Clause
// The input files of MTest, the point driver of TFEL: what is asked of a behaviour, and what is expected of it.
//
// Conventions of MTest:
// - The hypothesis decides which components there are, and their order (mtest_components.hpp).
// - A shear component of a small strain or of a stress is sqrt(2) times the component of the tensor, as 'EXY' and
// 'SXY'.
//   Strain and stress then have the same scalar product as their tensors. This holds for what is imposed, for initial
//   values, for what is compared, and for the columns of files.
// - Components of a deformation gradient are those of the tensor: 'FXY' is the row X and the column Y.
// - A stress that goes with a deformation gradient is Cauchy's. The option stress_measure of the behaviour changes what
//   the behaviour gives, and not what the file says. A wrapper as LogarithmicStrain1D takes a strain and gives the
//   first Piola-Kirchhoff stress instead.
// - A component that nothing is imposed on is free: its stress is zero at all times.
// - PlaneStrain fixes EZZ at 0 or FZZ at 1.
// - PlaneStress fixes SZZ at 0. AxisymmetricalGeneralisedPlaneStress fixes the second component, SZZ, at the evolution
//   'AxialStress', or at 0 where there is none. The behaviour finds the strain of that component itself and keeps it as
//   an internal variable, often 'AxialStrain'. The component of the gradient stays at 0, that of F at 1.
// - Gradients begin at 0, a deformation gradient at the identity, stresses and internal variables at 0.
// - A file of reference values has the initial state in its first line. Line i + 1 belongs to the time i, from 0.
//   Columns count from 1. In the files that MTest writes column 1 is the time; then come the gradient, the stress, the
//   internal variables, and energies.
// - Comparisons are made after each step, not of the initial state.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/point_drivers/function_of_time.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

struct MtestBehaviour {
  std::string interface;  ///< "castem", "generic", ...; empty: it is read from the library
  std::string wrapper;    ///< "LogarithmicStrain1D"; empty: none
  std::string library, function;
  std::map<std::string, std::string> options;  ///< stress_measure, tangent_operator; a list as "a, b"
  bool is_model = false;                       ///< of @Model: it has no gradient and no stress
  Location where;
};

/// Where a value comes from that a library of material properties computes.
struct MtestLibraryFunction {
  std::string interface, library, function;
};

struct MtestProperty {
  std::string name;
  FunctionOfTime value;                             ///< none where a library computes it
  std::optional<MtestLibraryFunction> computed_by;  ///< of the evolutions that have the names of its arguments
  Location where;
};

struct MtestParameter {
  std::string name;
  double value = 0;
  Location where;
};

struct MtestVariable {
  std::string name;  ///< of a component where the variable has several: "v[1]X"
  FunctionOfTime value;
  Location where;
};

struct MtestInitialValue {
  std::string name;            ///< of an internal variable; "omega" stands for all of "omega[0]", "omega[1]", ...
  std::vector<double> values;  ///< one after the other, also of an array of tensors
  bool in_braces = false;      ///< otherwise one number, for each of an array
  Location where;
};

struct MtestImposed {
  /// gradient, force: of behaviours whose variables have other names than strain and stress.
  enum class Quantity { strain, deformation_gradient, stress, gradient, force };
  std::string component;
  Quantity quantity = Quantity::strain;
  FunctionOfTime value;
  Location where;
};

/// What @NonLinearConstraint keeps at zero: a formula of components, of evolutions and of the time.
struct MtestConstraint {
  std::string formula;
  bool is_of_stress = false;            ///< it is measured in the unit of a stress
  std::vector<std::string> components;  ///< that the formula holds and that nothing is imposed on
  std::function<double(const std::vector<double>& components, double time)> value;
  Location where;
};

struct MtestComparison {
  std::string variable;     ///< a component of the gradient or stress, an internal or an external variable
  double tolerance = 0;     ///< of the absolute difference, in the unit of the variable
  FunctionOfTime expected;  ///< none where a file holds the values
  std::string file;         ///< as mtest_path() gives it
  int column = 0;           ///< from 1; 0: see column_formula
  std::string column_formula;
  Location where;
};

struct MtestIgnored {
  std::string keyword, what;  ///< "@AccelerationAlgorithm", "'Cast3M': how MTest's solver converges"
  Location where;
};

enum class MtestKinematics { unknown, small_strain, finite_strain, other };

struct MtestFile {
  std::string file;
  std::string author, date, description;
  MtestBehaviour behaviour;
  std::string hypothesis = "Tridimensional";
  /// Of the names of the components that are imposed, and of the number of initial values. unknown: only stresses are
  /// imposed. other: gradients of other names.
  MtestKinematics kinematics = MtestKinematics::unknown;
  std::vector<MtestProperty> properties;
  std::vector<MtestParameter> parameters;  ///< integers too
  std::vector<MtestVariable> external;     ///< external state variables; 'Temperature' is one
  std::map<std::string, FunctionOfTime>
      evolutions;  ///< all that formulas may name: also what is imposed, and properties
  std::vector<MtestImposed> imposed;
  std::vector<MtestConstraint> constraints;
  std::vector<double> initial_gradient, initial_force;  ///< empty: nothing is said
  std::vector<MtestInitialValue> initial_state;
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< by rows; column i is the material's direction i
  bool is_rotated = false;
  std::vector<double> times;  ///< ascending, at least two
  std::vector<MtestComparison> comparisons;
  std::optional<double> strain_epsilon, stress_epsilon;  ///< to which what is imposed must be met
  std::optional<int> most_iterations, most_substeps;
  bool thermal_expansion = true;  ///< MTest takes the strain of the properties 'ThermalExpansion...' off
  std::string out_of_bounds;      ///< "None", "Warning", "Strict"; empty: nothing is said
  std::vector<MtestIgnored> ignored;
};

/// What is not in the file.
struct MtestSurroundings {
  std::map<std::string, std::string> placeholders;  ///< values of @library@, @interface@, ..., by name without the @
  /// Default values of the behaviour's parameters, which formulas call "Norton::YoungModulus".
  std::map<std::string, double> parameters;
};

/// Throws InputError: file, line, column, keyword.
MtestFile mtest_from_text(const std::string& text, const std::string& file, const MtestSurroundings& surroundings = {});
MtestFile read_mtest(const std::string& file, const MtestSurroundings& surroundings = {});

/// The expected values of a comparison with a file, one a line of that file. Throws InputError.
std::vector<double> expected_lines(const MtestFile& file, const MtestComparison& comparison);

/// All keywords that are read, for messages.
const std::vector<std::string>& mtest_keywords();

/// A file that an MTest file names: beside it, unless the name is absolute.
std::string mtest_path(const std::string& mtest_file, const std::string& name);

}  // namespace assay::drivers
