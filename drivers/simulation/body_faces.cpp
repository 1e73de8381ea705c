// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/body_faces.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr double nearly_whole = 1e-9;  ///< a number this close to a whole one is that one

bool is_whole(double x) { return std::abs(x - std::round(x)) <= nearly_whole; }

void require_node(const Scene& scene, double at, const std::string& key) {
  const double h = scene.grid->spacing;
  if (is_whole(at / h)) return;
  refuse(scene, "grid.spacing",
         key + " = " + rounded_text(at, 6) +
             " is a symmetry plane or a periodic end, which must lie on a line of the grid: it is no multiple "
             "of " +
             rounded_text(h, 6));
}

void require_period(const Scene& scene, std::size_t d, double width) {
  const std::string fault = scene.motion->fault_of_period(d, width);
  if (!fault.empty()) refuse(scene, "body.periodic", fault);
}

/// Where a body's stretch is looked at: anywhere where F is the same everywhere; along the faces of a box that bear
/// tractions.
template <int Dim>
std::vector<Vector3> places_of_stretch(const Scene& scene) {
  if (scene.motion->is_homogeneous()) return {Vector3::Zero()};
  constexpr int pieces = 4;
  const auto ends = ends_of<Dim>(scene);
  std::vector<Vector3> places;
  for (std::size_t d = 0; d < Dim; ++d) {
    for (const bool upper : {false, true}) {
      if (upper ? ends[d].upper : ends[d].lower) continue;
      for (int k = 0; k < (Dim == 2 ? 1 : pieces + 1) * (pieces + 1); ++k) {
        Vector3 X = Vector3::Zero();
        X(static_cast<int>(d)) = upper ? scene.body.upper[d] : scene.body.lower[d];
        for (std::size_t other = 0, rest = static_cast<std::size_t>(k); other < Dim; ++other) {
          if (other == d) continue;
          const double width = scene.body.upper[other] - scene.body.lower[other];
          X(static_cast<int>(other)) =
              scene.body.lower[other] + width * static_cast<double>(rest % (pieces + 1)) / pieces;
          rest /= pieces + 1;
        }
        places.push_back(X);
      }
    }
  }
  return places;
}

/// Mean of the principal stretches: in the plane of both in it.
template <int Dim>
double mean_stretch(const Tensor& F) {
  if (Dim == 3) return Eigen::JacobiSVD<Tensor>(F).singularValues().mean();
  const double square = F.topLeftCorner<2, 2>().squaredNorm(), J = F.topLeftCorner<2, 2>().determinant();
  return 0.5 * std::sqrt(square + 2 * J);  // (lambda1 + lambda2)/2
}

/// Of the two forms of a traction the one that keeps the exact motion stable: P N dA0 where the body is stretched,
/// sigma n ds where it is compressed, as it is under an initial pressure; else on the mean of the principal directions
/// where and when it is most deformed. On a ring P N dA0, which holds in both, and on a clipped lattice longer
/// (measured).
template <int Dim>
mpm::TractionForm stable_form(const Scene& scene) {
  constexpr int looks = 200;
  const bool is_ring = Dim == 2 && scene.body.domain == Body::Domain::ring;
  const double pressure = -scene.initial_cauchy().trace();
  if (pressure != 0 && !is_ring) return pressure > 0 ? mpm::TractionForm::follower : mpm::TractionForm::reference;
  if (ring_of(scene.motion)) return mpm::TractionForm::reference;
  double most = 0;
  for (const Vector3& X : places_of_stretch<Dim>(scene)) {
    for (int k = 1; k <= looks; ++k) {
      const Tensor F = scene.motion->at(X, scene.time.end * k / looks).F;
      const double stretch = mean_stretch<Dim>(F) - 1;
      if (std::abs(stretch) > std::abs(most)) most = stretch;
    }
  }
  return most >= 0 ? mpm::TractionForm::reference : mpm::TractionForm::follower;
}

/// Ends stay with the grid, and a frame takes the body away from them. Where the motion bears tractions, these act on
/// the faces that would be symmetry planes.
void require_no_ends(const Scene& scene, std::size_t d, double lower, double upper) {
  const std::string along(1, "xyz"[d]);
  if (scene.body.is_periodic(d))
    refuse(scene, "frame", "moves the body against its periodic ends along " + along + ", which stay with the grid");
  const bool is_plane = scene.motion->is_symmetry_plane(d, lower) || scene.motion->is_symmetry_plane(d, upper);
  if (is_plane && !scene.bears_tractions())
    refuse(scene, "frame", "moves the body against its symmetry planes across " + along + ", which stay with the grid");
}

}  // namespace

template <int Dim>
std::array<mpm::AxisEnds, Dim> ends_of(const Scene& scene) {
  std::array<mpm::AxisEnds, Dim> ends;
  if (scene.body.is_vortex_alone() || (Dim == 2 && ring_of(scene.motion))) return ends;
  const auto box = body_box<Dim>(scene);
  for (std::size_t d = 0; d < Dim; ++d) {
    if (scene.frame) {
      require_no_ends(scene, d, box.lower[d], box.upper[d]);
    } else if (scene.body.is_periodic(d)) {
      require_period(scene, d, box.upper[d] - box.lower[d]);
      ends[d] = {box.lower[d], box.upper[d], true};
    } else {
      if (scene.motion->is_symmetry_plane(d, box.lower[d])) ends[d].lower = box.lower[d];
      if (scene.motion->is_symmetry_plane(d, box.upper[d])) ends[d].upper = box.upper[d];
    }
    if (ends[d].lower) require_node(scene, *ends[d].lower, "body.lower");
    if (ends[d].upper) require_node(scene, *ends[d].upper, "body.upper");
  }
  return ends;
}

template std::array<mpm::AxisEnds, 2> ends_of<2>(const Scene&);
template std::array<mpm::AxisEnds, 3> ends_of<3>(const Scene&);

namespace {

template <int Dim>
void require_corners_of_domains(const Scene& scene) {
  const Body& body = scene.body;
  const auto ends = ends_of<Dim>(scene);
  for (std::size_t d = 0; d < Dim; ++d) {
    const double particle = scene.grid->spacing / body.per_cell[d];
    for (const bool upper : {false, true}) {
      const double corner = upper ? body.upper[d] : body.lower[d], pieces = corner / particle;
      if (upper ? ends[d].upper : ends[d].lower) continue;
      if (std::abs(pieces - std::round(pieces)) <= nearly_whole * std::abs(pieces)) continue;
      const std::string key = upper ? "body.upper" : "body.lower";
      refuse(scene, key,
             std::string("tractions act on the ") + (Dim == 2 ? "edges" : "faces") +
                 " of the particles' domains: the corners must be multiples of grid.spacing / body.per_cell = " +
                 rounded_text(particle, 6));
    }
  }
}

}  // namespace

void require_surface(const Scene& scene) {
  const Body& body = scene.body;
  if (scene.dimension == 3) {
    if (body.domain == Body::Domain::vortex) return;
    if (!scene.bears_tractions()) {
      ends_of<3>(scene);
      return;
    }
    return require_corners_of_domains<3>(scene);
  }
  if (ring_of(scene.motion)) {
    if (!scene.bears_tractions() || body.lattice == Body::Lattice::polar || body.cut == Body::Cut::clipped) return;
    refuse(scene, "body.cut",
           "tractions act on the ring's faces, which whole cells do not follow: take clipped, or lattice: "
           "polar");
  }
  require_corners_of_domains<2>(scene);
}

std::optional<mpm::Traction> traction_of(Scene& scene) {
  if (!scene.bears_tractions() || scene.force.response == ForceChoice::Response::none) return std::nullopt;
  if (!scene.traction.form) scene.traction.form = scene.dimension == 3 ? stable_form<3>(scene) : stable_form<2>(scene);
  return mpm::Traction{scene.traction.algorithm, *scene.traction.form};
}

}  // namespace assay::drivers
