// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/judge_findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/judge/changes.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/simulation/error_sampler.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/numeric/convergence.hpp"

namespace assay::drivers {

namespace {

/// Figures of fields that the run does not have are absent.
void leave_out_missing(ErrorFigures& error, const std::vector<ErrorSample>& history) {
  const auto clean = [](Figure& figure) {
    if (figure && !std::isfinite(*figure)) figure.reset();
  };
  const auto written = [&](auto member) {
    return std::ranges::any_of(history, [&](const ErrorSample& sample) { return std::isfinite((sample.*member).l2); });
  };
  for (Figure* figure : {&error.l2_half, &error.l2_end, &error.l2_max, &error.linf_max, &error.rms36_half,
                         &error.rms36_end, &error.rms36_max, &error.relative})
    clean(*figure);
  if (!written(&ErrorSample::velocity)) error.velocity = {};
  if (!written(&ErrorSample::deformation_gradient)) error.deformation_gradient = {};
  if (!written(&ErrorSample::jacobian)) error.jacobian = {};
  if (!written(&ErrorSample::stress)) error.stress = {};
}

std::string pairing_words(Pairing pairing, const Seeds& seeds) {
  switch (pairing) {
    case Pairing::reference_position:
      return "particles are told by their reference positions; " + seeds.words;
    case Pairing::id:
      return "particles are told by their ids; " + seeds.words;
    default:
      return "each particle is taken for the nearest one of the exact motion, for neither ids nor reference positions "
             "tell them: errors beyond "
             "half of the distance between particles cannot be seen; " +
             seeds.words;
  }
}

}  // namespace

JudgedGrid judged_grid(JudgedRun run, const std::vector<Label>& labels, double half_period, double end,
                       ExactParticles& exact, std::optional<BinnedErrors> bins, std::vector<std::string>& warnings) {
  JudgedGrid grid;
  grid.name = run.name;
  grid.frames = static_cast<std::int64_t>(run.frames.size());
  grid.read =
      map_words(run.map) + (run.unread.empty() ? "" : "; not read, for no map names them: " + joined(run.unread));
  grid.times = run.time_words;
  grid.left_out = run.left_out;
  for (const Label& label : labels) grid.labels.push_back({label.cause, label.sentence, label.before, label.after});
  const Seeds seeds = seeds_of(run, exact);
  const Pairing pairing = pairing_of(run, seeds);
  grid.particles = static_cast<std::int64_t>(seeds.X.size());
  grid.h = grid.spacing = seeds.spacing;
  grid.rounding = run.rounding;
  grid.pairing = pairing_words(pairing, seeds);
  grid.by_nearest = pairing == Pairing::nearest;
  double largest = 0;
  double stress = 0, stress_error = 0;
  for (const FrameErrors& frame : errors_of(run, seeds, pairing, exact, bins ? &*bins : nullptr)) {
    const auto most = [](std::int64_t& figure, std::size_t found) {
      figure = std::max(figure, static_cast<std::int64_t>(found));
    };
    most(grid.lost, frame.pairs.lost), most(grid.doubled, frame.pairs.doubled);
    most(grid.unknown, frame.pairs.unknown), most(grid.not_numbers, frame.pairs.not_numbers);
    most(grid.measured, frame.measured);
    const bool whole = frame.pairs.lost + frame.pairs.doubled + frame.pairs.unknown + frame.pairs.not_numbers == 0;
    if (!whole && !grid.lost_from) grid.lost_from = frame.sample.t;
    if (!grid.history.empty() && frame.sample.t == grid.history.back().t)
      warnings.push_back(run.name + ": two frames have the time " + rounded_text(frame.sample.t, 6) + " s");
    largest = std::max(largest, frame.exact_displacement);
    if (frame.sample.t == 0 && frame.exact_velocity > 0 && frame.velocity > 0)
      grid.start = frame.sample.velocity.l2 / frame.exact_velocity;
    stress = std::max(stress, frame.exact_stress);
    stress_error = std::max(stress_error, frame.sample.stress.l2);  // not a number where none is written
    if (!grid.worst || frame.worst > *grid.worst) {
      grid.worst = frame.worst, grid.worst_t = frame.sample.t, grid.worst_id = frame.worst_id;
      grid.worst_X.assign(frame.worst_X.data(), frame.worst_X.data() + exact.dimension());
    }
    grid.history.push_back(frame.sample);
  }
  const auto largest_error = std::ranges::max_element(grid.history, {}, [](const ErrorSample& sample) {
    return std::isfinite(sample.displacement.l2) ? sample.displacement.l2 : -1;
  });
  if (exact.dimension() == 2 && largest_error != grid.history.end() && std::isfinite(largest_error->displacement.l2)) {
    const ParticleFrame picture =
        picture_of(run.frames[static_cast<std::size_t>(largest_error - grid.history.begin())], seeds, pairing, exact);
    if (!picture.x.empty()) grid.picture = png_of(picture);
    grid.picture_caption = "Error of the positions where it is largest, " + picture.caption + ", on the finest grid.";
  }
  if (stress > 0 && stress_error > 0) grid.relative_stress = stress_error / stress;
  grid.bins = std::move(bins);
  grid.error = figures_of(grid.history, half_period, end, largest);
  leave_out_missing(grid.error, grid.history);
  const bool several_at_one = grid.lost + grid.doubled + grid.unknown > 0;  // which is what the nearest ones are then
  grid.is_beyond_sight =
      grid.by_nearest && (several_at_one || grid.error.l2_max.value_or(0) > seen_by_nearest * seeds.spacing);
  if (only_at_rest(run, half_period)) {
    grid.error.relative.reset();  // to a motion that is nearly back
    warnings.push_back(
        run.name +
        ": there is no frame between a fifth of the period and four fifths of it. At t = 0 and T a body that "
        "never moved has no error");
  }
  constexpr double nearly = 0.98;  // of the scene's time: the last frame may lie a step before the end
  if (const double last = grid.history.back().t; last < nearly * end) {
    grid.labels.push_back(
        {"ends_early",
         "the last frame is that of t = " + rounded_text(last, 4) + " s, and the scene ends at " +
             rounded_text(end, 4) +
             " s: errors beyond are not seen. If that is intended: `--set time.end=" + rounded_text(last, 6) + "`",
         {},
         {}});
  }
  constexpr double hidden = 10;  // of the rounding, an error of this size is no longer the code's own
  if (grid.error.l2_max && *grid.error.l2_max < hidden * run.rounding)
    warnings.push_back(run.name + ": the positions are written with an error of " + rounded_text(run.rounding, 2) +
                       " m, and that is most of what is measured. Write more digits");
  return grid;
}

std::string judge_json(const JudgeFindings& findings) {
  return json_document(JsonFields<nlohmann::ordered_json>::of(findings));
}

}  // namespace assay::drivers
