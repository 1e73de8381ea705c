// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/band.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>

#include "harness/history/history.hpp"

namespace assay {

namespace {

constexpr int first_samples =
    24;  ///< on each side of xi = 0, besides the ends: a band narrower than their distance may be missed
constexpr double edge_share = 1e-12;  ///< of the parameter's range: to which the edges of bands are found
constexpr int most_traces = 2000;     ///< in one gap between samples: beyond, bands are too many to be told apart

/// A band narrower than this [of the range] is not one: at its edge a material's own rounding decides on the regime.
constexpr double narrowest_share = 1e-9;

struct Sample {
  double xi;
  Ray ray;
};

/// Two samples with one edge between them.
struct Edge {
  Sample left, right;
  double xi() const { return 0.5 * (left.xi + right.xi); }
};

/// Finds every edge between two samples by bisection.
class EdgeSearch {
 public:
  EdgeSearch(const Course& course, const HistoryOptions& options, const std::function<void()>& poll,
             std::int64_t& calls)
      : course_(course), options_(options), poll_(poll), calls_(calls), range_(course.path->parameter.width()) {}

  void between(const Sample& left, const Sample& right, std::vector<Edge>& found) {
    if (left.ray.branches == right.ray.branches) return;
    const double width = right.xi - left.xi;
    if (width <= edge_share * range_) return found.push_back({left, right});
    if (++traces_ > most_traces) throw RegimesFlicker();
    if (poll_) poll_();
    Sample middle{left.xi + 0.5 * width, {}};
    const bool narrow = width <= narrowest_share * range_;
    try {
      middle.ray = trace(course_, middle.xi, options_, calls_);
    } catch (const RegimesFlicker&) {
      if (!narrow) throw;
    }
    if (narrow && middle.ray.branches != left.ray.branches && middle.ray.branches != right.ray.branches) {
      return found.push_back({left, right});
    }
    between(left, middle, found);
    between(middle, right, found);
  }

 private:
  const Course& course_;
  const HistoryOptions& options_;
  const std::function<void()>& poll_;  ///< between histories: there may be thousands in a gap
  std::int64_t& calls_;
  double range_;
  int traces_ = 0;
};

std::vector<double> sample_places(const Interval& range) {
  std::vector<double> places;
  const auto add = [&](double from, double to) {
    for (int k = 0; k < first_samples; ++k) {
      const double s = (k + 0.5) / first_samples;
      places.push_back(from + (to - from) * s);
    }
  };
  places.push_back(range.lower);
  if (range.lower < 0 && range.upper > 0) {
    add(range.lower, 0);
    add(0, range.upper);
  } else {
    add(range.lower, range.upper);
  }
  if (range.width() > 0) places.push_back(range.upper);
  return places;
}

/// Two, or one where xi has one sign: the pieces of the path are the only breaks.
std::vector<Band> unwatched_bands(const Course& course) {
  const Interval range = course.path->parameter;
  const Ray ray{course.pieces, std::vector<std::uint64_t>(course.pieces.size() - 1, 1)};
  if (range.lower < 0 && range.upper > 0) return {{{{range.lower, 0}}, ray}, {{{0, range.upper}}, ray}};
  return {{{range}, ray}};
}

}  // namespace

Ray trace(const Course& course, double xi, const HistoryOptions& options, std::int64_t& calls) {
  const HistoryTrail trail = follow(course, xi, options, std::span(&course.end, 1));
  calls += trail.calls;
  if (trail.flickers) throw RegimesFlicker();
  Ray ray;
  for (const Branch& branch : trail.branches) {
    const bool reversal = std::find(course.pieces.begin(), course.pieces.end(), branch.begin) != course.pieces.end();
    ray.breaks.push_back(branch.begin);
    ray.branches.push_back(2 * branch.regime + (reversal ? 1 : 0));
  }
  ray.breaks.push_back(course.end);
  return ray;
}

double BandMap::xi_of(double s) const {
  double sigma = s;
  if (grazes_lower && grazes_upper) {
    sigma = s * s * (3 - 2 * s);
  } else if (grazes_lower) {
    sigma = s * s;
  } else if (grazes_upper) {
    sigma = s * (2 - s);
  }
  return xi.lower + xi.width() * sigma;
}

double BandMap::s_of(double at) const {
  if (!(xi.width() > 0)) return 0;
  const double sigma = std::clamp((at - xi.lower) / xi.width(), 0.0, 1.0);
  if (grazes_lower && grazes_upper) {  // the middle root of the cubic
    return std::clamp(0.5 - std::sin(std::asin(1 - 2 * sigma) / 3), 0.0, 1.0);
  }
  if (grazes_lower) return std::sqrt(sigma);
  if (grazes_upper) return 1 - std::sqrt(std::clamp((xi.upper - at) / xi.width(), 0.0, 1.0));
  return sigma;
}

double BandMap::slope(double s) const {
  double slope = 1;
  if (grazes_lower && grazes_upper) {
    slope = 6 * s * (1 - s);
  } else if (grazes_lower) {
    slope = 2 * s;
  } else if (grazes_upper) {
    slope = 2 * (1 - s);
  }
  return xi.width() * slope;
}

std::vector<Band> find_bands(const Course& course, const HistoryOptions& options, std::vector<double> extra,
                             const Workers& workers, std::int64_t& calls) {
  const Interval range = course.path->parameter;
  if (!options.watch || !course.tells()) return unwatched_bands(course);
  std::vector<double> places = sample_places(range);
  places.insert(places.end(), extra.begin(), extra.end());
  std::sort(places.begin(), places.end());
  const auto n = places.size();
  std::vector<Sample> samples(n);
  std::vector<std::int64_t> calls_of(2 * n);
  for_each_index(static_cast<int>(n), workers, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    samples[i] = {places[i], trace(course, places[i], options, calls_of[i])};
  });
  const std::function<void()> silent;
  const auto caller = std::this_thread::get_id();
  std::vector<std::vector<Edge>> edges(n);
  for_each_index(static_cast<int>(n) - 1, workers, [&](int k) {
    const auto i = static_cast<std::size_t>(k);
    const auto& poll = std::this_thread::get_id() == caller ? workers.poll : silent;
    EdgeSearch(course, options, poll, calls_of[n + i]).between(samples[i], samples[i + 1], edges[i]);
  });
  for (const std::int64_t c : calls_of) calls += c;

  std::vector<Band> bands;
  double begin = range.lower;
  bool grazes = false;
  const auto close = [&](double end, bool grazing, const Ray& ray) {
    if (end > begin) bands.push_back({{{begin, end}, grazes, grazing}, ray});
    begin = end;
    grazes = grazing;
  };
  const double narrowest = narrowest_share * range.width();
  for (std::size_t i = 0; i < n; ++i) {
    for (const Edge& edge : edges[i]) {
      if (edge.xi() - begin < narrowest || range.upper - edge.xi() < narrowest) continue;
      if (begin < 0 && edge.xi() > 0) close(0, false, edge.left.ray);
      close(edge.xi(), true, edge.left.ray);
    }
    if (i + 1 < n && samples[i].xi < 0 && samples[i + 1].xi > 0 && begin < 0) close(0, false, samples[i + 1].ray);
  }
  close(range.upper, false, samples.back().ray);
  return bands;
}

}  // namespace assay
