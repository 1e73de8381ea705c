// SPDX-License-Identifier: BSD-3-Clause
#include "bench/study_run.hpp"

#include <ctime>

#include "drivers/output/number_format.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/screening.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"

namespace assay::drivers {

Result result_of(const std::string& file, const std::vector<std::string>& sets, OutputFolder& folder) {
  Result result;
  const std::clock_t begin = std::clock();
  Problem problem = assemble(read_scene(file, sets), 1);
  const Scene& scene = problem.scene;
  result.screen = screen_of(scene, *problem.material, scene.time.end);
  result.reason = instability_sentence(*result.screen, problem.material->name());
  if (!result.reason.empty()) {
    result.outcome = "refused";
    return result;
  }
  const auto exact = exact_solution_of(scene, problem.material, scene.time.end);
  Snapshots snapshots(problem, folder);
  Progress progress(scene.title, true);
  simulate(problem, exact, snapshots, progress, result);
  result.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return result;
}

std::string text_of(const Figure& figure) { return figure ? rounded_text(*figure, 4) : ""; }

}  // namespace assay::drivers
