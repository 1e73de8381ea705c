// SPDX-License-Identifier: BSD-3-Clause
// A material point under mixed control of deformation and stress, from rest through time with error control.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/control/controlled_step.hpp"

namespace assay {

/// How a controlled history ended.
enum class ControlOutcome {
  completed,
  stopped,          ///< a stop of the control was reached
  limit_load,       ///< no deformation near by has the stress that is asked for: the rows' matrix becomes singular
  no_solution,      ///< the same, and the matrix is regular: Newton's method finds no point
  undetermined,     ///< the rows leave a deformation free
  material_failed,  ///< the model refuses
  out_of_calls,     ///< it would take more calls of the model than are allowed
  interrupted,      ///< whoever watches its progress has ended it
};
constexpr std::array<const char*, 8> names_of(ControlOutcome) {
  return {"completed",    "stopped",         "limit_load",   "no_solution",
          "undetermined", "material_failed", "out_of_calls", "interrupted"};
}

struct ControlOptions {
  double tolerance = 1e-11;  ///< error of a step relative to the largest values over the history
  /// 0: the solution of the model's equations. Else each stretch between two knots is taken in so many equal increments
  /// of the model, as a solver of increments takes it, and no error is known.
  int increments = 0;
  double increments_from = 0;  ///< from the knot at this time on; before it the solution is that of the equations [s]
  bool watch_ellipticity = true;
  bool rows_at_kinks = false;                       ///< also where the regime of the material changes
  std::int64_t most_calls = 2'000'000;              ///< of the material, by points
  std::function<void(double share)> progress = {};  ///< told of the share of the time that is done
  /// Asked between steps: the history ends where it is. Null: it goes on.
  std::function<bool()> ends = {};
};

struct ControlledRow : ControlledPoint {
  double residual = 0;  ///< of the rows of the control, in strains [1]
  double error = 0;     ///< estimated, of stress and deformation, relative to their largest
  double acoustic = 1;  ///< smallest acoustic eigenvalue over that at rest; 1 where nobody watches [1]
};

/// Where the matrix of the rows changes the sign of its determinant: another solution begins there.
struct BranchPoint {
  double t = 0;
  Tensor direction = Tensor::Zero();  ///< of q, in which the other one leaves
};

struct ControlledHistory {
  std::vector<ControlledRow> rows;  ///< at the times that were asked for, and where it ended
  ControlOutcome outcome = ControlOutcome::completed;
  std::string reason;                           ///< one sentence, where it did not complete
  Tensor direction = Tensor::Zero();            ///< of limit_load and undetermined: of q
  std::optional<MaterialFailure> failure = {};  ///< of material_failed
  std::vector<BranchPoint> branches = {};
  std::optional<double> loses_ellipticity = {};  ///< first time [s]
  Vector3 normal = Vector3::Zero();              ///< then: of the plane, in the reference configuration
  double error = 0;                              ///< sum over all steps
  std::int64_t calls = 0, steps = 0;
};

/// From rest to the end of the control. times: ascending, from 0 to the end. Throws ControlError as ControlledSteps,
/// and MaterialFailure where the material fails at rest.
ControlledHistory follow_control(const Material& material, const Control& control, std::span<const double> times,
                                 const ControlOptions& options = {});

}  // namespace assay
