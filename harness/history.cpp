// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history.hpp"

#include <algorithm>
#include <cmath>

#include "harness/checked_update.hpp"
#include "harness/history_forms.hpp"

namespace assay {

namespace {

/// Of `update` or `rate`, in all of a piece of the path and for each time that is asked for. A piece takes some 1e4; a
/// path of 1e5 rows, which is one piece, 1e6. Beyond, the motion has so many turns that nobody could run it.
constexpr std::int64_t calls_of_piece = 3'000'000, calls_of_advance = 1000;
constexpr int coarse_steps = 64;  ///< in each piece of the march that finds the scales

/// Largest value of every component along one plain march, as far as its steps go.
void march_coarsely(const Course& course, double xi, std::vector<double>& largest) {
  const Material& material = *course.material;
  double F0[9], F1[9], cauchy[9];
  std::vector<double> state0 = material.initial_state(1, {}, course.path->material_direction), state1(state0.size());
  Tensor F = course.path->deformation_gradient(xi, 0);
  for (std::size_t k = 0; k + 1 < course.pieces.size(); ++k) {
    const double begin = course.pieces[k], dt = (course.pieces[k + 1] - begin) / coarse_steps;
    for (int j = 0; j < coarse_steps; ++j) {
      const Tensor next = course.path->deformation_gradient(xi, begin + (j + 1) * dt);
      for (int c = 0; c < 9; ++c) F0[c] = component(F, c), F1[c] = component(next, c);
      try {
        checked_update(material, xi, begin + j * dt, dt, 1, F0, F1, state0.data(), state1.data(), cauchy);
      } catch (const MaterialFailure& failure) {
        if (failure.final) throw;
        return;  // whether shorter steps go on is for the histories to find
      }
      for (std::size_t c = 0; c < 9; ++c) largest[c] = std::max(largest[c], std::abs(cauchy[c]));
      for (std::size_t c = 0; c < state1.size(); ++c) largest[9 + c] = std::max(largest[9 + c], std::abs(state1[c]));
      state0.swap(state1);
      F = next;
    }
  }
}

/// The largest over a group of components that belong together; 1 where all are zero.
void share_largest(std::vector<double>& values, std::size_t begin, std::size_t end) {
  double largest = 0;
  for (std::size_t c = begin; c < end; ++c) largest = std::max(largest, values[c]);
  for (std::size_t c = begin; c < end; ++c) values[c] = largest > 0 ? largest : 1;
}

}  // namespace

Course::Course(const Material& m, const Path& p, double last, Form form, Telling by)
    : material(&m), path(&p), end(last), regimes(m.table()), telling(by) {
  const bool has_rate = m.extension<assay_rate>(ASSAY_EXTENSION_RATE) != nullptr;
  by_rate = has_rate && (form == Form::rate || (form == Form::automatic && !m.has(ASSAY_NON_SMOOTH)));
  pieces = {0};
  for (const double t : p.reversals(end)) pieces.push_back(t);
  pieces.push_back(end);
  std::vector<double> largest(9 + m.state_size(), 0.0);
  for (const double xi : {p.parameter.lower, p.parameter.upper}) march_coarsely(*this, xi, largest);
  share_largest(largest, 0, 9);
  scales.cauchy = largest[0];
  std::size_t offset = 9;
  for (std::uint32_t k = 0; k < m.table().state_count; ++k) {
    const auto size = static_cast<std::size_t>(components_of_kind(m.table().state[k].kind));
    share_largest(largest, offset, offset + size);
    offset += size;
  }
  scales.state.assign(largest.begin() + 9, largest.end());
}

Workers Course::workers(Workers wanted) const {
  if (!material->has(ASSAY_THREAD_SAFE)) wanted.threads = 1;
  return wanted;
}

Interval Course::piece_at(double t) const {
  std::size_t k = 0;
  while (k + 2 < pieces.size() && t >= pieces[k + 1]) ++k;
  return {pieces[k], pieces[k + 1]};
}

History::History(const Course& course, double xi, const HistoryOptions& options) : course_(&course), xi_(xi) {
  const std::vector<double> state = course.material->initial_state(1, {}, course.path->material_direction);
  y_.assign(9, 0.0);
  y_.insert(y_.end(), state.begin(), state.end());
  if (course.by_rate) {
    rates_ = std::make_unique<Rates>(*this, options);
  } else {
    increments_ = std::make_unique<Increments>(*this, options);
  }
}

History::~History() = default;

void History::count_call() {
  if (++calls_ <= most_calls_) return;
  MaterialFailure failure("its history takes too many steps: the motion turns or vibrates too fast for it", xi_, t_);
  failure.final = true;  // shorter steps would be more of them
  throw failure;
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

Tensor History::cauchy() const {
  Tensor sigma;
  for (int c = 0; c < 9; ++c) component(sigma, c) = y_[static_cast<std::size_t>(c)];
  return sigma;
}

Tensor History::tau() const { return first_piola_kirchhoff(cauchy(), course_->path->deformation_gradient(xi_, t_)); }

std::span<const double> History::state() const { return std::span(y_).subspan(9); }

}  // namespace assay
