// SPDX-License-Identifier: BSD-3-Clause
// Where a scene's response tau(xi, t) comes from: the material's closed form, a sheet from disk, a new one;
// and the exact solution that is made of it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/output/point_reader.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/system/progress.hpp"
#include "harness/exact/exact_fields.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay::drivers {

/// How a response is made.
struct ResponseMaking {
  int threads = 1;
  bool marching = false;  ///< times are asked for in ascending order
  bool quiet = true;      ///< nothing is said of how far it is
};

/// The response that the scene asks for, over times 0 .. end. Shadow points only where times ascend; else a sheet
/// stands in. Throws InputError (no closed form), MaterialFailure, Interrupted.
std::shared_ptr<const Response> response_of(const Scene& scene, const std::shared_ptr<const Material>& material,
                                            const Path& path, double end, const ResponseMaking& how = {});

/// The scene's motion with the stress of its material, over times 0 .. end; the rest as above.
ExactSolutionPtr exact_solution_of(const Scene& scene, const std::shared_ptr<const Material>& material, double end,
                                   const ResponseMaking& how = {});

/// The solution in the scene's frame.
ExactSolutionPtr as_seen(const Scene& scene, const ExactSolutionPtr& own);

/// Whether the motion is defined at a reference point, as the scene's frame sees it: of a ring that widens in it alone.
bool is_within_motion(const Scene& scene, const Vector3& X);

/// Throws InputError where a point's time lies beyond the last row of motion.path, or the point outside a twisting
/// ring.
void require_within_motion(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file);

/// Of the scene's exact motion for single points at times 0 .. end, each as exact as it can be, as the scene's frame
/// sees it. Throws InputError, MaterialFailure, Interrupted. quiet: no terminal shows how far it is.
ExactSolutionPtr exact_solution_of_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                          double end, bool quiet = true, int threads = 1);

/// The same where no stress is asked for: nothing is tabulated.
ExactSolutionPtr motion_alone(const Scene& scene, const std::shared_ptr<const Material>& material);

// What a terminal shows while a sheet is made, and what is said before a long one.

/// Of a sheet that is expected to take so long, at that tolerance: what makes it shorter.
std::string long_sheet_sentence(double seconds, double tolerance);

/// How long work may take in all [s], where that is to be told now: at first where it is long, again where it takes
/// longer than was told. elapsed_s, share: of the work until now.
class Forecast {
 public:
  std::optional<double> told(double elapsed_s, double share);
  bool was_told() const { return told_s_ > 0; }

 private:
  double told_s_ = 0;
};

class SheetLine {
 public:
  SheetLine(double tolerance, bool quiet);
  SheetLine(const SheetLine&) = delete;
  SheetLine& operator=(const SheetLine&) = delete;

  void update(const SheetProgress& now);

  /// Behind the last update: whoever was told of a long time is told of its end.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  void foresee(const SheetProgress& now);
  double elapsed_s() const;

  double tolerance_;
  bool quiet_;
  Forecast forecast_;
  Progress progress_;
  Clock::time_point begin_ = {};  ///< of the histories
  double behind_ = -1;            ///< histories that were followed then; below 0: none is yet
};

}  // namespace assay::drivers
