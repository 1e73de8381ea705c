// SPDX-License-Identifier: BSD-3-Clause
// The vortex with the material that is checked, beside one of the same stiffness.
#include <algorithm>
#include <array>
#include <filesystem>

#include "adapters/foreign/foreign_state.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/check/judge.hpp"
#include "harness/check/specimen.hpp"
#include "harness/check/symmetry_class.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

using check::TestResult;
using check::Verdict;

constexpr double spacing = 0.05;  // h [m]: 5032 particles
constexpr double most = 5;        // times the error of the comparison; good models: 1 to 5
constexpr double enough = 0.5;    // relative error of the displacement; good models: 0.02 to 0.16
constexpr double patience_s = 5;  // of one run, estimated
constexpr double most_s = 30;     // of the material's run; usual ones take one
constexpr double usual_steps = 400;
constexpr double strain_of_a_radian = 3.6;  // largest eps of the paper's vortex

/// The paper's ring and profile, at a strain that the material stands.
Scene scene_of(const MaterialChoice& choice, double density, double amplitude) {
  Scene scene;
  scene.title = "check";
  Vortex vortex;
  vortex.amplitude.peak = std::min(0.1, amplitude / strain_of_a_radian);
  scene.motion = vortex;
  scene.allow_unstable = true;
  scene.material = choice;
  scene.material.density = density;
  scene.grid = GridChoice{};
  scene.grid->spacing = spacing;
  scene.method = Method{};
  scene.time.step = 0.008;  // [s]: courant 0.25 of waves of 1.16 m/s
  scene.force.response = ForceChoice::Response::shadow;
  scene.force.radii = 100;
  scene.force.tolerance = 1e-3;
  scene.output = {.errors = 50, .particles = 0, .pictures = false, .report = false, .accounts = false};
  return scene;
}

Result run_of(const Scene& scene) {
  Result result;
  Problem problem = assemble(scene, 1);
  const auto exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  OutputFolder folder(std::filesystem::temp_directory_path() / hidden_name());
  Snapshots snapshots(problem, folder);
  Progress progress("", true);
  simulate(problem, exact, snapshots, progress, result);
  return result;
}

/// Relative error of the displacement; null where the run did not complete.
std::optional<double> error_of(const MaterialChoice& choice, const check::Specimen& specimen) {
  const double density = specimen.stiffness(0, 0) / 1.346;  // waves as fast as the paper's, 1.16 m/s
  try {
    const Result result = run_of(scene_of(choice, density, specimen.amplitude));
    return result.outcome == "completed" ? result.error.relative : std::nullopt;
  } catch (const MaterialFailure&) {
    return std::nullopt;
  }
}

/// Neo-Hookean elasticity of that stiffness at rest; none of a fluid.
std::optional<MaterialChoice> comparison(const check::Stiffness& C) {
  const double G = (C(0, 0) - C(0, 1)) / 2, K = (C(0, 0) + 2 * C(0, 1)) / 3;
  if (!(G > 1e-3 * K) || !(K > 0)) return std::nullopt;
  constexpr double least = 1e-300, largest = 1e300;  // that the parameter may be [Pa]
  const double E = 9 * K * (G / (3 * K + G));
  if (!(E >= least && E <= largest)) return std::nullopt;
  MaterialChoice choice;
  choice.adapter = "neo_hookean";
  choice.parameters = {{"E", E}, {"nu", (3 * K - 2 * G) / (2 * (3 * K + G))}};
  return choice;
}

/// Seconds that a run would spend in the material, by the median of some calls: another program that takes the
/// processor meanwhile lengthens one or two.
double estimated_s(const Material& material, const check::Specimen& specimen) {
  constexpr std::size_t calls = 21;
  std::array<double, calls> taken;
  std::vector<double> state = specimen.rest_state();
  for (std::size_t k = 0; k < calls; ++k) {
    const double t = 0.01 * static_cast<double>(k);
    const Stopwatch watch;
    state = check::stepped(material, t, 0.01, specimen.space.stretch(specimen.amplitude, t),
                           specimen.space.stretch(specimen.amplitude, t + 0.01), state)
                .state;
    taken[k] = watch.seconds();
  }
  std::nth_element(taken.begin(), taken.begin() + calls / 2, taken.end());
  constexpr double particles = 5032;
  return taken[calls / 2] * particles * usual_steps;
}

TestResult untold(const std::string& why) { return not_applicable(vortex_test, why); }

TestResult judged(double error, std::optional<double> other, std::optional<double> ellipticity) {
  const double threshold = std::max(enough, most * other.value_or(0));
  const std::string figures =
      "the vortex on a coarse grid: displacements within " + rounded_text(100 * error, 2) + " % of the exact ones" +
      (other ? ", " + rounded_text(100 * *other, 2) + " % for neo-Hookean elasticity of the same stiffness" : "");
  if (!(error <= threshold) && !(ellipticity && *ellipticity > 0))
    return untold(figures + "; it may not be a stable motion");
  TestResult result = check::judged(error, threshold, figures, check::causes::other_stress, figures);
  result.id = vortex_test;
  return result;
}

}  // namespace

TestResult end_to_end_vortex(const ResolvedMaterial& resolved, std::optional<double> ellipticity) {
  const Material& material = resolved.material;
  if (resolved.foreign && adapters::is_of_plane_stress(*resolved.foreign)) return untold("the vortex is plane strain");
  if (!check::serves_ring(material)) return untold("the vortex needs isotropy about its axis");
  std::optional<check::Specimen> specimen;
  try {
    specimen = check::examine(material, {});
    if (specimen->rest_pressure() > 0) return untold("the vortex begins without stress");
    if (!(specimen->stiffness(0, 0) > 0)) return untold("the material has no stiffness at rest");
    if (estimated_s(material, *specimen) > patience_s) return untold("the material takes too long for a run");
  } catch (const std::runtime_error&) {
    return untold("the material cannot be loaded");
  }
  std::optional<double> error;
  try {
    const Deadline deadline(most_s);
    error = error_of(resolved.choice, *specimen);
  } catch (const TimeIsUp&) {
    return untold("the run takes more than " + rounded_text(most_s, 2) +
                  " s of processor time: the material needs too many small steps");
  }
  const auto twin = comparison(specimen->stiffness);
  const std::optional<double> other = twin ? error_of(*twin, *specimen) : std::nullopt;
  if (twin && !other) return untold("the method is unstable in the vortex at this resolution and stiffness");
  if (!error) return untold("the run did not complete: not a stable motion for the material at this strain");
  return judged(*error, other, ellipticity);
}

}  // namespace assay::drivers
