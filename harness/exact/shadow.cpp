// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/shadow.hpp"

#include <algorithm>
#include <cmath>

#include "harness/numeric/largest.hpp"

namespace assay {

namespace {

constexpr double history_tolerance_share = 1e-2;  ///< of the tolerance, for each step of a history

}  // namespace

Shadow::Shadow(std::shared_ptr<const Material> material, const Path& path, const ShadowOptions& options)
    : material_(std::move(material)), path_(path) {
  const bool watch = material_->has(ASSAY_NON_SMOOTH);
  course_ = std::make_unique<Course>(*material_, path_, options.end, watch ? Form::increments : Form::automatic);
  workers_ = course_->workers(options.workers);
  const HistoryOptions history{.tolerance = std::max(1e-12, history_tolerance_share * options.tolerance),
                               .watch = watch};
  const Interval range = path_.parameter;
  for (int k = 0; k < options.radii; ++k) {
    xi_.push_back(range.lower + range.width() * k / std::max(1, options.radii - 1));
  }
  // here one by one, in other processes as many together as a thread has
  const int count = course_->elsewhere ? std::min(workers_.threads, options.radii) : options.radii;
  for (int n = 0; n < count; ++n) {
    std::vector<double> xi;
    for (int i = n; i < options.radii; i += count) xi.push_back(xi_[static_cast<std::size_t>(i)]);
    troops_.emplace_back(*course_, std::move(xi), history, n);
  }
  tau_.assign(xi_.size(), Tensor::Zero());
}

void Shadow::advance(double t) {
  if (t <= t_) return;
  for_each_index(static_cast<int>(troops_.size()), workers_, [&](int n) {
    const auto first = static_cast<std::size_t>(n);
    Troop& troop = troops_[first];
    troop.advance(std::min(t, course_->end));
    for (std::size_t k = 0; k < troop.size(); ++k) tau_[first + k * troops_.size()] = troop.tau(k);
  });
  t_ = t;
  measure_error();
}

const std::vector<Branch>& Shadow::branches(std::size_t i) const {
  return troops_[i % troops_.size()].branches(i / troops_.size());
}

/// Whether two histories have taken the same branches.
bool Shadow::alike(std::size_t i, std::size_t j) const {
  const auto& a = branches(i);
  const auto& b = branches(j);
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Branch& one, const Branch& other) { return one.regime == other.regime; });
}

/// Through the histories first, first + stride, ...: four around xi, fewer where a front or the end is near.
void Shadow::interpolate(std::size_t first, std::size_t stride, double xi, Tensor& tau, Tensor& slope) const {
  const std::size_t count = (xi_.size() - first + stride - 1) / stride;
  const auto node = [&](std::size_t k) { return first + k * stride; };
  std::size_t k = 0;
  while (k + 2 < count && xi >= xi_[node(k + 1)]) ++k;
  std::size_t begin = k, end = std::min(k + 1, count - 1);  // xi lies between these
  if (alike(node(begin), node(end))) {
    while (end - begin < 3) {
      const bool below = begin > 0 && alike(node(begin - 1), node(k)),
                 above = end + 1 < count && alike(node(end + 1), node(k));
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

void Shadow::at(double xi, Tensor& tau, Tensor& dtau_dxi) const { interpolate(0, 1, xi, tau, dtau_dxi); }

void Shadow::measure_error() {
  Tensor tau, slope;
  for (std::size_t i = 0; i < xi_.size(); ++i) {
    scale_ = larger(scale_, largest_of(tau_[i]));
    if (i % 2 == 0 || i + 1 >= xi_.size()) continue;
    interpolate(0, 2, xi_[i], tau, slope);
    difference_ = larger(difference_, largest_of(tau - tau_[i]));
  }
}

std::vector<double> Shadow::fronts() const {
  std::vector<double> fronts;
  for (std::size_t i = 0; i + 1 < xi_.size(); ++i) {
    if (!alike(i, i + 1)) fronts.push_back(0.5 * (xi_[i] + xi_[i + 1]));
  }
  return fronts;
}

std::int64_t Shadow::calls() const {
  std::int64_t sum = 0;
  for (const Troop& troop : troops_) sum += troop.calls();
  return sum;
}

}  // namespace assay
