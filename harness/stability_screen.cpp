// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability_screen.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/acoustic_tensor.hpp"
#include "harness/point_driver.hpp"

namespace assay {

namespace {

constexpr int samples = 16;                 ///< in each piece of time
constexpr int fractions = 8;                ///< of the range of xi, on both sides of 0
constexpr int sections = 5;                 ///< of a bracket, again and again
constexpr double bracket = 5e-4;            ///< relative, at which that ends
constexpr double history_tolerance = 1e-5;  ///< of the states that are looked at
constexpr double share_of_end = 1e-4;       ///< a usual step of an explicit run: dt at rest
constexpr double backward = 1e-6;           ///< share of the end over which the direction of loading is taken
constexpr double rest_difference = 1e-5;    ///< central: error about 1e-10, round-off about 1e-11
constexpr double neutral_threshold = 1e-8;  ///< of the largest eigenvalue: what differences can tell from zero
constexpr double coarse_noise = 1e-4;       ///< relative noise of fine differences from which coarse ones are taken

/// Steps of strain. The state is settled first: a history's state is known to a tolerance, and only `update` itself
/// puts it exactly on a yield surface. Then a step along the path, and differences small against it.
struct Steps {
  double settle, base, difference;
};
constexpr Steps fine{1e-4, 1e-6, 2e-8};
constexpr Steps coarse{1e-2, 1e-2, 1e-3};  ///< for a model in single precision

/// State and place at one point of a path.
struct Place {
  double xi, t;
  std::vector<double> state;
};

/// One screening: what does not change from place to place.
class Screen {
 public:
  Screen(const Material& material, const Path& path, double end) : material_(material), path_(path), end_(end) {
    breaks_ = path.reversals(end);
    breaks_.insert(breaks_.begin(), 0.0);
    breaks_.push_back(end);
    double fastest = 0;
    for (const double xi : {path.parameter.lower, path.parameter.upper}) {
      for (std::size_t b = 0; b + 1 < breaks_.size(); ++b) {
        const Tensor change = path.deformation_gradient(xi, breaks_[b + 1]) - path.deformation_gradient(xi, breaks_[b]);
        fastest = std::max(fastest, change.norm() / (breaks_[b + 1] - breaks_[b]));
      }
    }
    rate_ = fastest;
  }

  StabilityScreen run() {
    StabilityScreen screen;
    const AcousticExtreme rest = at_rest();
    screen.smallest = scale_ > 0 ? rest.value / scale_ : 0;
    if (std::abs(rest.value) <= noise_floor_) {
      screen.verdict = StabilityScreen::Verdict::neutral;
      return screen;
    }
    if (rest.value < 0) {
      screen.verdict = StabilityScreen::Verdict::unstable;
      screen.normal = rest.normal;
      screen.safe_fraction = 0;
      return screen;
    }
    follow(screen);
    return screen;
  }

 private:
  /// The smallest eigenvalue at rest; the scale of all others, and what differences cannot tell from zero.
  AcousticExtreme at_rest() {
    const std::vector<double> state = material_.initial_state(1, {}, path_.material_direction);
    const Tensor I = Tensor::Identity();
    const double dt = share_of_end * end_;
    const auto probed = [&](double step, double size) {
      return probe_tangent_modulus(material_, 0, step, I, I, state, size);
    };
    const TangentModulus one = probed(dt, fine.difference), other = probed(dt, 3 * fine.difference);
    const double noise = (one - other).norm() / one.norm();
    if (!(noise < coarse_noise)) steps_ = coarse;
    const double size = std::max(rest_difference, steps_.difference);
    TangentModulus A = probed(dt, size);
    noise_floor_ = neutral_threshold * largest_acoustic_eigenvalue(A).value;
    if (steps_.difference == coarse.difference) {
      noise_floor_ = std::max(noise_floor_, 10 * (A - probed(dt, 3 * size)).norm());
    }
    // A viscous stress adds A_v / dt: it carries no wave, and two steps tell it from an elastic one
    if (material_.has(ASSAY_RATE_DEPENDENT)) A = 2 * probed(2 * dt, size) - A;
    scale_ = largest_acoustic_eigenvalue(A).value;
    return smallest_acoustic_eigenvalue(A);
  }

  /// Unit direction in which F moves on its way to the time t; zero where it stands still.
  Tensor loading(double xi, double t) const {
    const double before = std::max(0.0, t - backward * end_);
    const Tensor change = path_.deformation_gradient(xi, t) - path_.deformation_gradient(xi, before);
    const double size = change.norm();
    return size > 1e-14 ? Tensor(change / size) : Tensor(Tensor::Zero());
  }

  /// Smallest eigenvalue on the branch on which the path loads.
  AcousticExtreme at(const Place& place) const {
    const Tensor F = path_.deformation_gradient(place.xi, place.t), along = loading(place.xi, place.t);
    if (along.isZero(0)) return {scale_, Vector3::Zero()};
    const double dt = rate_ > 0 ? 1 / rate_ : end_;  // per unit of strain
    const Tensor start = F + steps_.settle * along;
    const std::vector<double> state = settled_state(place, F, start, dt);
    return smallest_acoustic_eigenvalue(probe_tangent_modulus(material_, place.t, steps_.base * dt, start,
                                                              start + steps_.base * along, state, steps_.difference));
  }

  std::vector<double> settled_state(const Place& place, const Tensor& F, const Tensor& start, double dt) const {
    if (place.state.empty()) return {};
    double F0[9], F1[9], cauchy[9];
    for (int c = 0; c < 9; ++c) F0[c] = component(F, c), F1[c] = component(start, c);
    std::vector<double> state(place.state.size());
    const double step = steps_.settle * dt;
    const UpdateReport report = material_.update(place.t, step, 1, F0, F1, place.state.data(), state.data(), cauchy);
    if (report.worst == ASSAY_FAILED) {
      throw MaterialFailure(report.message, place.xi, place.t,
                            failed_step(place.t, step, 1, 0, F0, F1, place.state.data(), state.size()));
    }
    return state;
  }

  /// What was found at every time (rows) and xi.
  struct Scan {
    std::vector<double> xi, times;
    std::vector<std::vector<AcousticExtreme>> found;
  };
  Scan scan(const std::vector<double>& xi, const std::vector<double>& times) const {
    DriverOptions options;
    options.tolerance = history_tolerance;
    const Histories h = integrate_histories(material_, path_, xi, times, options);
    Scan result{xi, times, {}};
    Place place{};
    place.state.resize(material_.state_size());
    for (std::size_t row = 0; row < times.size(); ++row) {
      std::vector<AcousticExtreme>& found = result.found.emplace_back();
      for (std::size_t p = 0; p < xi.size(); ++p) {
        for (std::size_t c = 0; c < place.state.size(); ++c) place.state[c] = h.points[row].state[c * xi.size() + p];
        place.xi = xi[p], place.t = times[row];
        try {
          found.push_back(at(place));
        } catch (MaterialFailure& failure) {
          failure.xi = place.xi;
          throw;
        }
      }
    }
    return result;
  }

  std::vector<double> sampled_times() const {
    std::vector<double> times;
    for (std::size_t b = 0; b + 1 < breaks_.size(); ++b) {
      for (int k = 1; k <= samples; ++k) times.push_back(breaks_[b] + (breaks_[b + 1] - breaks_[b]) * k / samples);
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

  static std::vector<double> between(double lower, double upper, int count) {
    std::vector<double> values;
    for (int k = 1; k <= count; ++k) values.push_back(k == count ? upper : lower + (upper - lower) * k / count);
    return values;
  }

  void follow(StabilityScreen& screen) const {
    const std::vector<double> shares = between(0, 1, fractions);
    const Scan whole = scan(shrunk(shares), sampled_times());
    for (std::size_t row = 0; row < whole.times.size(); ++row) {
      for (std::size_t p = 0; p < whole.xi.size(); ++p) {
        screen.smallest = std::min(screen.smallest, whole.found[row][p].value / scale_);
      }
    }
    if (screen.smallest > 0) return;
    screen.verdict = StabilityScreen::Verdict::unstable;
    locate(whole, screen);
    screen.safe_fraction = safe_share(whole, shares);
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
  double end_;
  std::vector<double> breaks_;
  double rate_ = 0;         ///< of F along the path [1/s]
  double scale_ = 1;        ///< largest eigenvalue at rest [Pa]
  double noise_floor_ = 0;  ///< [Pa]
  Steps steps_ = fine;
};

}  // namespace

StabilityScreen screen_stability(const Material& material, const Path& path, double end) {
  return Screen(material, path, end).run();
}

}  // namespace assay
