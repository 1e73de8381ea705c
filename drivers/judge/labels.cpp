// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/labels.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <unordered_set>

#include "drivers/judge/changes.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

JudgedRun few_of(const JudgedRun& run) {
  constexpr std::size_t frames_looked_at = 6;
  JudgedRun few{run.name, run.map, {}, run.time_words, {}, run.rounding};
  const std::size_t n = run.frames.size(), most = std::min(n, frames_looked_at);
  for (std::size_t k = 0; k < most; ++k) few.frames.push_back(run.frames[most > 1 ? k * (n - 1) / (most - 1) : 0]);
  return few;
}

bool only_at_rest(const JudgedRun& run, double half) {
  return std::ranges::none_of(run.frames,
                              [&](const JudgedFrame& frame) { return std::abs(frame.t - half) < 0.6 * half; });
}

double interval_of(const JudgedRun& run) {
  const std::size_t n = run.frames.size();
  return n > 1 ? (run.frames.back().t - run.frames.front().t) / static_cast<double>(n - 1) : 0;
}

double least_place(double lower, double upper, const std::function<double(double)>& f) {
  constexpr int places = 40, bits = 20;
  double best = lower, least = HUGE_VAL;
  const double step = (upper - lower) / places;
  for (int k = 0; k <= places; ++k) {
    const double at = lower + k * step, value = f(at);
    if (value < least) least = value, best = at;
  }
  return boost::math::tools::brent_find_minima(f, best - step, best + step, bits).first;
}

std::string by_how_much(double before, double after, const std::string& unit) {
  return "; the error falls from " + rounded_text(before, 3) + " to " + rounded_text(after, 3) + " " + unit;
}

namespace {

template <class T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& rows) {
  if (values.empty()) return;
  std::vector<T> kept;
  for (const std::size_t row : rows) kept.push_back(values[row]);
  values = std::move(kept);
}

void keep_rows(JudgedFrame& frame, const std::vector<std::size_t>& rows) {
  keep(frame.id, rows), keep(frame.volume, rows), keep(frame.J, rows);
  keep(frame.X, rows), keep(frame.x, rows), keep(frame.v, rows);
  keep(frame.F, rows), keep(frame.sigma, rows);
}

}  // namespace

void thin_out(JudgedRun& run) {
  constexpr std::size_t most = 2000;
  const std::size_t n = run.frames.front().size(), step = (n + most - 1) / most;
  if (step < 2) return;
  const bool has_ids = std::ranges::none_of(run.frames, [](const JudgedFrame& frame) { return frame.id.empty(); });
  const bool has_X = std::ranges::none_of(run.frames, [](const JudgedFrame& frame) { return frame.X.empty(); });
  if (!has_ids && !has_X) return;  // the nearest one may be any
  std::unordered_set<double> ids;
  for (std::size_t p = 0; has_ids && p < n; p += step) ids.insert(run.frames.front().id[p]);
  for (JudgedFrame& frame : run.frames) {
    std::vector<std::size_t> rows;
    for (std::size_t p = 0; p < frame.size(); ++p) {
      if (has_ids ? ids.contains(frame.id[p]) : p % step == 0) rows.push_back(p);
    }
    keep_rows(frame, rows);
  }
}

namespace {

constexpr double apart = 1.3;   ///< so much smaller than under any other change the error must be
constexpr double alike = 0.01;  ///< errors that rounding and the search for times tell apart

JudgedState state_of(JudgedRun run, ExactParticles& exact) {
  JudgedState state{std::move(run), {}, Pairing::nearest, {}};
  state.seeds = seeds_of(state.run, exact);
  state.pairing = pairing_of(state.run, state.seeds);
  state.error = position_error(state.run, state.seeds, state.pairing, exact);
  return state;
}

/// Their positions alone.
JudgedRun some_of(const JudgedRun& run) {
  JudgedRun some = few_of(run);
  for (JudgedFrame& frame : some.frames) frame.F.clear(), frame.sigma.clear(), frame.J.clear();
  return some;
}

/// Each of the candidates that look for the nearest particle sees all of them, the others some.
struct Looked {
  JudgedState some, all;
};

Looked looked_at(JudgedRun run, ExactParticles& exact) {
  JudgedRun thin = run;
  thin_out(thin);
  return {state_of(std::move(thin), exact), state_of(std::move(run), exact)};
}

/// The best candidate, if it is told from the others.
std::optional<Label> best_of(const std::vector<Candidate>& all, Looked& now, JudgedRun& whole, ExactParticles& exact) {
  struct Found {
    double relative, error;
    const Candidate* candidate;
  };
  std::vector<Found> found;
  for (const Candidate& candidate : all) {
    const JudgedState& before = candidate.needs_all ? now.all : now.some;
    JudgedRun changed = before.run;
    candidate.change(changed);
    JudgedState state = state_of(std::move(changed), exact);
    // pairing by the nearest one flatters: an error as large as half of the distance cannot be seen
    const bool flattered = state.pairing == Pairing::nearest && before.pairing != Pairing::nearest &&
                           !(state.error.error < 0.2 * state.seeds.spacing);
    constexpr double explained = 1;  // what is still as far off as the motion is wide is wrong in another way
    const bool falls = state.error.error * telling < before.error.error && state.error.relative() < explained;
    if (!flattered && falls && std::isfinite(state.error.relative()))
      found.push_back({state.error.relative(), state.error.error, &candidate});
  }
  std::ranges::sort(found, {}, &Found::relative);
  if (found.empty() || !(found[0].relative * telling < now.some.error.relative())) return std::nullopt;
  const double least = found[0].relative;
  std::erase_if(found, [&](const Found& each) { return each.relative > apart * least; });
  std::ranges::sort(found, {}, &Found::candidate);  // the simplest first
  const auto best = std::ranges::find_if(found, [&](const Found& each) { return each.relative < (1 + alike) * least; });
  Label label{best->candidate->cause, best->candidate->sentence, now.some.error.error, best->error};
  std::vector<std::string> others{label.cause};
  for (const Found& each : found) {
    if (std::ranges::find(others, each.candidate->cause) != others.end()) continue;
    others.push_back(each.candidate->cause);
    label.sentence += "; or else " + each.candidate->sentence;
  }
  const Change change = best->candidate->change;
  label.sentence += by_how_much(label.before, label.after, "m");
  change(now.all.run);
  change(whole);
  now = looked_at(std::move(now.all.run), exact);
  return label;
}

}  // namespace

std::vector<Label> take_position_labels(JudgedRun& run, const Vector3& body, ExactParticles& exact) {
  std::vector<Label> labels;
  Looked now = looked_at(some_of(run), exact);
  constexpr int most = 3;  // one on top of another
  for (int k = 0; k < most && now.some.error.relative() > rounding; ++k) {
    const std::vector<Candidate> all = position_changes(now.some, now.all.seeds, body, interval_of(run), exact);
    const auto label = best_of(all, now, run, exact);
    if (!label) break;
    labels.push_back(*label);
  }
  return labels;
}

}  // namespace assay::drivers
