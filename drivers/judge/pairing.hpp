// SPDX-License-Identifier: BSD-3-Clause
// Which particle of a frame is which.
#pragma once

#include <memory>
#include <vector>

#include "drivers/judge/exact_particles.hpp"
#include "drivers/judge/judged_run.hpp"

namespace assay::drivers {

/// What is known of the particles before they move.
struct Seeds {
  std::vector<Vector3> X;          ///< [m]
  std::vector<double> id, volume;  ///< empty: not known
  double spacing = 0;              ///< between neighbours, about [m]
  std::string words;               ///< where they come from
};

/// By which particles are told.
enum class Pairing { reference_position, id, nearest };
/// Of the spacing: a larger error may be one of any size if each particle is taken for the nearest one. Of particles
/// anywhere it is 0.4.
inline constexpr double seen_by_nearest = 0.2;

/// Of a run's first frame, or of the file that the map names.
Seeds seeds_of(const JudgedRun& run, const ExactParticles& exact);

/// What the run offers.
Pairing pairing_of(const JudgedRun& run, const Seeds& seeds);

/// A particle of a frame and its seed.
struct Pair {
  std::uint32_t particle = 0, seed = 0;
};

struct FramePairs {
  std::vector<Pair> pairs;
  std::size_t lost = 0, doubled = 0, unknown = 0;  ///< seeds without a particle, and particles that are no seed's
  std::size_t not_numbers = 0;                     ///< particles whose position is none

  /// Reference positions of the pairs [m]; and the same in a vector that is there.
  std::vector<Vector3> X(const JudgedFrame& frame, const Seeds& seeds, Pairing pairing) const;
  void put_X(const JudgedFrame& frame, const Seeds& seeds, Pairing pairing, std::vector<Vector3>& X) const;
};

/// Finds the pairs of one frame after the other. Keeps what it is made of.
class SeedFinder {
 public:
  SeedFinder(const Seeds& seeds, Pairing pairing, ExactParticles& exact);
  ~SeedFinder();
  FramePairs operator()(const JudgedFrame& frame);

 private:
  std::optional<std::uint32_t> identity_of(const JudgedFrame& frame, std::uint32_t p);

  const Seeds& seeds_;
  Pairing pairing_;
  ExactParticles& exact_;
  std::vector<char> seen_;  ///< seeds, in one frame
  struct ById;
  struct ByPlace;
  std::unique_ptr<const ById> by_id_;  ///< made when they are first needed
  std::unique_ptr<const ByPlace> by_place_;
};

}  // namespace assay::drivers
