// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/space_domains.hpp"

#include <algorithm>

#include "mpm/basis/basis_cpgimp.hpp"

namespace assay::drivers {

namespace {

using mpm::Column;

Vector3 sign_of(std::size_t corner) { return {corner & 1 ? 1.0 : -1, corner & 2 ? 1.0 : -1, corner & 4 ? 1.0 : -1}; }

}  // namespace

SpaceDomains::SpaceDomains(const ProblemIn<3>& problem) : seeds_(&problem.setup.seeds), kind_(Kind::deformed) {
  const Scene& scene = problem.scene;
  const mpm::Method& method = problem.setup.method;
  const mpm::BasisTraits basis = mpm::traits_of<3>(method.basis);
  const bool has_boxes = !method.is_total() && basis.domain_components == 3;
  if (basis.moves_corners) kind_ = Kind::corners;
  if (has_boxes) kind_ = basis.uses_deformation ? Kind::stretched_box : Kind::box;
  const double h = scene.grid->spacing;
  const auto per_cell = scene.body.per_cell.in<3>();
  turn_ = scene.frame ? scene.frame->rotation(0) : Tensor(Tensor::Identity());
  half_ = turn_ * Vector3(0.5 * h / per_cell[0], 0.5 * h / per_cell[1], 0.5 * h / per_cell[2]).asDiagonal();
  if (has_boxes) half_ = Vector3(seeds_->half_size.data()).asDiagonal();
  largest_half_ = h;
  if (scene.body.lattice == Body::Lattice::gauss && !has_boxes) gauss_.emplace(h, per_cell);
}

SpaceDomains::Now SpaceDomains::now(const ColumnView& of, bool keeps_corners) const {
  Now now;
  now.domains_ = this;
  for (int c = 0; c < 3; ++c) now.x_[static_cast<std::size_t>(c)] = of(Column::position, c);
  for (int c = 0; c < 9; ++c) now.F_[static_cast<std::size_t>(c)] = of(Column::deformation_gradient, c);
  for (int c = 0; kind_ == Kind::corners && keeps_corners && c < 24; ++c)
    now.corners_[static_cast<std::size_t>(c)] = of(Column::corners, c);
  return now;
}

SpaceDomains::Shape SpaceDomains::Now::shape(std::size_t p) const {
  const SpaceDomains& of = *domains_;
  if (corners_[0]) {
    Shape shape{Vector3::Zero(), Tensor::Zero()};
    for (std::size_t c = 0; c < 8; ++c) {
      const Vector3 x(corners_[3 * c][p], corners_[3 * c + 1][p], corners_[3 * c + 2][p]);
      shape.middle += 0.125 * x;
      shape.half += 0.125 * x * sign_of(c).transpose();
    }
    return shape;
  }
  Shape shape{{x_[0][p], x_[1][p], x_[2][p]}, of.half_};
  if (of.kind_ == Kind::box) return shape;
  std::array<double, 9> nine;
  for (std::size_t c = 0; c < 9; ++c) nine[c] = F_[c][p];
  if (of.kind_ == Kind::stretched_box) {
    const mpm::Vec<3> stretch = mpm::stretches_along_axes(nine);
    for (int d = 0; d < 3; ++d)
      shape.half(d, d) = std::min(shape.half(d, d) * stretch[static_cast<std::size_t>(d)], of.largest_half_);
    return shape;
  }
  const Tensor F = tensor_of(nine.data());
  if (of.gauss_) {
    const Vector3 X = of.turn_.transpose() * Vector3(of.seeds_->X[0][p], of.seeds_->X[1][p], of.seeds_->X[2][p]);
    const auto part = of.gauss_->box_around({X.x(), X.y(), X.z()});
    const Vector3 lower(part.lower.data()), upper(part.upper.data());
    shape.middle += F * of.turn_ * (0.5 * (lower + upper) - X);
    shape.half = of.turn_ * (0.5 * (upper - lower)).asDiagonal();
  }
  shape.half = F * shape.half;
  return shape;
}

SpaceDomains::Corners SpaceDomains::Now::corners(std::size_t p) const {
  Corners corners;
  if (corners_[0]) {
    for (std::size_t c = 0; c < 8; ++c)
      corners[c] = {corners_[3 * c][p], corners_[3 * c + 1][p], corners_[3 * c + 2][p]};
    return corners;
  }
  const Shape own = shape(p);
  for (std::size_t c = 0; c < 8; ++c) corners[c] = own.middle + own.half * sign_of(c);
  return corners;
}

}  // namespace assay::drivers
