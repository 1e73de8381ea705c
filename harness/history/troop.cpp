// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/troop.hpp"

#include <algorithm>

#include "harness/history/history.hpp"

namespace assay {

Troop::Troop(const Course& course, std::vector<double> xi, const HistoryOptions& options, int worker)
    : course_(&course), xi_(std::move(xi)) {
  if (course.elsewhere) {
    advance_there_ = course.elsewhere->gather(course.material->self(), course, xi_, options, worker);
    const auto at_rest = nine_of(course.path->initial_cauchy);
    there_.assign(xi_.size(), HistoryTrail{.rows = {at_rest.begin(), at_rest.end()}});
    return;
  }
  for (const double place : xi_) here_.push_back(std::make_unique<History>(course, place, options));
}

void Troop::advance(double to) {
  if (advance_there_) there_ = advance_there_(to);
  for (const auto& history : here_) history->advance(to);
  t_ = std::max(t_, to);
}

Tensor Troop::tau(std::size_t k) const {
  if (!here_.empty()) return here_[k]->tau();
  return first_piola_kirchhoff(there_[k].cauchy(0), course_->path->deformation_gradient(xi_[k], t_));
}

std::vector<HistoryTrail> Troop::trails() const {
  if (here_.empty()) return there_;
  std::vector<HistoryTrail> trails;
  for (const auto& history : here_) {
    const auto now = history->variables();
    trails.push_back({now.size(),
                      {now.begin(), now.end()},
                      history->branches(),
                      history->flickers(),
                      history->error(),
                      history->calls()});
  }
  return trails;
}

double Troop::error() const {
  double largest = 0;
  for (const auto& history : here_) largest = std::max(largest, history->error());
  for (const HistoryTrail& trail : there_) largest = std::max(largest, trail.error);
  return largest;
}

std::int64_t Troop::calls() const {
  std::int64_t sum = 0;
  for (const auto& history : here_) sum += history->calls();
  for (const HistoryTrail& trail : there_) sum += trail.calls;
  return sum;
}

}  // namespace assay
