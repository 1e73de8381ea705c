// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/labels.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "drivers/judge/changes.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

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
  if (!std::isfinite(before)) return {};
  return "; the error falls from " + rounded_text(before, 3) + " to " + rounded_text(after, 3) + " " + unit;
}

namespace {

auto kept(const auto& values, const std::vector<std::size_t>& rows) {
  using T = std::remove_cvref_t<decltype(*values.begin())>;
  std::vector<T> some;
  if (values.empty()) return some;
  some.reserve(rows.size());
  for (const std::size_t row : rows) some.push_back(values[row]);
  return some;
}

JudgedFrame kept_rows(const JudgedFrame& frame, const std::vector<std::size_t>& rows) {
  return {frame.name,
          frame.t,
          frame.t_velocity,
          kept(frame.id, rows),
          kept(frame.volume, rows),
          kept(frame.X, rows),
          kept(frame.x, rows),
          kept(frame.v, rows),
          kept(frame.F, rows),
          kept(frame.sigma, rows),
          kept(frame.J, rows)};
}

/// Some of them, the first one, from which the seeds may come, among them.
std::vector<std::size_t> few_frames(const JudgedRun& run, std::size_t wanted = 6) {
  const std::size_t n = run.frames.size(), most = std::min(n, wanted);
  std::vector<std::size_t> few;
  for (std::size_t k = 0; k < most; ++k) few.push_back(most > 1 ? k * (n - 1) / (most - 1) : 0);
  return few;
}

JudgedRun without_frames(const JudgedRun& run) { return {run.name, run.map, {}, run.time_words, {}, run.rounding}; }

JudgedRun few_of(const JudgedRun& run) {
  JudgedRun few = without_frames(run);
  for (const std::size_t k : few_frames(run)) few.frames.push_back(run.frames[k]);
  return few;
}

}  // namespace

JudgedRun thin_of(const JudgedRun& run) {
  constexpr std::size_t most = 2000;
  const std::size_t n = run.frames.front().size(), step = (n + most - 1) / most;
  const auto all_have = [&](auto member) {
    return std::ranges::none_of(run.frames, [&](const JudgedFrame& frame) { return (frame.*member).empty(); });
  };
  const bool has_ids = all_have(&JudgedFrame::id), has_X = all_have(&JudgedFrame::X);
  if (step < 2 || (!has_ids && !has_X)) return few_of(run);  // the nearest one may be any
  std::unordered_set<double> ids;
  for (std::size_t p = 0; has_ids && p < n; p += step) ids.insert(std::as_const(run.frames.front().id)[p]);
  JudgedRun thin = without_frames(run);
  for (const std::size_t k : few_frames(run)) {
    const JudgedFrame& frame = run.frames[k];
    std::vector<std::size_t> rows;
    for (std::size_t p = 0; p < frame.size(); ++p) {
      if (has_ids ? ids.contains(frame.id[p]) : p % step == 0) rows.push_back(p);
    }
    thin.frames.push_back(kept_rows(frame, rows));
  }
  return thin;
}

namespace {

constexpr double apart = 1.3;   ///< so much smaller than under any other change the error must be
constexpr double alike = 0.01;  ///< errors that rounding and the search for times tell apart

/// Without its error.
JudgedState seeded(JudgedRun run, const ExactParticles& exact) {
  JudgedState state{std::move(run), {}, Pairing::nearest, {}};
  state.seeds = seeds_of(state.run, exact);
  state.pairing = pairing_of(state.run, state.seeds);
  return state;
}

JudgedState state_of(JudgedRun run, ExactParticles& exact) {
  JudgedState state = seeded(std::move(run), exact);
  state.error = position_error(state.run, state.seeds, state.pairing, exact);
  return state;
}

/// All particles of a few frames, their positions alone.
JudgedRun all_of(const JudgedRun& run) {
  constexpr std::size_t many_particles = 300'000;
  JudgedRun some = without_frames(run);
  for (const std::size_t k : few_frames(run, run.frames.front().size() > many_particles ? 3 : 6)) {
    const JudgedFrame& f = run.frames[k];
    some.frames.push_back({f.name, f.t, f.t_velocity, f.id, f.volume, f.X, f.x, f.v, {}, {}, {}});
  }
  return some;
}

/// Each of the candidates that look for the nearest particle sees all of them, the others some.
struct Looked {
  JudgedState some, all;
};

/// Where a clock is wrong, velocities are those of the right time; where a body is late, they are smaller or larger by
/// as much. Empty without velocities. rate: of the clock less 1.
std::optional<bool> are_right(const JudgedState& state, double rate, ExactParticles& exact) {
  double with = 0, alone = 0;
  SeedFinder find(state.seeds, state.pairing, exact);
  for (const JudgedFrame& frame : state.run.frames) {
    if (frame.v.empty()) return std::nullopt;
    const FramePairs pairs = find(frame);
    const std::vector<Vector3> X = pairs.X(frame, state.seeds, state.pairing);
    const std::vector<PointFields>& now = exact.velocities(X, frame.t_velocity);
    for (std::size_t k = 0; k < X.size(); ++k) {
      const Vector3 v(now[k].v[0], now[k].v[1], now[k].v[2]), found = frame.v[pairs.pairs[k].particle];
      if (!found.allFinite()) continue;
      with += v.dot(found), alone += v.squaredNorm();
    }
  }
  constexpr double half_way = 0.5;
  return alone > 0 ? std::optional(std::abs(with / alone - 1) < half_way * std::abs(rate)) : std::nullopt;
}

void change(Looked& now, const Change& by, ExactParticles& exact) {
  by(now.all.run), by(now.some.run);
  now = {state_of(std::move(now.some.run), exact), seeded(std::move(now.all.run), exact)};
}

/// The best candidate, if it is told from the others.
std::optional<Label> best_of(const std::vector<Candidate>& all, Looked& now, ExactParticles& exact) {
  struct Found {
    double relative, error;
    const Candidate* candidate;
  };
  std::vector<Found> found;
  for (const Candidate& candidate : all) {
    JudgedState& before = candidate.needs_all ? now.all : now.some;
    if (!std::isfinite(before.error.error))
      before.error = position_error(before.run, before.seeds, before.pairing, exact);
    JudgedRun changed = before.run;
    candidate.change(changed);
    JudgedState state = state_of(std::move(changed), exact);
    const bool flattered = state.pairing == Pairing::nearest && before.pairing != Pairing::nearest &&
                           !(state.error.error < seen_by_nearest * state.seeds.spacing);
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
  const Candidate& candidate = *best->candidate;
  Label label{
      candidate.cause, candidate.sentence, now.some.error.error, best->error, candidate.change, candidate.lateness, {}};
  std::vector<std::string> others{label.cause};
  for (const Found& each : found) {
    if (std::ranges::find(others, each.candidate->cause) != others.end()) continue;
    others.push_back(each.candidate->cause);
    label.sentence += "; or else " + each.candidate->sentence;
  }
  label.sentence += by_how_much(label.before, label.after, "m");
  change(now, label.change, exact);
  if (label.cause == clock_rate) label.by_velocities = are_right(now.some, *label.lateness, exact);
  return label;
}

}  // namespace

std::vector<Label> position_labels(const JudgedRun& run, const BodyPlace& body, ExactParticles& exact,
                                   const Causes& left_out) {
  std::vector<Label> labels;
  Looked now{state_of(thin_of(run), exact), seeded(all_of(run), exact)};
  const bool blind = !std::isfinite(now.some.error.error) || exact.solution().motion()->is_homogeneous();
  if (const auto unit = blind ? unit_by_size(now.all.seeds, body) : std::nullopt) {
    const double before = now.some.error.error;
    change(now, unit->change, exact);
    labels.push_back({unit->cause, unit->sentence, before, now.some.error.error, unit->change});
  }
  constexpr int most = 3;  // one on top of another
  for (int k = 0; k < most && now.some.error.relative() > rounding; ++k) {
    const std::vector<Candidate> all =
        position_changes(now.some, now.all.seeds, body, interval_of(run), exact, left_out);
    const auto label = best_of(all, now, exact);
    if (!label) break;
    labels.push_back(*label);
  }
  return labels;
}

void take(const std::vector<Label>& labels, JudgedRun& run) {
  for (const Label& label : labels) label.change(run);
}

}  // namespace assay::drivers
