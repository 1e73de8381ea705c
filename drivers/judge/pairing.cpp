// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/pairing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "drivers/judge/point_grid.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Between neighbours, of some points the median; 1 where there are none.
double spacing_of(const std::vector<Vector3>& X) {
  constexpr std::size_t looked_at = 49;
  std::vector<double> nearest;
  for (std::size_t k = 0; k < looked_at && k < X.size(); ++k) {
    const std::size_t at = k * X.size() / std::min(looked_at, X.size());
    double least = HUGE_VAL;
    for (std::size_t other = 0; other < X.size(); ++other) {
      const double distance = (X[other] - X[at]).squaredNorm();
      if (other != at && distance < least && distance > 0) least = distance;
    }
    if (std::isfinite(least)) nearest.push_back(std::sqrt(least));
  }
  if (nearest.empty()) return 1;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

}  // namespace

struct SeedFinder::ById {
  using IdAndSeed = std::pair<double, std::uint32_t>;
  std::vector<IdAndSeed> seeds;  ///< ascending
  bool all_different = true;

  explicit ById(const std::vector<double>& id) {
    for (std::uint32_t k = 0; k < id.size(); ++k) {
      if (!std::isnan(id[k])) seeds.emplace_back(id[k], k);
    }
    std::ranges::sort(seeds);
    all_different = std::ranges::adjacent_find(seeds, {}, &IdAndSeed::first) == seeds.end();
  }
};

struct SeedFinder::ByPlace {
  PointGrid grid;
  bool all_different = true;

  explicit ByPlace(const Seeds& seeds) : grid(seeds.X, seeds.spacing) {
    for (std::uint32_t k = 0; k < seeds.X.size() && all_different; ++k)
      all_different = !seeds.X[k].allFinite() || grid.nearest(seeds.X[k]) == k;
  }
};

SeedFinder::SeedFinder(const Seeds& seeds, Pairing pairing, ExactParticles& exact)
    : seeds_(seeds), pairing_(pairing), exact_(exact) {}

SeedFinder::~SeedFinder() = default;

FramePairs SeedFinder::operator()(const JudgedFrame& frame) {
  FramePairs found;
  seen_.assign(seeds_.X.size(), 0);
  found.pairs.reserve(frame.size());
  std::vector<Vector3> now;
  std::optional<PointGrid> positions;
  if (pairing_ == Pairing::nearest) {
    for (const PointFields& fields : exact_.at(seeds_.X, frame.t, false))
      now.emplace_back(fields.x[0], fields.x[1], exact_.dimension() == 3 ? fields.x[2] : 0);
    positions.emplace(now, seeds_.spacing);
  }
  for (std::uint32_t p = 0; p < frame.size(); ++p) {
    if (!frame.x[p].allFinite()) {
      ++found.not_numbers;
      if (const auto seed = identity_of(frame, p)) seen_[*seed] = 1;
      continue;
    }
    const std::optional<std::uint32_t> seed = positions ? positions->nearest(frame.x[p]) : identity_of(frame, p);
    if (!seed) {
      ++found.unknown;
      continue;
    }
    if (seen_[*seed]) {
      if (!positions) ++found.doubled;
      continue;
    }
    seen_[*seed] = 1;
    found.pairs.push_back({p, *seed});
  }
  if (!positions) {
    found.lost = static_cast<std::size_t>(std::count(seen_.begin(), seen_.end(), 0));
    return found;
  }
  // which ones are missing cannot be told, but how many are
  const std::size_t there = frame.size() - found.not_numbers, wanted = seeds_.X.size() - found.not_numbers;
  found.lost = wanted > there ? wanted - there : 0;
  found.doubled = there > wanted ? there - wanted : 0;
  return found;
}

/// Most codes keep the order of their particles.
std::optional<std::uint32_t> SeedFinder::identity_of(const JudgedFrame& frame, std::uint32_t p) {
  if (!frame.id.empty() && !seeds_.id.empty()) {
    if (!by_id_) by_id_ = std::make_unique<const ById>(seeds_.id);
    const double id = frame.id[p];
    if (by_id_->all_different && p < seeds_.id.size() && seeds_.id[p] == id) return p;
    const auto at = std::ranges::lower_bound(by_id_->seeds, id, {}, &ById::IdAndSeed::first);
    return at == by_id_->seeds.end() || at->first != id ? std::nullopt : std::optional(at->second);
  }
  if (frame.X.empty() || !frame.X[p].allFinite()) return std::nullopt;
  if (!by_place_) by_place_ = std::make_unique<const ByPlace>(seeds_);
  if (by_place_->all_different && p < seeds_.X.size() && seeds_.X[p] == frame.X[p]) return p;
  return by_place_->grid.nearest(frame.X[p]);
}

Seeds seeds_of(const JudgedRun& run, const ExactParticles& exact) {
  const JudgedFrame& first = run.frames.front();
  Seeds seeds;
  if (!run.map.seeds.empty()) {
    const JudgedFrame given = read_seeds(run.map.seeds, run.map);
    seeds = {given.X, given.id, given.volume, 0, "seeds are those of " + run.map.seeds};
  } else if (!first.X.empty()) {
    seeds = {first.X, first.id, first.volume, 0, "seeds are the reference positions of the first frame"};
  } else {
    seeds = {{},
             first.id,
             first.volume,
             0,
             "seeds are where the particles of the first frame come from by the exact motion, t = " +
                 rounded_text(first.t, 4) + " s: an error at that time is not seen"};
    for (const Vector3& x : first.x) seeds.X.push_back(exact.reference_of(x, first.t));
  }
  seeds.spacing = spacing_of(seeds.X);
  return seeds;
}

Pairing pairing_of(const JudgedRun& run, const Seeds& seeds) {
  const auto all = [&](auto member) {
    return std::ranges::all_of(run.frames, [&](const JudgedFrame& frame) { return !(frame.*member).empty(); });
  };
  if (all(&JudgedFrame::X)) return Pairing::reference_position;
  return all(&JudgedFrame::id) && !seeds.id.empty() ? Pairing::id : Pairing::nearest;
}

std::vector<Vector3> FramePairs::X(const JudgedFrame& frame, const Seeds& seeds, Pairing pairing) const {
  std::vector<Vector3> X;
  put_X(frame, seeds, pairing, X);
  return X;
}

void FramePairs::put_X(const JudgedFrame& frame, const Seeds& seeds, Pairing pairing, std::vector<Vector3>& X) const {
  X.clear();
  X.reserve(pairs.size());
  for (const Pair& pair : pairs)
    X.push_back(pairing == Pairing::reference_position ? frame.X[pair.particle] : seeds.X[pair.seed]);
}

}  // namespace assay::drivers
