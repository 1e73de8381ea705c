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
  grid.bins = std::move(bins);
  grid.error = figures_of(grid.history, half_period, end, largest);
  leave_out_missing(grid.error, grid.history);
  grid.is_beyond_sight = grid.by_nearest && grid.error.l2_max.value_or(0) > seen_by_nearest * seeds.spacing;
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

namespace {

FlatValue figure_for(const JudgeFindings& findings, const std::string& key) {
  const auto of = [](const Figure& value) { return value ? FlatValue(*value) : FlatValue(); };
  if (key == order_key) return of(findings.order);
  if (key == last_order_key) return of(findings.last_order);
  if (findings.runs.empty()) return {};
  Result finest;
  finest.error = findings.runs.back().error;
  const auto all = flatten(finest);
  const auto found = all.find(key);
  return found == all.end() ? FlatValue() : found->second;
}

constexpr const char* beyond_sight =
    "the errors cannot be measured: each particle was taken for the nearest one, and they are as large as the distance "
    "between particles lets them look. Write ids or reference positions";

}  // namespace

void conclude(JudgeFindings& findings, const std::vector<Expectation>& expected) {
  std::vector<double> h, error;
  for (const JudgedGrid& grid : findings.runs) {
    if (grid.h && grid.error.l2_max) h.push_back(*grid.h), error.push_back(*grid.error.l2_max);
  }
  if (const auto fit = fitted_order(h, error)) {
    findings.order = fit->order;
    if (fit->lower) findings.order_lower = *fit->lower;
    if (fit->upper) findings.order_upper = *fit->upper;
    const auto pairs = pairwise_orders(h, error);
    if (!pairs.empty() && pairs.back()) findings.last_order = *pairs.back();
    if (h.size() > 2) findings.range = asymptotic_range(h, error).sentence;
  }
  std::vector<std::string> causes;
  std::int64_t lost = 0;
  for (const JudgedGrid& grid : findings.runs) {
    for (const LabelFigures& label : grid.labels) {
      if (std::ranges::find(causes, label.cause) == causes.end()) causes.push_back(label.cause);
    }
    lost += grid.lost + grid.doubled + grid.unknown + grid.not_numbers;
  }
  std::string fails;
  for (const Expectation& line : expected) {
    findings.expect.push_back(judged(line, figure_for(findings, line.key)));
    const ExpectationOutcome& outcome = findings.expect.back();
    if (outcome.holds) continue;
    const std::string found = outcome.found == "null" ? "none" : shortened(outcome.found, 3);
    fails += (fails.empty() ? "" : "; ") + line.key + " " + found + ", expected " + outcome.expected;
  }
  constexpr double as_large = 0.5, falling = 0.5, nothing = 1e-9;  // of the displacement; an order; an error
  const Figure relative = findings.runs.empty() ? Figure() : findings.runs.back().error.relative;
  const auto unmeasured = std::ranges::find(findings.runs, 0, &JudgedGrid::measured);
  std::string doubt;
  if (unmeasured != findings.runs.end()) {
    doubt = "nothing is measured: no particle of " + unmeasured->name +
            " lies where the scene's body moves. Another unit of length, another origin, another scene?";
  } else if (!findings.runs.empty() && findings.runs.back().is_beyond_sight) {
    doubt = beyond_sight;
  } else if (relative && *relative > as_large) {
    doubt = "the error is " + rounded_text(100 * *relative, 2) +
            " % of the motion itself: another scene, a body that does not move, or one axis in another unit?";
  } else if (findings.last_order && *findings.last_order < falling && relative && *relative > nothing) {
    doubt = "the error does not fall on finer grids: order " + rounded_text(*findings.last_order, 3);
  }
  const CodeFindings& code = findings.code_findings;
  findings.good = causes.empty() && lost == 0 && fails.empty() && doubt.empty() && !code.is_wrong();
  findings.verdict = !causes.empty()        ? "mistakes in the data: " + joined(causes)
                     : code.is_wrong()      ? "a mistake in the code: " + code.sentence
                     : lost > 0             ? "particles are lost, doubled or no numbers"
                     : !doubt.empty()       ? doubt
                     : !fails.empty()       ? fails
                     : !findings.last_order ? "nothing is wrong with the data"
                                            : "nothing is wrong; order " + rounded_text(*findings.last_order, 3) +
                                                  " between the two finest grids";
}

std::string judge_json(const JudgeFindings& findings) {
  return json_document(JsonFields<nlohmann::ordered_json>::of(findings));
}

}  // namespace assay::drivers
