// SPDX-License-Identifier: BSD-3-Clause
// Mistakes of the code behind the errors of its runs.
#include <algorithm>
#include <cmath>

#include "drivers/judge/judge_findings.hpp"
#include "drivers/mistakes/perturbed_scene.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"

namespace assay::drivers {

namespace {

constexpr double nothing = 1e-9;  ///< an error [m], or of the motion

/// Shares of the square of the errors over all frames.
std::vector<double> shares_of_waves(const BinnedErrors& errors) {
  double whole = 0;
  std::vector<double> shares(waves, 0);
  for (std::size_t k = 0; k < errors.square.size(); ++k) {
    whole += errors.square[k];
    for (std::size_t m = 0; m < waves; ++m) shares[m] += errors.of_wave[k][m];
  }
  for (double& share : shares) share = whole > 0 ? share / whole : 0;
  return shares;
}

/// Where most of an error goes around the ring so many times; 0: nowhere.
std::size_t loudest_wave(const std::vector<double>& shares) {
  constexpr double most = 0.5;
  for (std::size_t m = 1; m < shares.size(); ++m) {
    if (shares[m] > most) return m;
  }
  return 0;
}

std::string words_of_wave(std::size_t wave) {
  const std::string turns = wave == 1 ? "once" : std::to_string(wave) + " times";
  const char* cause = wave == 1       ? ", as of a force of one direction or a shifted origin"
                      : wave % 4 == 0 ? ", as of a square lattice"
                                      : ", as of axes that are treated in different ways";
  return "the error stays on finer grids and goes around the ring " + turns + cause;
}

/// What is left where the difference of the best mistake is taken away.
void take_history(const CauseError& error, const CauseCandidate& best, CodeFindings& code) {
  for (std::size_t k = 0; k < best.frames; ++k) {
    double of_bins = 0, left = 0;
    for (std::size_t b = 0; b < error.X.size(); ++b) {
      of_bins += error.weight[b] * error.e[k][b].squaredNorm();
      left += error.weight[b] * (error.e[k][b] - best.difference[k][b]).squaredNorm();
    }
    code.t.push_back(error.t[k]);
    code.of_error.push_back(std::sqrt(error.square[k]));
    code.of_rest.push_back(std::sqrt(std::max(0.0, error.square[k] - of_bins + left)));
  }
}

/// Where the body has flown apart nothing is told any more. size: of the body [m].
void cut(CauseError& error, double size) {
  std::size_t frames = 0;
  while (frames < error.square.size() && error.square[frames] < size * size) ++frames;
  error.t.resize(frames), error.e.resize(frames), error.square.resize(frames);
}

}  // namespace

void find_mistakes(JudgeFindings& findings, const Scene& scene, const std::shared_ptr<const Material>& material,
                   bool quiet) {
  std::vector<MeasuredErrors> measured;
  for (const JudgedGrid& run : findings.runs) {
    if (run.bins && !run.bins->square.empty()) measured.push_back({run.h.value_or(0), *run.bins});
  }
  if (measured.empty()) return;
  const ErrorFigures& finest = findings.runs.back().error;
  if (!finest.l2_max || *finest.l2_max < nothing) return;
  if (finest.relative && std::abs(*finest.relative - 1) < nothing) return;  // a body that never moved
  CodeFindings& code = findings.code_findings;
  if (findings.runs.back().is_beyond_sight) {
    code.answer = word_of(Identification::Answer::unknown);
    code.sentence = "mistakes of a code are told by errors of known particles: write ids or reference positions";
    return;
  }
  CauseError error = cause_error_of(measured);
  if (ring_of(scene.motion)) code.waves = shares_of_waves(measured.back().errors);
  const auto ring = ring_of(scene.motion);
  const double size = ring ? ring->outer : scene.body.upper[0] - scene.body.lower[0];
  cut(error, size);
  constexpr std::size_t history = 4;  // a start and a history
  if (error.t.size() < history) {
    code.answer = word_of(Identification::Answer::unknown);
    code.sentence = "mistakes of a code are told by their history: that needs frames at four times or more";
    return;
  }
  PerturbedProblem problem = perturbed_problem(scene, material, error.t.back());
  Progress progress("comparing with known mistakes", quiet);
  const auto between = [&](double share) {
    stop_if_interrupted();
    progress.update(share);
  };
  const auto found_in = [&](const CauseError& of) {
    return is_beyond_the_grid(of)
               ? identified(of, problem, perturbed_motions(scene, problem, measured.back().errors, of.t), between)
               : of_the_method(of);
  };
  const auto of_finest = [&] {
    CauseError alone = cause_error_of({measured.back()});
    cut(alone, size);
    alone.coarser = error.coarser, alone.refined = error.refined;
    alone.discretisation =
        std::max(alone.discretisation, error_of_grid(scene, problem, measured.back().errors, measured.back().h));
    return alone;
  };
  const bool of_ladder = stays(error);
  if (!error.from_ladder) error = of_finest();
  Identification found = found_in(error);
  if (error.from_ladder && !found.is_wrong()) {
    // A coarse grid that is very wrong tells nothing of the fine one, which may tell a mistake alone.
    CauseError alone = of_finest();
    Identification of_fine = found_in(alone);
    const bool hidden = found.answer == Identification::Answer::method && is_beyond_the_grid(alone);
    if (hidden || of_fine.is_wrong()) found = std::move(of_fine), error = std::move(alone);
  }
  if (found.answer == Identification::Answer::unknown && is_beyond_the_grid(error)) {
    // Codes that know current positions alone make their mistakes in another way.
    problem.force_at_current_position = true;
    Identification there = found_in(error);
    if (there.is_wrong()) found = std::move(there), found.sentence += ". The code takes b at current positions";
  }
  if (const std::size_t wave = loudest_wave(code.waves); wave > 0 && !found.is_wrong() && of_ladder) {
    found.answer = Identification::Answer::unknown;
    found.sentence = words_of_wave(wave);
  }
  const auto of_the_start = [&] {
    const auto named = found.candidates.begin();
    return std::any_of(
        named, named + static_cast<std::ptrdiff_t>(std::max<std::size_t>(found.alike, 1)),
        [](const CauseCandidate& each) { return each.family->name == std::string_view("initial_velocity"); });
  };
  if (found.is_wrong() && starts_otherwise(findings) && !of_the_start()) {
    found.answer = Identification::Answer::unknown;
    found.sentence =
        "the velocities at t = 0 are not those of the scene: its amplitude, period or radii, or the initial velocity. "
        "Mistakes of a force are told from a right start";
  }
  code.answer = word_of(found.answer);
  code.sentence = found.sentence;
  if (found.answer == Identification::Answer::method && is_vortex(scene.motion))
    code.sentence +=
        ". A vortex keeps its volume, so a wrong bulk modulus is not seen: homogeneous_traction of the standard set "
        "shows it";
  code.error = error.error, code.discretisation = error.discretisation;
  for (std::size_t k = 0; k < found.candidates.size(); ++k) {
    const CauseCandidate& each = found.candidates[k];
    const bool named = code.is_wrong() && k < found.alike;
    code.mistakes.push_back({each.family->name, each.words(), named, each.size, each.explained, each.factor});
  }
  if (!found.candidates.empty()) take_history(error, found.candidates.front(), code);
}

}  // namespace assay::drivers
