// SPDX-License-Identifier: BSD-3-Clause
// Quadrilaterals with four nodes along the axes, and four points of stress each.
#include <algorithm>
#include <cmath>

#include "harness/perturbed/perturbed_body.hpp"

namespace assay {

namespace {

class Box final : public PerturbedBody {
 public:
  Box(const Motion& motion, const std::array<double, 2>& lower, const std::array<double, 2>& upper, int elements)
      : lower_(lower) {
    const double widest = std::max(upper[0] - lower[0], upper[1] - lower[1]);
    for (std::size_t d = 0; d < 2; ++d) {
      cells_[d] =
          std::max<std::size_t>(2, static_cast<std::size_t>(std::lround((upper[d] - lower[d]) / widest * elements)));
      h_[d] = (upper[d] - lower[d]) / static_cast<double>(cells_[d]);
    }
    edge = std::min(h_[0], h_[1]);
    for (std::size_t j = 0; j <= cells_[1]; ++j) {
      for (std::size_t i = 0; i <= cells_[0]; ++i) {
        nodes.emplace_back(lower[0] + h_[0] * static_cast<double>(i), lower[1] + h_[1] * static_cast<double>(j), 0);
        held.push_back({is_held(motion, 0, i), is_held(motion, 1, j)});
      }
    }
    samples = nodes;
    for (std::size_t j = 0; j < cells_[1]; ++j) {
      for (std::size_t i = 0; i < cells_[0]; ++i) {
        for (const double q : middle_points) {
          for (const double p : middle_points) {
            MeshPoint point = in_cell(i, j, p, q);
            point.weight = 0.25 * h_[0] * h_[1];
            loads.push_back(point), weights.push_back(point.weight);
          }
        }
      }
    }
    for (std::size_t d = 0; d < 2; ++d) {
      for (const bool last : {false, true}) add_face(motion, d, last);
    }
  }

  void deformation(const std::vector<Vector3>& x, std::vector<Tensor>& F) const override {
    F.assign(weights.size(), Tensor::Identity());
    for (std::size_t q = 0; q < weights.size(); ++q) {
      const auto slope = slopes(q);
      F[q](0, 0) = F[q](1, 1) = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Vector3& at = x[loads[q].node[k]];
        for (int i = 0; i < 2; ++i) {
          for (int J = 0; J < 2; ++J) F[q](i, J) += at[i] * slope[k][static_cast<std::size_t>(J)];
        }
      }
    }
  }

  void add_stress(const std::vector<Vector3>&, const std::vector<Tensor>& P,
                  std::vector<Vector3>& force) const override {
    for (std::size_t q = 0; q < weights.size(); ++q) {
      const auto slope = slopes(q);
      for (std::size_t k = 0; k < 4; ++k) {
        for (int i = 0; i < 2; ++i)
          force[loads[q].node[k]][i] -= weights[q] * (P[q](i, 0) * slope[k][0] + P[q](i, 1) * slope[k][1]);
      }
    }
  }

  Vector3 position(const std::vector<Vector3>& x, const MeshPoint& point) const override {
    return mean(x, point.node, point.share);
  }

  void add_load(const std::vector<Vector3>&, const MeshPoint& point, const Vector3& load,
                std::vector<Vector3>& force) const override {
    for (std::size_t k = 0; k < 4; ++k) force[point.node[k]] += point.share[k] * load;
  }

  Around around(const Vector3& X) const override {
    const MeshPoint point = at(X);
    return {point.node, point.share, 0};
  }

  Vector3 value_at(const std::vector<Vector3>& nodal, const Vector3& X) const override {
    const MeshPoint point = at(X);
    return mean(nodal, point.node, point.share);
  }

 private:
  bool is_held(const Motion& motion, std::size_t d, std::size_t k) const {
    const bool at_end = k == 0 || k == cells_[d];
    return at_end && motion->is_symmetry_plane(d, lower_[d] + h_[d] * static_cast<double>(k));
  }

  static Vector3 mean(const std::vector<Vector3>& values, const std::array<std::size_t, 4>& node,
                      const std::array<double, 4>& share) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 4; ++k) sum += share[k] * values[node[k]];
    return sum;
  }

  MeshPoint in_cell(std::size_t i, std::size_t j, double p, double q) const {
    const std::size_t row = cells_[0] + 1, first = j * row + i;
    MeshPoint point;
    point.X = {lower_[0] + h_[0] * (static_cast<double>(i) + p), lower_[1] + h_[1] * (static_cast<double>(j) + q), 0};
    point.node = {first, first + 1, first + row, first + row + 1};
    point.share = {(1 - p) * (1 - q), p * (1 - q), (1 - p) * q, p * q};
    return point;
  }

  /// Beyond the body the nearest cell goes on.
  MeshPoint at(const Vector3& X) const {
    std::array<std::size_t, 2> cell{};
    std::array<double, 2> place{};
    for (std::size_t d = 0; d < 2; ++d) {
      const double s = (X[static_cast<int>(d)] - lower_[d]) / h_[d];
      const double whole = std::clamp(std::floor(s), 0.0, static_cast<double>(cells_[d] - 1));
      cell[d] = static_cast<std::size_t>(whole), place[d] = s - whole;
    }
    return in_cell(cell[0], cell[1], place[0], place[1]);
  }

  void add_face(const Motion& motion, std::size_t d, bool last) {
    const std::size_t k = last ? cells_[d] : 0, other = 1 - d;
    if (is_held(motion, d, k)) return;
    for (std::size_t cell = 0; cell < cells_[other]; ++cell) {
      for (const double q : middle_points) {
        std::array<std::size_t, 2> of{};
        std::array<double, 2> place{};
        of[d] = last ? cells_[d] - 1 : 0, place[d] = last ? 1 : 0;
        of[other] = cell, place[other] = q;
        MeshPoint point = in_cell(of[0], of[1], place[0], place[1]);
        point.weight = 0.5 * h_[other];
        point.normal[static_cast<int>(d)] = last ? 1 : -1;
        surface.push_back(point);
      }
    }
  }

  /// d N / d X of the four nodes at a point of stress [1/m].
  std::array<std::array<double, 2>, 4> slopes(std::size_t q) const {
    const double a = middle_points[q % 2], b = middle_points[q / 2 % 2], u = 1 / h_[0], v = 1 / h_[1];
    return {{{-(1 - b) * u, -(1 - a) * v}, {(1 - b) * u, -a * v}, {-b * u, (1 - a) * v}, {b * u, a * v}}};
  }

  std::array<double, 2> lower_{}, h_{};
  std::array<std::size_t, 2> cells_{};
};

}  // namespace

std::unique_ptr<PerturbedBody> perturbed_box(const Motion& motion, const std::array<double, 2>& lower,
                                             const std::array<double, 2>& upper, int elements) {
  return std::make_unique<Box>(motion, lower, upper, elements);
}

}  // namespace assay
