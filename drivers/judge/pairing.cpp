// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/pairing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Points in boxes of the size of their distance, for the nearest one.
class PointGrid {
 public:
  PointGrid(const std::vector<Vector3>& points, double size) : points_(points), size_(size > 0 ? size : 1) {
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      if (points[k].allFinite()) boxes_[key(box_of(points[k]))].push_back(k);
    }
  }

  /// None where no point lies in the boxes around.
  std::optional<std::uint32_t> nearest(const Vector3& at) const {
    std::optional<std::uint32_t> found;
    double least = std::numeric_limits<double>::infinity();
    const Box middle = box_of(at);
    for (int reach = 1; reach <= 2 && !found; ++reach) {
      for (long i = -reach; i <= reach; ++i) {
        for (long j = -reach; j <= reach; ++j) {
          for (long k = -reach; k <= reach; ++k) {
            const auto box = boxes_.find(key({middle[0] + i, middle[1] + j, middle[2] + k}));
            if (box == boxes_.end()) continue;
            for (const std::uint32_t point : box->second) {
              const double distance = (points_[point] - at).squaredNorm();
              if (distance < least) least = distance, found = point;
            }
          }
        }
      }
    }
    return found;
  }

 private:
  using Box = std::array<long, 3>;
  Box box_of(const Vector3& x) const {
    Box box;
    constexpr double most = 1e15;
    for (std::size_t d = 0; d < 3; ++d)
      box[d] = static_cast<long>(std::floor(std::clamp(x[static_cast<int>(d)] / size_, -most, most)));
    return box;
  }
  static std::size_t key(const Box& box) {
    std::size_t seed = 0;
    for (const long index : box) seed = seed * 0x9e3779b97f4a7c15u + static_cast<std::size_t>(index);
    return seed;
  }

  const std::vector<Vector3>& points_;
  double size_;
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> boxes_;
};

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

std::unordered_map<double, std::uint32_t> seed_by_id(const Seeds& seeds) {
  std::unordered_map<double, std::uint32_t> seed;
  for (std::uint32_t k = 0; k < seeds.id.size(); ++k) seed.emplace(seeds.id[k], k);
  return seed;
}

}  // namespace

struct SeedFinder::Found {
  std::unordered_map<double, std::uint32_t> by_id;
  PointGrid at_rest;
};

SeedFinder::SeedFinder(const Seeds& seeds, Pairing pairing, ExactParticles& exact)
    : seeds_(seeds),
      pairing_(pairing),
      exact_(exact),
      found_(new Found{seed_by_id(seeds), PointGrid(seeds.X, seeds.spacing)}) {}

SeedFinder::~SeedFinder() = default;

FramePairs SeedFinder::operator()(const JudgedFrame& frame) {
  FramePairs found;
  std::vector<char> seen(seeds_.X.size(), 0);
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
      if (const auto seed = identity_of(frame, p)) seen[*seed] = 1;
      continue;
    }
    const std::optional<std::uint32_t> seed = positions ? positions->nearest(frame.x[p]) : identity_of(frame, p);
    if (!seed) {
      ++found.unknown;
      continue;
    }
    if (seen[*seed]) {
      if (!positions) ++found.doubled;
      continue;
    }
    seen[*seed] = 1;
    found.pairs.push_back({p, *seed});
  }
  if (!positions) {
    found.lost = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), 0));
    return found;
  }
  // which ones are missing cannot be told, but how many are
  const std::size_t there = frame.size() - found.not_numbers, wanted = seeds_.X.size() - found.not_numbers;
  found.lost = wanted > there ? wanted - there : 0;
  found.doubled = there > wanted ? there - wanted : 0;
  return found;
}

std::optional<std::uint32_t> SeedFinder::identity_of(const JudgedFrame& frame, std::uint32_t p) const {
  if (!frame.id.empty() && !seeds_.id.empty()) {
    const auto at = found_->by_id.find(frame.id[p]);
    return at == found_->by_id.end() ? std::nullopt : std::optional(at->second);
  }
  if (frame.X.empty() || !frame.X[p].allFinite()) return std::nullopt;
  return found_->at_rest.nearest(frame.X[p]);
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
  for (const Pair& pair : pairs)
    X.push_back(pairing == Pairing::reference_position ? frame.X[pair.particle] : seeds.X[pair.seed]);
  return X;
}

}  // namespace assay::drivers
