// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/response_source.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "drivers/simulation/sheet_cache.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

namespace {

constexpr double most_periods = 1000;  ///< of a sheet in time, and of one history

std::shared_ptr<const Response> closed_form_of(const Scene& scene, const std::shared_ptr<const Material>& material,
                                               const Path& path) {
  auto form = ClosedForm::of(material, path);
  if (!form) {
    refuse(scene, "force.response", "material '" + material->name() + "' offers no closed form of " + path.name,
           "sheet, shadow, none");
  }
  return std::make_shared<const Response>(std::move(*form));
}

}  // namespace

std::shared_ptr<const Response> response_of(const Scene& scene, const std::shared_ptr<const Material>& material,
                                            const Path& path, double end, const ResponseMaking& how) {
  if (scene.force.response == ForceChoice::Response::closed_form) return closed_form_of(scene, material, path);
  if (how.marching && scene.force.response == ForceChoice::Response::shadow) {
    const ShadowOptions options{scene.force.radii, scene.force.tolerance, end, {how.threads, stop_if_interrupted}};
    return std::make_shared<const Response>(std::make_shared<Shadow>(material, path, options));
  }
  const bool curve = material->path_independent() && path.straight();
  if (!curve && end > most_periods * scene.motion->period()) {
    refuse(scene, "time.end",
           "the sheet of a material with history holds at most " + rounded_text(most_periods, 6) + " periods");
  }
  SheetOptions options{.tolerance = scene.force.tolerance, .end = end};
  options.workers = {how.threads, stop_if_interrupted};
  SheetLine line(options.tolerance, how.quiet);
  options.report = [&line](const SheetProgress& now) { line.update(now); };
  std::optional<SheetCache> cache;
  if (!curve && scene.force.cache) cache.emplace(scene, *material, path, end);
  if (std::optional<Sheet> kept = cache ? cache->load() : std::nullopt)
    return std::make_shared<const Response>(std::move(*kept));
  Sheet sheet(*material, path, options);
  line.end();
  if (cache) cache->store(sheet);
  return std::make_shared<const Response>(std::move(sheet));
}

namespace {

/// Of a polar motion and of the one in the unit box; null of those whose F is the same everywhere.
ExactSolutionPtr solution_of_places(const Scene& scene, const std::shared_ptr<const Material>& material,
                                    const Path& path, double end, const ResponseMaking& how) {
  const double density = scene.material.density;
  if (scene.motion->polar())
    return exact_polar(scene.motion, density, response_of(scene, material, path, end, how), path.initial_cauchy);
  if (const auto* vortex = scene.motion.as<Vortex3d>())
    return exact_meridian(*vortex, density, response_of(scene, material, path, end, how));
  const auto* box = scene.motion.as<AxisAligned>();
  if (!box) return nullptr;
  return exact_box(*box, density, material,
                   {.tolerance = scene.force.tolerance,
                    .end = end,
                    .direction = path.material_direction,
                    .initial_cauchy = path.initial_cauchy});
}

/// For single points at any times, each as exact as it can be. The unit box has histories around each point. A motion
/// whose F is the same everywhere has one on its own path, xi = own_parameter(), unless a closed form is asked for.
ExactSolutionPtr exact_solution_at_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                          double end, const ResponseMaking& how) {
  const Path path = baseline_path(scene);
  const double density = scene.material.density;
  if (auto found = solution_of_places(scene, material, path, end, how)) return found;
  if (scene.force.response == ForceChoice::Response::closed_form) {
    const auto P = [form = response_of(scene, material, path, end), xi = scene.motion->own_parameter()](double t) {
      Tensor tau, slope;
      form->at(xi, t, tau, slope);
      return tau;
    };
    return exact_uniform(scene.motion, density, P);
  }
  if (!material->is_function_of_F() && end > most_periods * scene.motion->period()) {
    refuse(scene, "time.end", "a history holds at most " + rounded_text(most_periods, 6) + " periods");
  }
  constexpr double of_step = 1e-13;
  return exact_uniform(scene.motion, density, material, path, end, of_step);
}

/// Of a point that the scene's frame sees [m].
double radius_of(const Scene& scene, const Vector3& seen) {
  const Vector3 X = scene.frame ? scene.frame->body_point(seen) : seen;
  return std::hypot(X.x(), X.y());
}

}  // namespace

ExactSolutionPtr as_seen(const Scene& scene, const ExactSolutionPtr& own) {
  return scene.frame ? seen_from(*scene.frame, own) : own;
}

ExactSolutionPtr exact_solution_of(const Scene& scene, const std::shared_ptr<const Material>& material, double end,
                                   const ResponseMaking& how) {
  const Path path = baseline_path(scene);
  const bool in_box = scene.motion.as<AxisAligned>();
  if (in_box && scene.force.response != ForceChoice::Response::sheet) {
    refuse(scene, "force.response", "the motion in the unit box is run by a series of its own, which sheet stands for",
           "sheet, none");
  }
  ResponseMaking marching = how;
  marching.marching = true;
  if (auto found = solution_of_places(scene, material, path, end, marching)) {
    if (in_box && scene.dimension == 2) found->source();  // makes the series before the run begins
    return found;
  }
  constexpr double of_step = 1e-4;  // of what is asked of the whole
  return exact_uniform(scene.motion, scene.material.density, material, path, end,
                       std::max(1e-13, of_step * scene.force.tolerance));
}

bool is_within_motion(const Scene& scene, const Vector3& X) {
  constexpr double edge_rounding = 1e-9;  // of a radius: points on the ring's edges are in the ring
  const auto ring = ring_of(scene.motion);
  if (!ring || is_vortex(scene.motion)) return true;
  const double R = radius_of(scene, X);
  return R >= ring->inner * (1 - edge_rounding) && R <= ring->outer * (1 + edge_rounding);
}

void require_within_motion(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file) {
  if (const auto ring = ring_of(scene.motion); ring && !is_vortex(scene.motion)) {
    for (const ReferencePoint& point : points) {
      const Vector3 middle(point.X, point.Y, point.Z), half(point.HX, point.HY, point.HZ);
      bool inside = true;
      for (const double x : {-1, 1}) {
        for (const double y : {-1, 1}) {
          for (const double z : {-1, 1})  // a corner of its box
            inside &= is_within_motion(scene, middle + half.cwiseProduct(Vector3(x, y, z)));
        }
      }
      if (inside) continue;
      throw InputError({file, point.line, 1}, "X",
                       "the point is at the radius " + rounded_text(radius_of(scene, middle), 6) +
                           (point.HX > 0 ? ", and its box reaches out" : ", outside") + " of the ring between " +
                           rounded_text(ring->inner, 6) + " and " + rounded_text(ring->outer, 6));
    }
  }
  const auto* table = scene.motion.as<DeformationTable>();
  for (const ReferencePoint& point : points) {
    if (!table || point.t <= table->last()) continue;
    throw InputError({file, point.line, 1}, "t",
                     "beyond the last row of motion.path, " + rounded_text(table->last(), 6));
  }
}

ExactSolutionPtr exact_solution_of_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                          double end, bool quiet, int threads) {
  return as_seen(scene, exact_solution_at_points(scene, material, end, {.threads = threads, .quiet = quiet}));
}

ExactSolutionPtr motion_alone(const Scene& scene, const std::shared_ptr<const Material>& material) {
  const double density = scene.material.density;
  if (scene.motion->polar()) return as_seen(scene, exact_polar(scene.motion, density, nullptr));
  if (const auto* vortex = scene.motion.as<Vortex3d>())
    return as_seen(scene, exact_meridian(*vortex, density, nullptr));
  if (const auto* box = scene.motion.as<AxisAligned>()) return as_seen(scene, exact_box(*box, density, material, {}));
  return as_seen(scene, exact_uniform(scene.motion, density, [](double) -> Tensor { return Tensor::Zero(); }));
}

std::string long_sheet_sentence(double seconds, double tolerance) {
  constexpr double usual = 1e-10, coarser = 1e3;
  const double other = std::min(std::max(tolerance, usual) * coarser, ForceChoice::coarsest_tolerance);
  const std::string remedy = other > tolerance ? "force.tolerance: " + rounded_text(other, 2) + " in place of " +
                                                     rounded_text(tolerance, 2) + ", or with a smaller time.end"
                                               : "a smaller time.end";
  return "to tabulate this material's response may take up to " + duration_text(seconds) +
         ", often a third of it or less; shorter with " + remedy;
}

SheetLine::SheetLine(double tolerance, bool quiet) : tolerance_(tolerance), quiet_(quiet), progress_("sheet", quiet) {}

void SheetLine::update(const SheetProgress& now) {
  using Stage = SheetProgress::Stage;
  foresee(now);
  const double share = now.planned > 0 ? now.done / now.planned : 0;
  progress_.update(share, now.stage == Stage::bands       ? "looking for kinks"
                          : now.stage == Stage::histories ? "following histories"
                                                          : "measuring its error");
}

void SheetLine::foresee(const SheetProgress& now) {
  if (quiet_ || now.stage != SheetProgress::Stage::histories) return;
  if (behind_ < 0) begin_ = Clock::now(), behind_ = now.done;
  const double planned = now.planned - behind_;
  const auto seconds = forecast_.told(elapsed_s(), planned > 0 ? (now.done - behind_) / planned : 0);
  if (!seconds) return;
  progress_.finish();
  std::fprintf(stderr, "%s\n", long_sheet_sentence(*seconds, tolerance_).c_str());
}

double SheetLine::elapsed_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

void SheetLine::end() {
  progress_.finish();
  if (forecast_.was_told())
    std::fprintf(stderr, "the response is tabulated, in %s\n", duration_text(elapsed_s()).c_str());
}

std::optional<double> Forecast::told(double elapsed_s, double share) {
  constexpr double enough_s = 5, long_s = 30, least_more = 1.5;
  if (elapsed_s < std::max(enough_s, told_s_) || !(share > 0)) return std::nullopt;
  const double expected_s = elapsed_s / share;
  if (expected_s < long_s) return std::nullopt;
  told_s_ = std::max(expected_s, least_more * elapsed_s);
  return told_s_;
}

}  // namespace assay::drivers
