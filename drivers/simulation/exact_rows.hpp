// SPDX-License-Identifier: BSD-3-Clause
// Exact values at blocks of reference points, as `eval` writes them.
#pragma once

#include <list>
#include <vector>

#include "drivers/output/point_columns.hpp"
#include "drivers/simulation/box_forces.hpp"
#include "harness/exact/places.hpp"

namespace assay::drivers {

/// What must be computed for some columns.
struct RowNeeds {
  bool motion = false, stress = false;  ///< at the points
  bool box = false;
  bool response() const { return stress || box; }  ///< of the material
  /// boxes: b is a mean over them.
  RowNeeds(const std::vector<PointColumn>& columns, bool boxes);
};

class ExactRows {
 public:
  struct Choice {
    double density = 0;  ///< rho0 [kg/m^3]
    bool three = false, boxes = false;
    bool is_static = false;  ///< b is -DIV(P)/rho0
  };
  ExactRows(ExactSolutionPtr solution, std::vector<PointColumn> columns, const Choice& choice);

  /// Writes the columns of each point in the block's order, [point * columns + column]. Points of one time are asked
  /// together, and the last few times are kept. Throws MaterialFailure, Interrupted. between: as of ExactSolution.
  void evaluate(const std::vector<ReferencePoint>& block, std::vector<double>& values,
                const ExactSolution::Between& between);

 private:
  struct Slice {
    double t;
    std::unique_ptr<const ExactSlice> slice;
  };
  struct Places {
    std::vector<Vector3> X;
    std::unique_ptr<const ExactPlaces> places;
  };
  FieldViews wanted_of(PointFields* first) const;
  void exact_values(const std::vector<ReferencePoint>& block, const ExactSolution::Between& between);
  void evaluate_at(double t, const std::vector<Vector3>& X, const FieldViews& out);
  double value(const PointColumn& column, const ReferencePoint& point, std::size_t i) const;

  ExactSolutionPtr solution_;
  std::vector<PointColumn> columns_;
  Choice choice_;
  RowNeeds needs_;
  std::list<Slice> slices_;   ///< the latest first
  std::list<Places> places_;  ///< likewise: many tables have the same points at each time
  std::vector<PointFields> fields_;
  std::vector<BoxForce> over_boxes_;
};

}  // namespace assay::drivers
