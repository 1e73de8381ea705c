// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/sheet_build.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace assay {

namespace {

/// Steps of the histories under a sheet are this much better than the sheet is asked to be.
constexpr double history_share = 1e-4;
constexpr double share_by_power = 1e-5;  ///< where their error would hide the last terms of series that fall slowly
constexpr double best_history_tolerance = 1e-13, best_with_kinks = 1e-12;
/// What is left out of the series of a table may cost tau, and d tau / d xi, this share of what is asked.
constexpr double tau_share = 0.2, dtau_share = 0.5;
constexpr double rounding_share = 1e-12;  ///< of tau: noise of the histories, which no series can follow
constexpr double asymptotic = 1e-6;       ///< of the largest tau: below, the tails of a series fall steadily
constexpr double worthwhile = 0.2;        ///< refining has helped where it left this much of what was left out
constexpr BandSize first_size{12, 10};
constexpr double least_growth = 1.3, most_growth = 3;
constexpr int overlap = 6;       ///< a half of a stretch needs this many nodes more than half of its nodes
constexpr int split_nodes = 40;  ///< a band or stretch that needs more is divided: two short series cost less than one
constexpr int most_parts = 16;
constexpr int most_halvings = 5;
constexpr double next_share = 0.05;  ///< of the shares, in a second round
constexpr int most_rounds = 2;
/// Values of tau in a round, shared by the bands: beyond, what is left is stated. And where another build may be
/// better.
constexpr std::int64_t most_sampled = 1500000, first_sampled = 250000;
constexpr std::size_t most_strays = 16;  ///< histories that fit no band, each looked at in a new search for bands

/// Nodes at which a series should have fallen to `goal`, from how fast its second half falls; never less than a little
/// more than it has.
int needed(std::span<const double> decay, double goal) {
  const auto n = static_cast<double>(decay.size());
  const std::size_t half = decay.size() / 2;
  const double early = *std::max_element(decay.begin() + static_cast<std::ptrdiff_t>(half), decay.end());
  const double tail = *std::max_element(decay.end() - 2, decay.end());
  if (!(tail > goal)) return static_cast<int>(std::ceil(least_growth * n));  // the breaks need more, not tau
  const double slope = std::log(early / tail) / (n - 2 - static_cast<double>(half));
  const double more = std::log(tail / goal) / slope;
  return static_cast<int>(std::ceil(std::clamp(n + more, least_growth * n, most_growth * n)));
}

HistoryOptions history_options(const SheetOptions& options, Watch watch) {
  const double best = watch == Telling::state ? best_with_kinks : best_history_tolerance;
  const double share = watch == Telling::power ? share_by_power : history_share;
  return {.tolerance = std::max(best, share * options.tolerance), .watch = watch.has_value()};
}

/// Of tau, nine components each.
std::int64_t values(const Band& band, BandSize size) {
  return static_cast<std::int64_t>(band.stretches()) * size.nodes_in_xi * size.nodes_in_t;
}

/// Tables of bands, refined and divided until what their series leave out is small enough.
class Resolver {
 public:
  Resolver(const Course& course, const SheetOptions& options, const HistoryOptions& history, std::int64_t most)
      : course_(course), options_(options), history_(history), most_(most) {}

  std::vector<BandSeries> resolve(const std::vector<Band>& bands, double share) {
    std::vector<BandSeries> first, tables;
    for (const Band& band : bands) {
      later_ = static_cast<double>(first_size.nodes_in_xi) * static_cast<double>(bands.size() - first.size() - 1);
      first.push_back(tabulated(band, first_size));
      tau_scale_ = std::max(tau_scale_, first.back().largest());
      dtau_scale_ = std::max(dtau_scale_, first.back().steepest());
    }
    share_ = share;
    later_ = 0;
    for (const BandSeries& table : first) later_ += expected(table);
    for (BandSeries& table : first) {
      later_ -= expected(table);
      budget_ = sampled_ + most_ / static_cast<std::int64_t>(first.size());
      refine(std::move(table), tables);
    }
    return tables;
  }

  std::int64_t calls() const { return calls_; }

  /// Whether the rounding of the histories, and not what was asked, set a goal: asking for more is in vain.
  bool meets_noise() const { return meets_noise_; }

 private:
  BandSeries tabulated(const Band& band, BandSize size) {
    const auto count = static_cast<double>(size.nodes_in_xi);
    BandSeries table(course_, band, size, history_,
                     reporting(course_.workers(options_.workers), options_,
                               {SheetProgress::Stage::histories, done_, done_ + count + later_}, count));
    done_ += count;
    calls_ += table.calls();
    sampled_ += values(band, size);
    return table;
  }

  /// Histories that a table is likely to need once more.
  double expected(const BandSeries& table) {
    const int nodes = table.size().nodes_in_xi;
    const double goal_in_xi = goal(table.band(), nodes, table.noise());
    const bool long_in_xi = std::max(table.tail_in_xi(), table.tail_of_breaks()) > goal_in_xi;
    return long_in_xi ? needed(table.decay_in_xi(), goal_in_xi) : table.tail_in_t() > goal_in_xi ? nodes : 0;
  }

  /// Of tau's last coefficients [Pa]: a derivative multiplies them by up to their number squared.
  double goal(const Band& band, int nodes, double noise) {
    const double of_tau = tau_share * tau_scale_;
    const double of_dtau = dtau_share * dtau_scale_ * band.map.xi.width() / (2.0 * nodes * nodes);
    const double asked = share_ * options_.tolerance * std::min(of_tau, of_dtau);
    const double rounding = std::max(rounding_share, noise) * tau_scale_;
    meets_noise_ = meets_noise_ || rounding > asked;
    return std::max(rounding, asked);
  }

  /// halvings: how often its band has been halved.
  void refine(BandSeries table, std::vector<BandSeries>& tables, int halvings = 0) {
    double before = -1;
    while (true) {
      Band band = table.band();
      BandSize size = table.size();
      const double tail_in_xi = std::max(table.tail_in_xi(), table.tail_of_breaks());
      const double tail = std::max(tail_in_xi, table.tail_in_t());
      const double goal_in_xi = goal(band, size.nodes_in_xi, table.noise());
      const double goal_in_t = goal(band, table.any_moves() ? size.nodes_in_t : 4, table.noise());
      const bool long_in_xi = tail_in_xi > goal_in_xi, long_in_t = table.tail_in_t() > goal_in_t;
      const bool coarse = tail > asymptotic * table.largest();  // too coarse for its tails to tell anything
      const bool helps = before < 0 || coarse || tail < worthwhile * before;
      if ((!long_in_xi && !long_in_t) || !helps || sampled_ > budget_) return tables.push_back(std::move(table));
      before = tail;
      if (long_in_xi) size.nodes_in_xi = needed(table.decay_in_xi(), goal_in_xi);
      if (long_in_t) size.nodes_in_t = needed(table.decay_in_t(), goal_in_t);
      while (size.nodes_in_t > split_nodes && band.parts < most_parts) {
        band.parts *= 2;
        size.nodes_in_t = size.nodes_in_t / 2 + overlap;
        before = -1;
      }
      if (size.nodes_in_xi > split_nodes && halvings < most_halvings) {
        return refine_halves(band, size, tables, halvings + 1);
      }
      if (std::max(size.nodes_in_xi, size.nodes_in_t) > options_.most_nodes ||
          sampled_ + values(band, size) > budget_) {
        return tables.push_back(std::move(table));
      }
      table = tabulated(band, size);
    }
  }

  void refine_halves(const Band& band, BandSize size, std::vector<BandSeries>& tables, int halvings) {
    const double middle = band.map.xi_of(0.5);
    Band lower = band, upper = band;
    lower.map.xi.upper = upper.map.xi.lower = middle;
    lower.map.grazes_upper = upper.map.grazes_lower = false;
    lower.parts = upper.parts = std::max(1, band.parts / 4);
    size.nodes_in_xi = split_nodes / 2;
    size.nodes_in_t = std::min(size.nodes_in_t, split_nodes);
    refine(tabulated(lower, size), tables, halvings);
    refine(tabulated(upper, size), tables, halvings);
  }

  const Course& course_;
  const SheetOptions& options_;
  HistoryOptions history_;
  std::int64_t most_;  ///< values of tau
  double tau_scale_ = 0, dtau_scale_ = 0, share_ = 1;
  double done_ = 0, later_ = 0;  ///< histories: followed, and expected beyond those that are followed now
  bool meets_noise_ = false;
  std::int64_t calls_ = 0, sampled_ = 0, budget_ = 0;
};

struct ResolvedBands {
  std::vector<BandSeries> tables;  ///< empty where the material's regimes cannot be followed
  bool meets_noise = false;
};

/// How one sheet is built.
struct Attempt {
  Watch watch;
  bool suffices = true;  ///< even where it does not reach what is asked, if no other was better
  std::int64_t most = most_sampled;
};

ResolvedBands resolved_bands(const Course& course, const SheetOptions& options, const Attempt& attempt, double share,
                             std::int64_t& calls) {
  const HistoryOptions history = history_options(options, attempt.watch);
  std::vector<double> strays;
  while (strays.size() <= most_strays) {
    Resolver resolver(course, options, history, attempt.most);
    try {
      const Workers workers = reporting(course.workers(options.workers), options, {}, 0);
      const auto bands = find_bands(course, history, strays, workers, calls);
      ResolvedBands resolved{resolver.resolve(bands, share), resolver.meets_noise()};
      calls += resolver.calls();
      return resolved;
    } catch (const StrayHistory& stray) {
      strays.push_back(stray.xi);
    } catch (const RegimesFlicker&) {
      break;
    }
  }
  return {};
}

bool reached(const SheetError& error, const SheetOptions& options) {
  return error.tau <= options.tolerance && error.dtau <= options.tolerance;
}

double worst(const BuiltBands& built) { return std::max(built.error.tau, built.error.dtau); }

/// Refines as long as it helps.
BuiltBands build(const Material& material, const Path& path, const SheetOptions& options, const Attempt& attempt) {
  const Watch& watch = attempt.watch;
  const Course course(material, path, options.end, watch ? Form::increments : Form::automatic,
                      watch.value_or(Telling::state));
  BuiltBands best;
  best.watch = watch;
  double share = 1;
  for (int round = 0; round < most_rounds; ++round, share *= next_share) {
    ResolvedBands resolved = resolved_bands(course, options, attempt, share, best.calls);
    if (resolved.tables.empty()) break;
    const SheetError error = error_of(resolved.tables, material, path, options, watch, best.calls);
    if (!best.tables.empty() && !(std::max(error.tau, error.dtau) < 0.7 * worst(best))) break;
    best.tables = std::move(resolved.tables);
    best.error = error;
    if (reached(error, options) || resolved.meets_noise) break;
  }
  return best;
}

/// Ways to build a sheet, the likeliest first. A material that declares
/// kinks may have regimes that flicker and cannot be followed; one that does not may be less smooth than it says, and
/// is so where a number of its state stays as it is in some steps and changes in others.
std::vector<Attempt> attempts(const Material& material, const Path& path, double end) {
  const bool tells = RegimeReader(material.table()).tells();
  if (material.has(ASSAY_NON_SMOOTH) && material.state_size() > 0) return {{.watch = Telling::state}, {.watch = {}}};
  if (material.has(ASSAY_RATE_DEPENDENT) && material.state_size() > 0) {
    return {{.watch = {}, .suffices = false, .most = first_sampled}, {.watch = Telling::power}, {.watch = {}}};
  }
  if (tells && has_kinks(material, path, end)) return {{.watch = Telling::state}, {.watch = {}}};
  if (tells) return {{.watch = {}, .suffices = false}, {.watch = Telling::state}};
  return {{.watch = {}}};
}

}  // namespace

Workers reporting(Workers workers, const SheetOptions& options, const SheetProgress& before, double count) {
  if (!options.report) return workers;
  workers.poll = [poll = workers.poll, &report = options.report, now = before, before, count,
                  at_once = workers.threads]() mutable {
    if (poll) poll();
    report(now);
    now.done = std::min(now.done + at_once, before.done + count);
  };
  return workers;
}

BuiltBands build_bands(const Material& material, const Path& path, const SheetOptions& options) {
  BuiltBands best;
  std::int64_t calls = 0;
  for (const Attempt& attempt : attempts(material, path, options.end)) {
    BuiltBands built = build(material, path, options, attempt);
    calls += built.calls;
    const bool better = best.tables.empty() || (!built.tables.empty() && worst(built) < worst(best));
    if (better) best = std::move(built);
    if (!best.tables.empty() && (reached(best.error, options) || (better && attempt.suffices))) break;
  }
  best.calls = calls;
  return best;
}

}  // namespace assay
