// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/stability_screen.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/history/point_driver.hpp"
#include "harness/stability/stability_probe.hpp"

namespace assay {

namespace {

constexpr int screened_times = 16;           ///< in each piece of time, where there are few
constexpr int screened_times_in_all = 1024;  ///< and in all of them, though one in each at least
constexpr int screened_fractions = 8;        ///< of the range of xi, on both sides of 0
constexpr int sections = 5;                  ///< of a bracket, again and again
constexpr double bracket = 5e-4;             ///< relative, at which that ends
constexpr double screened_tolerance = 1e-5;  ///< of the states that are looked at

/// One screening: what does not change from place to place.
class Screen {
 public:
  Screen(const Material& material, const Path& path, double end, const std::function<void(double)>& progress)
      : material_(material), path_(path), progress_(progress), probe_(material, path, end) {}

  StabilityScreen run() {
    StabilityScreen screen;
    const AcousticExtreme& rest = probe_.at_rest();
    screen.smallest = probe_.scale() > 0 ? rest.value / probe_.scale() : 0;
    if (std::abs(rest.value) <= probe_.noise_floor()) {
      screen.verdict = StabilityScreen::Verdict::neutral;
      return screen;
    }
    if (rest.value < 0) {
      screen.verdict = StabilityScreen::Verdict::unstable;
      screen.normal = rest.normal;
      screen.safe_fraction = path_.parameter_is_place ? NAN : 0;
      return screen;
    }
    follow(screen);
    return screen;
  }

 private:
  /// What was found at every time (rows) and xi.
  struct Scan {
    std::vector<double> xi, times;
    std::vector<std::vector<AcousticExtreme>> found;
    int unjudged = 0;  ///< places at which nothing could be found; they count as stable
  };
  Scan scan(const std::vector<double>& xi, const std::vector<double>& times) const {
    DriverOptions options;
    options.tolerance = screened_tolerance;
    const Histories h = integrate_histories(material_, path_, xi, times, options);
    Scan result{xi, times, {}};
    std::vector<std::vector<double>> states(xi.size(), std::vector<double>(material_.state_size()));
    for (std::size_t row = 0; row < times.size(); ++row) {
      if (progress_) progress_(static_cast<double>(row) / static_cast<double>(times.size()));
      for (std::size_t p = 0; p < xi.size(); ++p) {
        for (std::size_t c = 0; c < states[p].size(); ++c) states[p][c] = h.points[row].state[c * xi.size() + p];
      }
      try {
        result.found.push_back(probe_.at(xi, times[row], states));
      } catch (const MaterialFailure&) {
        const auto all = static_cast<int>(xi.size() * times.size());
        result.found.push_back(one_by_one(xi, times[row], states, all, result.unjudged));
      }
    }
    return result;
  }

  /// Where a batch fails: its places that do not. Throws where `all` places so far are unjudged.
  std::vector<AcousticExtreme> one_by_one(const std::vector<double>& xi, double t,
                                          const std::vector<std::vector<double>>& states, int all,
                                          int& unjudged) const {
    std::vector<AcousticExtreme> found;
    for (std::size_t p = 0; p < xi.size(); ++p) {
      try {
        found.push_back(probe_.at(xi[p], t, states[p]));
      } catch (MaterialFailure& failure) {
        failure.xi = xi[p];
        if (failure.final || ++unjudged == all) throw;  // nothing can be judged
        found.push_back({probe_.scale(), Vector3::Zero()});
      }
    }
    return found;
  }

  std::vector<double> sampled_times() const {
    const std::vector<double>& breaks = probe_.breaks();
    const int in_a_piece = std::clamp(screened_times_in_all / static_cast<int>(breaks.size()), 1, screened_times);
    std::vector<double> times;
    for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
      for (int k = 1; k <= in_a_piece; ++k) times.push_back(breaks[b] + (breaks[b + 1] - breaks[b]) * k / in_a_piece);
    }
    return times;
  }

  /// Both ends of the range shrunk by the fractions.
  std::vector<double> shrunk(const std::vector<double>& shares) const {
    std::vector<double> xi;
    for (const double share : shares) {
      xi.push_back(share * path_.parameter.lower);
      xi.push_back(share * path_.parameter.upper);
    }
    return xi;
  }

  /// From end to end of the range.
  std::vector<double> places() const {
    const Interval& range = path_.parameter;
    std::vector<double> xi = between(range.lower, range.upper, 2 * screened_fractions);
    xi.insert(xi.begin(), range.lower);
    return xi;
  }

  static std::vector<double> between(double lower, double upper, int count) {
    std::vector<double> values;
    for (int k = 1; k <= count; ++k) values.push_back(k == count ? upper : lower + (upper - lower) * k / count);
    return values;
  }

  void follow(StabilityScreen& screen) const {
    const std::vector<double> shares = between(0, 1, screened_fractions);
    // A body goes through a curved family at the ends of the range alone: what lies within is no part of its way.
    const bool ends_alone = !path_.straight() && !path_.parameter_is_place;
    const Scan whole =
        scan(path_.parameter_is_place ? places() : shrunk(ends_alone ? std::vector{1.0} : shares), sampled_times());
    screen.unjudged = whole.unjudged;
    for (std::size_t row = 0; row < whole.times.size(); ++row) {
      for (std::size_t p = 0; p < whole.xi.size(); ++p) {
        screen.smallest = std::min(screen.smallest, whole.found[row][p].value / probe_.scale());
      }
    }
    if (screen.smallest > 0) return;
    screen.verdict = StabilityScreen::Verdict::unstable;
    locate(whole, screen);
    screen.safe_fraction = path_.parameter_is_place ? NAN
                           : ends_alone             ? safe_share(scan(shrunk(shares), sampled_times()), shares)
                                                    : safe_share(whole, shares);
  }

  /// First loss in time: of the samples, then of the interval before it in sections.
  void locate(const Scan& whole, StabilityScreen& screen) const {
    const auto worst_of = [](const std::vector<AcousticExtreme>& row) {
      return std::min_element(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    };
    std::size_t row = 0;
    while (worst_of(whole.found[row])->value > 0) ++row;
    const auto worst = worst_of(whole.found[row]);
    screen.xi = whole.xi[static_cast<std::size_t>(worst - whole.found[row].begin())];
    screen.normal = worst->normal;
    double before = row > 0 ? whole.times[row - 1] : 0;
    screen.t = whole.times[row];
    while (screen.t - before > bracket * screen.t) {
      const std::vector<double> earlier(whole.times.begin(), whole.times.begin() + static_cast<std::ptrdiff_t>(row));
      std::vector<double> times = earlier;
      for (const double t : between(before, screen.t, sections)) times.push_back(t);
      std::vector<double> distinct;
      for (const double t : times) {
        if (distinct.empty() || t > distinct.back()) distinct.push_back(t);
      }
      const Scan closer = scan({screen.xi}, distinct);
      std::size_t k = 0;
      while (k + 1 < distinct.size() && (distinct[k] <= before || closer.found[k][0].value > 0)) ++k;
      screen.t = distinct[k];
      screen.normal = closer.found[k][0].normal;
      if (k > 0) before = std::max(before, distinct[k - 1]);
    }
  }

  static bool lost(const Scan& s, std::size_t share) {
    return std::any_of(s.found.begin(), s.found.end(),
                       [&](const auto& row) { return row[2 * share].value <= 0 || row[2 * share + 1].value <= 0; });
  }

  /// Largest share of the range that keeps all of it, up to which nothing is lost.
  double safe_share(const Scan& whole, std::vector<double> shares) const {
    double below = 0, above = 1;
    const Scan* current = &whole;
    Scan closer;
    for (;;) {
      std::size_t k = 0;
      while (k + 1 < shares.size() && !lost(*current, k)) ++k;
      if (k > 0) below = shares[k - 1];
      above = shares[k];
      if (above - below <= bracket * above) return below;
      shares = between(below, above, sections);
      closer = scan(shrunk(shares), sampled_times());
      current = &closer;
    }
  }

  const Material& material_;
  const Path& path_;
  const std::function<void(double)>& progress_;
  StabilityProbe probe_;
};

}  // namespace

StabilityScreen screen_stability(const Material& material, const Path& path, double end,
                                 const std::function<void(double)>& progress) {
  return Screen(material, path, end, progress).run();
}

}  // namespace assay
