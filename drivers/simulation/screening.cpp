// SPDX-License-Identifier: BSD-3-Clause
// The stability screen of a scene's motion.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "drivers/simulation/warnings.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/stability/stability_screen.hpp"

namespace assay::drivers {

namespace {

constexpr double watched_periods = 4;

/// To three digits, never more than the value.
double rounded_down(double value) {
  if (!(value > 0)) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::floor(value / unit * (1 + 1e-12)) * unit;
}

/// What scales the motion: the vortex's peak [rad], that of the bar [m]; of any other motion its parameter, 1 as it
/// stands.
double peak_of(const Motion& motion, const Path& path) {
  const Amplitude* amplitude = motion->amplitude();
  return amplitude && path.straight() ? std::abs(amplitude->peak) : 1;
}

std::string safe_text(const ScreenFigures& screen, const std::string& of_what) {
  if (!screen.largest_safe_amplitude) return {};
  return "; largest safe amplitude " + rounded_text(*screen.largest_safe_amplitude, 3) + of_what;
}

}  // namespace

ScreenFigures screen_of(const Scene& scene, const Material& material, double end, bool quiet) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Path> paths = baseline_paths(scene);
  const double watched = std::min(end, watched_periods * scene.motion->period());
  Progress line("stability", quiet);
  const auto screened = [&](const Path& path) {
    return screen_stability(material, path, watched, [&](double share) { line.update(share); });
  };
  StabilityScreen found = screened(paths.front());
  for (std::size_t k = 1; k < paths.size(); ++k) {
    const StabilityScreen other = screened(paths[k]);
    if (other.smallest < found.smallest) found = other;
  }
  line.finish();
  const Path& path = paths.front();
  ScreenFigures figures;
  figures.verdict = word_of(found.verdict);
  figures.smallest = found.smallest;
  figures.unjudged = found.unjudged;
  if (found.verdict == StabilityScreen::Verdict::unstable) {
    figures.t = found.t;
    figures.xi = found.xi;
    if (path.name == "simple_shear") figures.gamma = 2 * path.eps(found.xi, found.t);
    if (!path.parameter_is_place) {
      figures.largest_safe_amplitude = rounded_down(found.safe_fraction * peak_of(scene.motion, path));
    }
  }
  figures.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return figures;
}

std::string instability_sentence(const ScreenFigures& screen, const std::string& material, const Units& units) {
  if (screen.verdict != "unstable") return {};
  return "this motion is not a stable solution for this model at this amplitude: " + material +
         " loses strong ellipticity at " + (screen.gamma ? "gamma = " + rounded_text(*screen.gamma, 3) + ", " : "") +
         "t = " + units.text(*screen.t, "s", 3) + ", xi = " + rounded_text(*screen.xi, 3) +
         safe_text(screen, screen.gamma ? "" : " of the path's") + " (motion.allow_unstable: true overrides)";
}

std::string refusal_sentence(const Scene& scene, const ScreenFigures& screen, const std::string& material) {
  return scene.allow_unstable ? "" : instability_sentence(screen, material, scene.units);
}

std::string screen_sentence(const ScreenFigures& screen, const Units& units) {
  if (screen.verdict == "neutral") return "neutral: nothing resists a shear wave, as in a fluid";
  const std::string smallest =
      "smallest acoustic eigenvalue " + rounded_text(*screen.smallest, 3) + " of the largest at rest";
  if (screen.verdict == "stable") {
    if (screen.unjudged == 0) return "stable: " + smallest;
    return "stable as far as it was judged: " + smallest + "; the material fails in small steps from " +
           std::to_string(screen.unjudged) + " places of the path";
  }
  return "unstable from " + (screen.gamma ? "gamma = " + rounded_text(*screen.gamma, 3) + ", " : "") +
         "t = " + units.text(*screen.t, "s", 3) + ": " + smallest + safe_text(screen, "");
}

void warn_of_instability(const Scene& scene, const Material& material, double end, bool quiet) {
  if (scene.allow_unstable) return;
  try {
    const std::string sentence =
        instability_sentence(screen_of(scene, material, end, quiet), material.name(), scene.units);
    stop_if_interrupted();
    if (!sentence.empty()) warn(sentence);
  } catch (const MaterialFailure& failure) {
    if (failure.late) throw;
  }
}

}  // namespace assay::drivers
