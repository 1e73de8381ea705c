// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/history.hpp"

#include <algorithm>

#include "harness/history/history_forms.hpp"

namespace assay {

namespace {

/// Of `update` or `rate`, in all of a piece of the path and for each time that is asked for. A piece takes some 1e4; a
/// path of 1e5 rows, which is one piece, 1e6. Beyond, the motion has so many turns that nobody could run it.
constexpr std::int64_t calls_of_piece = 3'000'000, calls_of_advance = 1000;

/// A step is refused now and then where a law ends; where the lengths of all steps are a law's own, one of some ten.
constexpr std::int64_t most_refusals = 1000;

}  // namespace

std::vector<double> state_at_rest(const Material& material, const Path& path) {
  const auto nine = nine_of(path.initial_cauchy);
  const bool stressed = !path.initial_cauchy.isZero(0);
  return material.initial_state(1, stressed ? std::span<const double>(nine) : std::span<const double>(),
                                path.material_direction);
}

History::History(const Course& course, double xi, const HistoryOptions& options) : course_(&course), xi_(xi) {
  const std::vector<double> state = state_at_rest(*course.material, *course.path);
  const auto nine = nine_of(course.path->initial_cauchy);
  y_.assign(nine.begin(), nine.end());
  y_.insert(y_.end(), state.begin(), state.end());
  if (course.by_rate) {
    rates_ = std::make_unique<Rates>(*this, options);
  } else {
    increments_ = std::make_unique<Increments>(*this, options);
  }
}

History::History(const History& other)
    : course_(other.course_),
      xi_(other.xi_),
      t_(other.t_),
      error_(other.error_),
      calls_(other.calls_),
      most_calls_(other.most_calls_),
      piece_end_(other.piece_end_),
      refusals_(other.refusals_),
      refused_(other.refused_),
      branches_(other.branches_),
      flickers_(other.flickers_),
      y_(other.y_) {
  if (other.increments_) increments_ = std::make_unique<Increments>(*this, *other.increments_);
  if (other.rates_) rates_ = std::make_unique<Rates>(*this, *other.rates_);
}

History::~History() = default;

void History::count_call() {
  if (++calls_ <= most_calls_) return;
  const bool is_refused = refused_ && refusals_ >= most_refusals;
  MaterialFailure failure(is_refused ? "its history takes too many steps, for it refuses all but short ones: " +
                                           std::string(refused_->what())
                          : rates_ ? "its history takes too many steps: the motion turns or vibrates too fast for it"
                                   : "its history takes too many steps: its increments converge too slowly for "
                                     "the accuracy that is asked for, or the motion turns or vibrates too fast",
                          is_refused ? refused_->xi : xi_, is_refused ? refused_->t : t_);
  if (is_refused) failure.step = refused_->step, failure.not_finite = refused_->not_finite;
  failure.final = true;  // shorter steps would be more of them
  failure.too_accurate = !is_refused && !rates_;
  throw failure;
}

void History::note_refusal(const MaterialFailure& failure) {
  ++refusals_;
  refused_ = std::make_shared<MaterialFailure>(failure);
}

void History::advance(double to) {
  while (t_ < to) {
    const double end = course_->piece_at(t_).upper;
    if (end != piece_end_) piece_end_ = end, most_calls_ = calls_ + calls_of_piece;
    most_calls_ += calls_of_advance;
    const double stop = std::min(to, end > t_ ? end : to);
    if (rates_) {
      rates_->advance(stop);
    } else {
      increments_->advance(stop);
    }
  }
}

Tensor History::cauchy() const { return tensor_of(y_.data()); }

Tensor History::tau() const { return first_piola_kirchhoff(cauchy(), course_->path->deformation_gradient(xi_, t_)); }

std::span<const double> History::state() const { return std::span(y_).subspan(9); }

Tensor HistoryTrail::cauchy(std::size_t k) const { return tensor_of(&rows[k * width]); }

HistoryTrail follow_here(const Course& course, double xi, const HistoryOptions& options,
                         std::span<const double> times) {
  History history(course, xi, options);
  HistoryTrail trail;
  trail.width = history.variables().size();
  trail.rows.reserve(times.size() * trail.width);
  for (const double t : times) {
    history.advance(t);
    trail.rows.insert(trail.rows.end(), history.variables().begin(), history.variables().end());
  }
  trail.branches = history.branches();
  trail.flickers = history.flickers();
  trail.error = history.error();
  trail.calls = history.calls();
  return trail;
}

HistoryTrail follow(const Course& course, double xi, const HistoryOptions& options, std::span<const double> times) {
  if (!course.elsewhere) return follow_here(course, xi, options, times);
  return course.elsewhere->follow(course.material->self(), course, xi, options, times);
}

}  // namespace assay
