// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/traction_choice.hpp"

#include <cmath>

#include "drivers/input_error.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/simulation/body_ends.hpp"

namespace assay::drivers {

namespace {

constexpr double whole_pieces = 1e-9;  ///< a number of particles this close to a whole one [relative] is that one

}  // namespace

void require_surface(const Scene& scene) {
  const Body& body = scene.body;
  if (std::holds_alternative<Vortex>(scene.motion)) return;
  if (std::holds_alternative<TwistingRing>(scene.motion)) {
    if (body.lattice == Body::Lattice::polar || body.cut == Body::Cut::clipped) return;
    throw InputError(scene.place("body.cut"), "body.cut",
                     "tractions act on the ring's faces, which whole cells do not follow: take clipped, or lattice: "
                     "polar");
  }
  const auto ends = ends_of(scene);
  for (std::size_t d = 0; d < 2; ++d) {
    const double particle = scene.grid->spacing / body.per_cell[d];
    for (const bool upper : {false, true}) {
      const double corner = upper ? body.upper[d] : body.lower[d], pieces = corner / particle;
      if (upper ? ends[d].upper : ends[d].lower) continue;
      if (std::abs(pieces - std::round(pieces)) <= whole_pieces * std::abs(pieces)) continue;
      const std::string key = upper ? "body.upper" : "body.lower";
      throw InputError(scene.place(key), key,
                       "tractions act on the edges of the particles' domains: the corners must be multiples of "
                       "grid.spacing / body.per_cell = " +
                           rounded_text(particle, 6));
    }
  }
}

namespace {

/// Of the two forms of a traction the one that keeps the exact motion stable: P N dA0 where the body is stretched,
/// sigma n ds where it is compressed, on the mean of both principal directions when it is most deformed. Where some of
/// the body is stretched and some compressed P N dA0 holds longer (measured).
mpm::TractionForm stable_form(const Scene& scene) {
  constexpr int looks = 200;
  if (!is_homogeneous(scene.motion)) return mpm::TractionForm::reference;
  double most = 0;
  for (int k = 1; k <= looks; ++k) {
    const Tensor F = state_at(scene.motion, Vector3::Zero(), scene.time.end * k / looks).F;
    const double square = F.topLeftCorner<2, 2>().squaredNorm(), J = F.topLeftCorner<2, 2>().determinant();
    const double stretch = 0.5 * std::sqrt(square + 2 * J) - 1;  // (lambda1 + lambda2)/2 - 1
    if (std::abs(stretch) > std::abs(most)) most = stretch;
  }
  return most >= 0 ? mpm::TractionForm::reference : mpm::TractionForm::follower;
}

}  // namespace

std::optional<mpm::Traction> traction_of(Scene& scene) {
  const bool deformed = !std::holds_alternative<Vortex>(scene.motion) && !std::holds_alternative<Rigid>(scene.motion);
  if (!deformed || scene.force.response == ForceChoice::Response::none) return std::nullopt;
  if (!scene.traction.form) scene.traction.form = stable_form(scene);
  return mpm::Traction{scene.traction.algorithm, *scene.traction.form};
}

}  // namespace assay::drivers
