// SPDX-License-Identifier: BSD-3-Clause
// The input files of Niemunis' incremental driver, which calls a UMAT at one point: the load path (test.inp), the
// initial stress and state (initialconditions.inp) and the constants (parameters.inp).
//
// Conventions of the driver:
// - Components are 11, 22, 33, 12, 13, 23. Tension is positive. Shear strains are gamma = 2 epsilon.
// - A step prescribes for each of six variables either the change of the stress or that of the strain. The variables
// are
//   Cartesian components, or combinations of them: x = M T of stresses T, and strains e with E = M^T e. The work x e is
//   that of T and E. Compression makes the pressure p and the strain of volume positive.
// - Strains are sums of the increments that the UMAT gets, and so logarithmic along a path without rotation.
// - The time of the harmonic part of a circulating load, and of a deformation gradient, runs on from step to step. It
//   begins at 0 in the first step.
// - What a remark says behind the values of a line is left out.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

using Six = std::array<double, 6>;
using SixBySix = std::array<Six, 6>;

enum class NiemunisVariables {
  cartesian,
  roscoe,           ///< p, q, z = T33 - T22, and the shear stresses; strains of volume and of shape
  roscoe_isomorph,  ///< the same by a matrix that is a rotation
  rendulic          ///< -T11, -(T22 + T33)/sqrt(2), (T33 - T22)/sqrt(2), and the shear stresses
};

/// M.
SixBySix niemunis_matrix(NiemunisVariables variables);

/// The sum of factors times quantities that ends a step where it exceeds the bound, or falls below it.
struct NiemunisExit {
  struct Term {
    double factor = 1;
    std::string quantity;  ///< a name of niemunis_quantities()
  };
  std::vector<Term> terms;
  bool above = false;
  double bound = 0;
};

/// s1, s12, e1, g12, v1, p, q, ev, ...
const std::vector<std::string>& niemunis_quantities();
/// Whether the step ends. state: shorter ones count as zero behind their end.
bool niemunis_exits(const NiemunisExit& exit, const Six& stress, const Six& strain, const std::vector<double>& state);

/// Equations of a step: on_stress dT + on_strain dE = right, of the Cartesian changes over the whole step.
struct NiemunisRestrictions {
  SixBySix on_stress{}, on_strain{};
  Six right{};
};

/// A history from a file: one increment from line to line.
struct NiemunisImport {
  std::string file;
  std::vector<Six> changes;       ///< of the variables, per increment
  std::vector<double> durations;  ///< per increment
};

struct NiemunisStep {
  enum class Kind { linear, circulating, deformation_gradient, imported, restricted };
  Kind kind = Kind::linear;
  std::string keyword;  ///< as the file has it: "*OedometricE1" is linear
  Location where;
  int increments = 1, most_iterations = 1;
  int every = 1;        ///< of the increments that are written
  double duration = 0;  ///< of the step; of an import whose file has no times, of each increment
  double temperature_change = 0;
  NiemunisVariables variables = NiemunisVariables::cartesian;
  std::array<bool, 6> is_stress{};  ///< otherwise a strain is prescribed
  Six change{};                     ///< of the variable over the step
  Six amplitude{}, phase{};         ///< of a circulating load: amplitude sin(2 pi time / duration + phase) is added
  /// F at the end of a step that begins at the identity: 11, 22, 33, 12, 21, 13, 31, 23, 32. It changes linearly.
  std::array<double, 9> gradient{};
  NiemunisRestrictions restrictions;
  NiemunisImport import;
  std::optional<NiemunisExit> exit;
};

/// The change of a variable of a linear or circulating step since its begin. begin: the time at which it began.
double niemunis_change(const NiemunisStep& step, std::size_t variable, double begin, double elapsed);

/// Steps that are repeated together.
struct NiemunisBlock {
  int repetitions = 1;
  std::vector<NiemunisStep> steps;
};

struct NiemunisFile {
  std::string file, output, heading;
  std::vector<NiemunisBlock> blocks;
};

struct NiemunisStart {
  Six stress{};
  std::optional<double> temperature;
  std::vector<double> state;
};

struct NiemunisParameters {
  std::string material;
  std::vector<double> values;
};

// These throw InputError: file, line, column. What a file imports is read too, beside it.

NiemunisFile niemunis_from_text(const std::string& text, const std::string& file);
NiemunisFile read_niemunis(const std::string& file);
NiemunisStart niemunis_start_from_text(const std::string& text, const std::string& file);
NiemunisStart read_niemunis_start(const std::string& file);
NiemunisParameters niemunis_parameters_from_text(const std::string& text, const std::string& file);
NiemunisParameters read_niemunis_parameters(const std::string& file);

/// The keywords of steps that are read, for messages.
const std::vector<std::string>& niemunis_keywords();

}  // namespace assay::drivers
