// SPDX-License-Identifier: BSD-3-Clause
// A material on a path, prepared for any number of histories.
#include "harness/history/history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "harness/material/checked_update.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/state_variable.hpp"

namespace assay {

namespace {

constexpr int coarse_steps = 64;  ///< in each piece of the march that finds the scales
/// Of a piece: steps so short that a material is still in its first regime, or unloading after a reversal.
constexpr double short_from_rest = 1e-6, short_from_reversal = 1e-4;
constexpr double least_norm = 1e-12;  ///< of an increment of F: a model that tells by shorter ones is as good as exact
constexpr double followed_by = 8;     ///< shortest increments that tell, in a step to a state nearer to a solution
constexpr int most_steps_nearer = 4;
constexpr double telling_quantile = 0.75;  ///< of many states: at some, loading is nearly neutral

std::vector<double> pieces_of(const Path& path, double end) {
  std::vector<double> pieces{0};
  for (const double t : path.reversals(end)) pieces.push_back(t);
  pieces.push_back(end);
  return pieces;
}

/// One history, one plain step after the other.
class Marcher {
 public:
  Marcher(const Material& material, const Path& path, double xi, CoarseMarch& seen)
      : material_(material), path_(path), xi_(xi), seen_(seen) {
    state0_ = state_at_rest(material, path);
    cauchy0_ = nine_of(path.initial_cauchy);
    state1_.resize(state0_.size());
    F_ = path.deformation_gradient(xi, 0);
  }

  void march(const std::vector<double>& pieces) {
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const double begin = pieces[k], width = pieces[k + 1] - begin;
      try_short_step(begin, (k == 0 ? short_from_rest : short_from_reversal) * width);
      const double dt = width / coarse_steps;
      for (int j = 0; j < coarse_steps; ++j) {
        const Tensor next = path_.deformation_gradient(xi_, begin + (j + 1) * dt);
        if (!step(begin + j * dt, dt, F_, next)) return;  // whether shorter ones go on is for the histories to find
        note(seen_.signs.changes, [](char& changes, bool here) { changes = changes || here; });
        for (std::size_t c = 0; c < 9; ++c) grow(seen_.largest[c], cauchy_[c]);
        for (std::size_t c = 0; c < state1_.size(); ++c) grow(seen_.largest[9 + c], state1_[c]);
        state0_.swap(state1_);
        F_ = next;
      }
    }
  }

  /// Adds the shortest telling increment for each coarse step that follows one in the same regime.
  void march_tellingly(const std::vector<double>& pieces, const RegimeReader& reader,
                       std::vector<ShortestTelling>& all) {
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
      const double dt = (pieces[k + 1] - pieces[k]) / coarse_steps;
      std::uint64_t before = 0;
      for (int j = 0; j < coarse_steps; ++j) {
        const double t = pieces[k] + j * dt;
        const Tensor next = path_.deformation_gradient(xi_, t + dt);
        if (!step(t, dt, F_, next)) return;
        const std::vector<double> end = state1_;
        const std::array<double, 9> stress = cauchy_;
        const std::uint64_t regime = reader.of(state0_.data(), end.data());
        if (regime != 0 && regime == before) all.push_back(shortest_telling(reader, regime, t, dt));
        before = regime;
        state0_ = end;
        cauchy0_ = stress;
        F_ = next;
      }
    }
  }

 private:
  double norm(double t, double dt) const {
    return (path_.deformation_gradient(xi_, t + dt) - path_.deformation_gradient(xi_, t)).norm();
  }

  /// Whether an increment from state0_ reads as `regime`.
  bool reads(const RegimeReader& reader, std::uint64_t regime, double t, double dt) {
    return step(t, dt, path_.deformation_gradient(xi_, t), path_.deformation_gradient(xi_, t + dt)) &&
           reader.of(state0_.data(), state1_.data()) == regime;
  }

  /// By halving an increment of dt, which tells. The error of a long step may leave a state off the yield surface, from
  /// which no short increment reaches it: a short step is taken, and asked again. Leaves another state0_.
  ShortestTelling shortest_telling(const RegimeReader& reader, std::uint64_t regime, double t, double dt) {
    ShortestTelling shortest{norm(t, dt)};
    for (int count = 0; count < most_steps_nearer; ++count) {
      int low = 0, high = static_cast<int>(std::log2(std::max(norm(t, dt) / least_norm, 1.0)));
      if (reads(reader, regime, t, std::ldexp(dt, -high))) return {};
      double change = largest_change();
      while (high - low > 1) {
        const int middle = (low + high) / 2;
        const bool tells = reads(reader, regime, t, std::ldexp(dt, -middle));
        (tells ? low : high) = middle;
        if (!tells) change = largest_change();
      }
      const double found = std::ldexp(dt, -low), nearer = followed_by * found;
      if (count > 0 && norm(t, found) >= shortest.norm) break;
      shortest = {norm(t, found), 2 * change};
      if (nearer >= dt || !reads(reader, regime, t, nearer)) break;
      state0_.swap(state1_);
      cauchy0_ = cauchy_;
      t += nearer;
    }
    return shortest;
  }

  double largest_change() const {
    double largest = 0;
    for (std::size_t c = 0; c < 9; ++c) grow(largest, cauchy_[c] - cauchy0_[c]);
    return largest;
  }

  static void grow(double& largest, double value) { largest = std::max(largest, std::abs(value)); }

  bool step(double t, double dt, const Tensor& begin, const Tensor& end) {
    try {
      checked_update(material_, xi_, t, dt, 1, nine_of(begin).data(), nine_of(end).data(), state0_.data(),
                     state1_.data(), cauchy_.data());
    } catch (const MaterialFailure& failure) {
      if (failure.final) throw;
      return false;
    }
    return true;
  }

  void try_short_step(double t, double dt) {
    if (state0_.empty() || !step(t, dt, F_, path_.deformation_gradient(xi_, t + dt))) return;
    note(seen_.signs.always, [](char& always, bool here) { always = always && here; });
    note(seen_.signs.ever, [](char& ever, bool here) { ever = ever || here; });
    seen_.signs.any_start = true;
  }

  /// add(sign of a variable, whether the step from state0_ to state1_ has changed it).
  void note(std::vector<char>& signs, const auto& add) const {
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const StatePlace& place = places_[k];
      add(signs[k], variable_changes(place.kind, &state0_[place.first], &state1_[place.first]));
    }
  }

  const Material& material_;
  const Path& path_;
  double xi_;
  CoarseMarch& seen_;
  Tensor F_;
  std::vector<StatePlace> places_ = state_of(material_.table());
  std::vector<double> state0_, state1_;
  std::array<double, 9> cauchy0_ = {}, cauchy_ = {};
};

ShortestTelling shortest_telling(const Material& material, const Path& path, double end, const RegimeReader& reader) {
  std::vector<ShortestTelling> all;
  for (const double xi : {path.parameter.lower, path.parameter.upper}) {
    CoarseMarch seen;
    Marcher(material, path, xi, seen).march_tellingly(pieces_of(path, end), reader, all);
  }
  if (all.empty()) return {};
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(telling_quantile * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end(),
                   [](const ShortestTelling& a, const ShortestTelling& b) { return a.norm < b.norm; });
  return *at;
}

/// The largest over a group of components that belong together; 1 where all are zero.
void share_largest(std::vector<double>& values, std::size_t begin, std::size_t end) {
  double largest = 0;
  for (std::size_t c = begin; c < end; ++c) largest = std::max(largest, values[c]);
  for (std::size_t c = begin; c < end; ++c) values[c] = largest > 0 ? largest : 1;
}

/// Scalars without a unit may be the components of one tensor, of which some are nothing but rounding: of them all the
/// largest counts.
HistoryScales scales_of(const assay_material& table, std::vector<double> largest) {
  share_largest(largest, 0, 9);
  double of_nameless = 0;
  std::vector<std::size_t> nameless;
  for (const StatePlace& place : state_of(table)) {
    if (place.size == 1 && (!place.unit || !*place.unit)) {
      nameless.push_back(9 + place.first);
      of_nameless = std::max(of_nameless, largest[9 + place.first]);
    } else {
      share_largest(largest, 9 + place.first, 9 + place.end());
    }
  }
  for (const std::size_t at : nameless) largest[at] = of_nameless > 0 ? of_nameless : 1;
  return {largest[0], std::vector<double>(largest.begin() + 9, largest.end())};
}

const HistoriesElsewhere* elsewhere_of(const Material& material, const Path& path) {
  return path.recipe.empty() || path.recipe.size() > longest_recipe
             ? nullptr
             : material.extension<HistoriesElsewhere>(histories_elsewhere_id);
}

CoarseMarch seen_coarsely(const Material& material, const Path& path, double end) {
  const auto* elsewhere = elsewhere_of(material, path);
  return elsewhere ? elsewhere->coarse(material.self(), path, end) : march_coarsely(material, path, end);
}

CourseFacts facts_of(const Material& m, const Path& path, double end, Form form, Telling telling) {
  const bool has_rate = bool(Offer<assay_rate>(m));
  const bool by_rate = has_rate && (form == Form::rate || (form == Form::automatic && !m.has(ASSAY_NON_SMOOTH)));
  CoarseMarch seen = seen_coarsely(m, path, end);
  CourseFacts facts{end,
                    by_rate,
                    telling,
                    RegimeReader(m.table()),
                    scales_of(m.table(), std::move(seen.largest)),
                    telling == Telling::state ? seen.shortest : ShortestTelling{}};
  facts.regimes.settle(m.table(), seen.signs);
  return facts;
}

}  // namespace

CoarseMarch march_coarsely(const Material& material, const Path& path, double end) {
  CoarseMarch seen{std::vector<double>(9 + material.state_size(), 0.0), StateSigns(material.table().state_count)};
  for (const double xi : {path.parameter.lower, path.parameter.upper}) {
    Marcher(material, path, xi, seen).march(pieces_of(path, end));
  }
  RegimeReader reader(material.table());
  reader.settle(material.table(), seen.signs);
  if (reader.tells()) seen.shortest = shortest_telling(material, path, end, reader);
  return seen;
}

bool has_kinks(const Material& material, const Path& path, double end) {
  return any_scalar_tells(material.table(), seen_coarsely(material, path, end).signs);
}

Course::Course(const Material& m, const Path& p, double last, Form form, Telling by)
    : Course(m, p, facts_of(m, p, last, form, by)) {}

Course::Course(const Material& m, const Path& p, CourseFacts facts)
    : CourseFacts(std::move(facts)), material(&m), path(&p), pieces(pieces_of(p, end)), elsewhere(elsewhere_of(m, p)) {}

Workers Course::workers(Workers wanted) const {
  if (!material->has(ASSAY_THREAD_SAFE)) wanted.threads = 1;
  return wanted;
}

Interval Course::piece_at(double t) const {
  std::size_t k = 0;
  while (k + 2 < pieces.size() && t >= pieces[k + 1]) ++k;
  return {pieces[k], pieces[k + 1]};
}

}  // namespace assay
