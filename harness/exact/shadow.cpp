// SPDX-License-Identifier: BSD-3-Clause
// Shadow points: histories that are integrated alongside a run, at its own time levels.
#include "harness/exact/response.hpp"

#include <algorithm>
#include <map>

#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

constexpr double history_tolerance_share = 1e-2;  ///< of the tolerance, for each step of a history

}  // namespace

/// Through the histories first, first + stride, ...: four around xi, fewer where a front or the end is near.
void ShadowCurve::interpolate(std::size_t first, std::size_t stride, double xi, Tensor& tau, Tensor& slope) const {
  const std::size_t count = (xi_.size() - first + stride - 1) / stride;
  const auto node = [&](std::size_t k) { return first + k * stride; };
  std::size_t k = 0;
  while (k + 2 < count && xi >= xi_[node(k + 1)]) ++k;
  std::size_t begin = k, end = std::min(k + 1, count - 1);  // xi lies between these
  if (way_[node(begin)] == way_[node(end)]) {
    while (end - begin < 3) {
      const bool below = begin > 0 && way_[node(begin - 1)] == way_[node(k)],
                 above = end + 1 < count && way_[node(end + 1)] == way_[node(k)];
      if (!below && !above) break;
      const bool take_below = below && (!above || k - begin <= end - (k + 1));
      take_below ? --begin : ++end;
    }
  }
  tau.setZero();
  slope.setZero();
  for (std::size_t i = begin; i <= end; ++i) {  // Lagrange, and its derivative
    double weight = 1, weight_slope = 0;
    for (std::size_t j = begin; j <= end; ++j) {
      if (j == i) continue;
      const double distance = xi_[node(i)] - xi_[node(j)];
      weight_slope = (weight_slope * (xi - xi_[node(j)]) + weight) / distance;
      weight *= (xi - xi_[node(j)]) / distance;
    }
    tau += weight * tau_[node(i)];
    slope += weight_slope * tau_[node(i)];
  }
}

Tensor ShadowCurve::between_neighbours(std::size_t i) const {
  Tensor tau, slope;
  interpolate(0, 2, xi_[i], tau, slope);
  return tau;
}

std::vector<double> ShadowCurve::fronts() const {
  std::vector<double> fronts;
  for (std::size_t i = 0; i + 1 < xi_.size(); ++i) {
    if (way_[i] != way_[i + 1]) fronts.push_back(0.5 * (xi_[i] + xi_[i + 1]));
  }
  return fronts;
}

Shadow::Shadow(std::shared_ptr<const Material> material, const Path& path, const ShadowOptions& options)
    : material_(std::move(material)), path_(path), options_(options) {
  const bool watch = material_->has(ASSAY_NON_SMOOTH);
  course_ = std::make_unique<Course>(*material_, path_, options.end, watch ? Form::increments : Form::automatic);
  workers_ = course_->workers(options.workers);
  const Interval range = path_.parameter;
  for (int k = 0; k < options.radii; ++k) {
    xi_.push_back(range.lower + range.width() * k / std::max(1, options.radii - 1));
  }
  begin();
}

/// At rest.
void Shadow::begin() {
  earlier_calls_ = calls();
  troops_.clear();
  const HistoryOptions history{.tolerance = std::max(1e-12, history_tolerance_share * options_.tolerance),
                               .watch = material_->has(ASSAY_NON_SMOOTH)};
  // here one by one, in other processes as many together as a thread has
  const int count = course_->elsewhere ? std::min(workers_.threads, options_.radii) : options_.radii;
  for (int n = 0; n < count; ++n) {
    std::vector<double> xi;
    for (int i = n; i < options_.radii; i += count) xi.push_back(xi_[static_cast<std::size_t>(i)]);
    troops_.emplace_back(*course_, std::move(xi), history, n);
  }
  t_ = 0;
  curve_ = std::make_shared<const ShadowCurve>(xi_, std::vector<Tensor>(xi_.size(), path_.initial_cauchy), ways());
}

void Shadow::advance(double t) {
  if (t < t_) begin();
  if (t == t_) return;
  std::vector<Tensor> tau(xi_.size());
  for_each_index(static_cast<int>(troops_.size()), workers_, [&](int n) {
    const auto first = static_cast<std::size_t>(n);
    Troop& troop = troops_[first];
    troop.advance(std::min(t, course_->end));
    for (std::size_t k = 0; k < troop.size(); ++k) tau[first + k * troops_.size()] = troop.tau(k);
  });
  t_ = t;
  curve_ = std::make_shared<const ShadowCurve>(xi_, std::move(tau), ways());
  measure_error();
}

/// A number for each history, the same for those that have taken the same branches.
std::vector<int> Shadow::ways() const {
  std::map<std::vector<std::uint64_t>, int> known;
  std::vector<int> ways;
  for (std::size_t i = 0; i < xi_.size(); ++i) {
    std::vector<std::uint64_t> regimes;
    for (const Branch& branch : troops_[i % troops_.size()].branches(i / troops_.size())) {
      regimes.push_back(branch.regime);
    }
    ways.push_back(known.try_emplace(std::move(regimes), static_cast<int>(known.size())).first->second);
  }
  return ways;
}

void Shadow::measure_error() {
  for (std::size_t i = 0; i < xi_.size(); ++i) {
    scale_ = larger(scale_, largest_of(curve_->at_node(i)));
    if (i % 2 == 0 || i + 1 >= xi_.size()) continue;
    difference_ = larger(difference_, largest_of(curve_->between_neighbours(i) - curve_->at_node(i)));
  }
}

std::int64_t Shadow::calls() const {
  std::int64_t sum = earlier_calls_;
  for (const Troop& troop : troops_) sum += troop.calls();
  return sum;
}

}  // namespace assay
