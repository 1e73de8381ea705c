// SPDX-License-Identifier: BSD-3-Clause
// x = r e_r(Theta + phi) with r and phi linear in R within an element, F taken in its middle:
//   F = Q(phi) [[r', 0], [r phi', r/R]],  phi' = dphi/dR.
// Forces are the derivatives of the virtual work by the nodes' r and phi.
#include <algorithm>
#include <cmath>

#include "harness/perturbed/perturbed_body.hpp"

namespace assay {

namespace {

/// Two nodes: their radii, the angle of the second before the first, and the direction in the middle.
struct Element {
  Element(const Vector3& a, const Vector3& b, bool from_axis)
      : r1(std::hypot(a.x(), a.y())),
        r2(std::hypot(b.x(), b.y())),
        turn(from_axis ? 0 : std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y())) {
    second = {b.x() / r2, b.y() / r2};
    first = from_axis ? second : Direction{a.x() / r1, a.y() / r1};
    middle = at(0.5);
  }
  struct Direction {
    double c = 1, s = 0;
  };
  double r(double q) const { return (1 - q) * r1 + q * r2; }
  /// The angle is linear in q.
  Direction at(double q) const {
    const double angle = q * turn, c = std::cos(angle), s = std::sin(angle);
    return {first.c * c - first.s * s, first.s * c + first.c * s};
  }
  double r1, r2, turn;
  Direction first, second, middle;
};

class Ring final : public PerturbedBody {
 public:
  Ring(const Motion& motion, RingSupport support, int elements, double outside) {
    const Annulus ring = motion->polar()->ring();
    const double h = (ring.outer - ring.inner) / elements;
    const bool whole = support == RingSupport::free_outside;
    const int inside = whole ? static_cast<int>(std::ceil(ring.inner / h)) : 0;
    const int beyond = whole ? static_cast<int>(std::ceil(std::max(outside - ring.outer, 0.0) / h)) : 0;
    for (int k = 0; k < inside; ++k) nodes.emplace_back(ring.inner * k / inside, 0, 0);
    for (int k = 0; k <= elements; ++k) nodes.emplace_back(ring.inner + k * h, 0, 0);
    for (int k = 1; k <= beyond; ++k) nodes.emplace_back(ring.outer + k * h, 0, 0);
    held.assign(nodes.size(), {false, false});
    if (support == RingSupport::held) held.front() = held.back() = {true, true};
    on_axis_ = inside > 0;
    if (on_axis_) held.front() = {true, true};
    edge = h;
    for (std::size_t e = 0; e + 1 < nodes.size(); ++e) {
      const double R1 = nodes[e].x(), R2 = nodes[e + 1].x();
      edge = std::min(edge, R2 - R1);
      weights.push_back(0.5 * (R1 + R2) * (R2 - R1));
      for (const double q : middle_points) {
        MeshPoint point;
        point.X = {(1 - q) * R1 + q * R2, 0, 0};
        point.weight = 0.5 * (R2 - R1) * point.X.x();
        point.node = {e, e + 1, 0, 0}, point.share = {1 - q, q, 0, 0};
        loads.push_back(point), samples.push_back(point.X);
      }
    }
    if (whole) return;
    for (const bool last : {false, true}) {
      MeshPoint face;
      const std::size_t node = last ? nodes.size() - 1 : 0;
      face.X = nodes[node], face.weight = face.X.x();
      face.node = {node, node, 0, 0}, face.share = {1, 0, 0, 0};
      face.normal = {last ? 1.0 : -1.0, 0, 0};
      surface.push_back(face);
    }
  }

  void deformation(const std::vector<Vector3>& x, std::vector<Tensor>& F) const override {
    F.resize(weights.size());
    for (std::size_t e = 0; e < weights.size(); ++e) {
      const Element element = at(x, e);
      const auto [c, s] = element.middle;
      const auto [rr, tr, tt] = in_its_frame(element, e);
      F[e] << c * rr - s * tr, -s * tt, 0, s * rr + c * tr, c * tt, 0, 0, 0, 1;
    }
  }

  void add_stress(const std::vector<Vector3>& x, const std::vector<Tensor>& stress,
                  std::vector<Vector3>& force) const override {
    for (std::size_t e = 0; e < weights.size(); ++e) {
      const Element element = at(x, e);
      const auto [c, s] = element.middle;
      const auto [F_rr, F_tr, F_tt] = in_its_frame(element, e);
      const Tensor& P = stress[e];
      const double rr = c * P(0, 0) + s * P(1, 0), rt = c * P(0, 1) + s * P(1, 1);
      const double tr = c * P(1, 0) - s * P(0, 0), tt = c * P(1, 1) - s * P(0, 1);
      const double h = width(e), r = element.r(0.5), R = 0.5 * (nodes[e].x() + nodes[e + 1].x()), w = weights[e];
      const double across = 0.5 * (tr * element.turn / h + tt / R);
      // of the frame's own turn; 0 where the Cauchy stress is symmetric
      const double spin = 0.5 * (tr * F_rr - rr * F_tr - rt * F_tt);
      add(force[e], element.first, -w * (-rr / h + across), -w * (-tr * r / h + spin), element.r1);
      add(force[e + 1], element.second, -w * (rr / h + across), -w * (tr * r / h + spin), element.r2);
    }
  }

  Vector3 position(const std::vector<Vector3>& x, const MeshPoint& point) const override {
    if (point.share[1] == 0) return x[point.node[0]];
    const Element element = at(x, point.node[0]);
    const double q = point.share[1], r = element.r(q);
    const auto [c, s] = element.at(q);
    return {r * c, r * s, 0};
  }

  void add_load(const std::vector<Vector3>& x, const MeshPoint& point, const Vector3& load,
                std::vector<Vector3>& force) const override {
    if (point.share[1] == 0) {
      force[point.node[0]] += load;
      return;
    }
    const Element element = at(x, point.node[0]);
    const double q = point.share[1];
    const auto [c, s] = element.at(q);
    const double along = load.x() * c + load.y() * s, torque = element.r(q) * (load.y() * c - load.x() * s);
    add(force[point.node[0]], element.first, (1 - q) * along, (1 - q) * torque, element.r1);
    add(force[point.node[1]], element.second, q * along, q * torque, element.r2);
  }

  Around around(const Vector3& X) const override {
    const double R = std::hypot(X.x(), X.y());
    auto next = std::ranges::lower_bound(samples, R, {}, [](const Vector3& sample) { return sample.x(); });
    if (next == samples.begin()) ++next;
    if (next == samples.end()) --next;
    const auto k = static_cast<std::size_t>(next - samples.begin());
    const double R1 = samples[k - 1].x(), R2 = samples[k].x();
    const double q = std::clamp((R - R1) / (R2 - R1), 0.0, 1.0);
    return {{k - 1, k, 0, 0}, {1 - q, q, 0, 0}, std::atan2(X.y(), X.x())};
  }

  Vector3 value_at(const std::vector<Vector3>& nodal, const Vector3& X) const override {
    const double R = std::hypot(X.x(), X.y());
    auto next = std::ranges::lower_bound(nodes, R, {}, [](const Vector3& node) { return node.x(); });
    if (next == nodes.begin()) return nodal.front();
    if (next == nodes.end()) return nodal.back();
    const auto k = static_cast<std::size_t>(next - nodes.begin());
    const double q = (R - nodes[k - 1].x()) / width(k - 1);
    return (1 - q) * nodal[k - 1] + q * nodal[k];
  }

 private:
  double width(std::size_t e) const { return nodes[e + 1].x() - nodes[e].x(); }
  Element at(const std::vector<Vector3>& x, std::size_t e) const { return {x[e], x[e + 1], on_axis_ && e == 0}; }
  /// F along e_r, e_theta in the middle: r', r phi', r/R; there is no r phi by Theta.
  std::array<double, 3> in_its_frame(const Element& element, std::size_t e) const {
    const double h = width(e), r = element.r(0.5);
    return {(element.r2 - element.r1) / h, r * element.turn / h, r / (0.5 * (nodes[e].x() + nodes[e + 1].x()))};
  }
  /// A force along the radius and a torque, on a node in that direction.
  static void add(Vector3& force, const Element::Direction& at, double along, double torque, double r) {
    const double across = r > 0 ? torque / r : 0;
    force += Vector3(along * at.c - across * at.s, along * at.s + across * at.c, 0);
  }

  bool on_axis_ = false;
};

}  // namespace

std::unique_ptr<PerturbedBody> perturbed_ring(const Motion& motion, RingSupport support, int elements, double outside) {
  return std::make_unique<Ring>(motion, support, elements, outside);
}

}  // namespace assay
