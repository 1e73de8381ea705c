// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/response_source.hpp"

#include <algorithm>

#include "drivers/simulation/sheet_cache.hpp"
#include "drivers/simulation/sheet_line.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/number_format.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"

namespace assay::drivers {

namespace {

constexpr double most_periods = 1000;  ///< of a sheet in time, and of one history

std::shared_ptr<const Response> closed_form_of(const Scene& scene, const std::shared_ptr<const Material>& material,
                                               const Path& path) {
  auto form = ClosedForm::of(material, path);
  if (!form) {
    throw InputError(scene.place("force.response"), "force.response",
                     "material '" + material->name() + "' offers no closed form of " + path.name,
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
  if (!curve && end > most_periods * period_of(scene.motion)) {
    throw InputError(
        scene.place("time.end"), "time.end",
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

BoxOptions box_options(const Scene& scene, const Path& path, double end) {
  return {.tolerance = scene.force.tolerance, .end = end, .direction = path.material_direction};
}

}  // namespace

ExactSolutionPtr exact_solution_of(const Scene& scene, const std::shared_ptr<const Material>& material, double end,
                                   const ResponseMaking& how) {
  const Path path = baseline_path(scene);
  const double density = scene.material.density;
  if (scene.motion->polar()) {
    ResponseMaking marching = how;
    marching.marching = true;
    return exact_polar(scene.motion, density, response_of(scene, material, path, end, marching));
  }
  if (const auto* box = scene.motion.as<AxisAligned>()) {
    if (scene.force.response != ForceChoice::Response::sheet) {
      throw InputError(scene.place("force.response"), "force.response",
                       "the motion in the unit box is run by a series of its own, which sheet stands for",
                       "sheet, none");
    }
    ExactSolutionPtr solution = exact_box(*box, density, material, box_options(scene, path, end));
    solution->source();  // makes the series before the run begins
    return solution;
  }
  constexpr double of_step = 1e-4;  // of what is asked of the whole
  return exact_uniform(scene.motion, density, material, path, end, std::max(1e-13, of_step * scene.force.tolerance));
}

ExactSolutionPtr exact_solution_at_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                          double end, bool quiet) {
  const Path path = baseline_path(scene);
  const double density = scene.material.density;
  const auto own = [&]() -> ExactSolutionPtr {
    if (scene.motion->polar())
      return exact_polar(scene.motion, density, response_of(scene, material, path, end, {.quiet = quiet}));
    if (const auto* box = scene.motion.as<AxisAligned>())
      return exact_box(*box, density, material, box_options(scene, path, end));
    if (scene.force.response == ForceChoice::Response::closed_form) {
      const auto P = [form = response_of(scene, material, path, end), xi = own_parameter(scene.motion)](double t) {
        Tensor tau, slope;
        form->at(xi, t, tau, slope);
        return tau;
      };
      return exact_uniform(scene.motion, density, P);
    }
    if (!material->is_function_of_F() && end > most_periods * period_of(scene.motion)) {
      throw InputError(scene.place("time.end"), "time.end",
                       "a history holds at most " + rounded_text(most_periods, 6) + " periods");
    }
    constexpr double of_step = 1e-13;
    return exact_uniform(scene.motion, density, material, path, end, of_step);
  };
  return scene.frame ? seen_from(*scene.frame, own()) : own();
}

}  // namespace assay::drivers
