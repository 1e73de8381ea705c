// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/tractions.hpp"

#include "mpm/basis/corners.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/step/surface_loads.hpp"

namespace assay::mpm {

namespace {

Vec<2> times(const Mat<2>& A, const Vec<2>& v) { return {A[0] * v[0] + A[1] * v[1], A[2] * v[0] + A[3] * v[1]}; }

/// n ds of an edge: of the line between its corners where these move, else J F^-T N dA0 of its particle.
Vec<2> current_normal(const State<2>& s, const SurfaceEdge& edge) {
  if (s.has(Column::corners) && edge.on_corners) {
    const auto corner = [&](std::size_t k, std::size_t d) {
      return s.column(Column::corners, static_cast<int>(2 * edge.corners[k] + d))[edge.particle];
    };
    const double dx = corner(1, 0) - corner(0, 0), dy = corner(1, 1) - corner(0, 1);
    const double X = edge.X[1][0] - edge.X[0][0], Y = edge.X[1][1] - edge.X[0][1];
    const double side = Y * edge.N_dA[0] - X * edge.N_dA[1] > 0 ? 1 : -1;  // (dy, -dx) points out of the body, or in
    return {side * dy, -side * dx};
  }
  const Mat<2> cofactor = inverse_transpose<2>(s.at<4>(Column::deformation_gradient, edge.particle), 1);
  return {cofactor[0] * edge.N_dA[0] + cofactor[1] * edge.N_dA[1],
          cofactor[2] * edge.N_dA[0] + cofactor[3] * edge.N_dA[1]};
}

/// Force on an edge, of whose middle the field speaks at `k` [N].
Vec<2> force_on(const State<2>& s, const SurfaceEdge& edge, const ExactInstant& field, std::size_t k) {
  const Traction& traction = *s.setup.traction;
  const bool undeformed = traction.algorithm == TractionAlgorithm::undeformed_edges;
  if (traction.form == TractionForm::reference && !undeformed) return times(field.first_piola_kirchhoff(k), edge.N_dA);
  Vec<2> n = current_normal(s, edge);
  if (undeformed) {
    const double share = std::hypot(edge.N_dA[0], edge.N_dA[1]) / std::hypot(n[0], n[1]);
    for (double& component : n) component *= share;
  }
  const auto sigma = field.state(k).sigma;
  return times(Mat<2>{sigma[0], sigma[1], sigma[2], sigma[3]}, n);
}

/// Where the force of an edge acts: the reference vectors from the particle, and the shares.
std::vector<SurfacePoint> points_of(const State<2>& s, const SurfaceEdge& edge) {
  const auto from_particle = [&](const std::array<double, 2>& X) {
    return Vec<2>{X[0] - s.setup.seeds.X[0][edge.particle], X[1] - s.setup.seeds.X[1][edge.particle]};
  };
  if (s.setup.traction->algorithm == TractionAlgorithm::particles) return {{edge.particle, -1, {}, 1}};
  if (traits_of<2>(s.method.basis).is_spline()) return {{edge.particle, -1, from_particle(edge.middle), 1}};
  const auto corner = [&](std::size_t k) { return edge.on_corners ? edge.corners[k] : -1; };
  return {{edge.particle, corner(0), from_particle(edge.X[0]), 0.5},
          {edge.particle, corner(1), from_particle(edge.X[1]), 0.5}};
}

/// x of a point of the surface: where its corner is, or by its particle's F.
Vec<2> position_of(const State<2>& s, const SurfacePoint& point, bool in_reference) {
  const std::size_t p = point.particle;
  if (s.has(Column::corners) && point.corner >= 0) {
    return {s.column(Column::corners, 2 * point.corner)[p], s.column(Column::corners, 2 * point.corner + 1)[p]};
  }
  const Column at = in_reference ? Column::reference_position : Column::position;
  const Mat<2> F = in_reference ? Mat<2>{1, 0, 0, 1} : s.at<4>(Column::deformation_gradient, p);
  return {s.column(at, 0)[p] + F[0] * point.offset[0] + F[1] * point.offset[1],
          s.column(at, 1)[p] + F[2] * point.offset[0] + F[3] * point.offset[1]};
}

/// What the surface gives to the accounts: impulse and its moment.
void book(State<2>& s, const SurfacePoint& point, double kick) {
  const Vec<2> x = position_of(s, point, false);
  for (std::size_t d = 0; d < 2; ++d) s.ledger.impulse[d] += kick * point.force[d];
  s.ledger.angular_impulse += kick * (x[0] * point.force[1] - x[1] * point.force[0]);
}

/// Forces of the edges, shared out to the points of the surface.
void load_points(State<2>& s, SurfaceLoads& loads, const ExactInstant& field) {
  std::size_t k = 0;
  const std::vector<SurfaceEdge>& surface = s.setup.seeds.surface;
  for (std::size_t e = 0; e < surface.size(); ++e) {
    const SurfaceEdge& edge = surface[e];
    const Vec<2> force = force_on(s, edge, field, e);
    for (; k < loads.points.size() && loads.points[k].edge == &edge; ++k) {
      SurfacePoint& point = loads.points[k];
      point.force = {point.share * force[0], point.share * force[1]};
    }
  }
}

/// At the middles of the edges.
std::shared_ptr<ExactInstant> field_of(const State<2>& s) {
  std::vector<double> X, Y;
  for (const SurfaceEdge& edge : s.setup.seeds.surface) X.push_back(edge.middle[0]), Y.push_back(edge.middle[1]);
  return s.setup.exact->instant({X, Y}, {.stress = true});
}

void find_loads(State<2>& s) {
  std::vector<SurfacePoint> points;
  for (const SurfaceEdge& edge : s.setup.seeds.surface) {
    for (SurfacePoint& point : points_of(s, edge)) {
      point.edge = &edge;
      points.push_back(point);
    }
  }
  const bool at_particles = s.setup.traction->algorithm == TractionAlgorithm::particles;
  place_loads(s, std::move(points), at_particles);
}

/// Tractions of the exact motion to the grid's forces; with accounts their impulse, too.
Pass<2> traction_pass(const Method& method, const Traction& traction, bool accounts) {
  Pass<2> pass;
  pass.name = "traction";
  pass.slot = {Phase::forces, Part::last};
  pass.stages = Stages::kicks;
  const bool reference = traction.form == TractionForm::reference;
  pass.doc = std::string("tractions of the exact motion on the surface, ") +
             (traction.algorithm == TractionAlgorithm::undeformed_edges ? "sigma n times the undeformed length"
              : reference                                               ? "P N dA0"
                                                                        : "sigma n ds");
  pass.reads = {Column::position};
  if (!method.is_total() || !reference) pass.reads.push_back(Column::deformation_gradient);
  if (traits_of<2>(method.basis).moves_corners) pass.reads.push_back(Column::corners);
  pass.grid_fields = {"force"};
  pass.bind = [accounts](State<2>& s) -> Kernel {
    find_loads(s);
    auto& loads = s.own<SurfaceLoads>();
    s.markers.emplace_back([&loads](LiveNodes<2>& live) {  // what nodes of their own were given is yet to be cleared
      for (std::size_t k = 0; k < loads.points.size(); ++k) live.mark(loads.reach(k));
    });
    return [&s, &loads, accounts, field = field_of(s)](const Instant& now) {
      field->set_time(time_of_forces(s.method, now));
      load_points(s, loads, *field);
      for (std::size_t k = 0; k < loads.points.size(); ++k) {
        SurfacePoint& point = loads.points[k];
        if (!loads.place(k, position_of(s, point, s.method.is_total()))) {
          s.finding = Finding{Finding::Kind::unstable, "a point of the surface left the grid", point.particle};
          return;
        }
        loads.scatter(k, s.force.data());
        s.live.mark(loads.reach(k));
        if (accounts) book(s, point, now.kick);
      }
      s.live.merge();
    };
  };
  return pass;
}

/// Work of the tractions with the velocity that they leave.
Pass<2> traction_work_pass() {
  Pass<2> pass;
  pass.name = "traction_work";
  pass.slot = {Phase::grid, Part::last};
  pass.stages = Stages::kicks;
  pass.doc = "work of the tractions with the velocity that they leave";
  pass.called_for_by = "output.accounts";
  pass.effects = {"energy_account"};
  pass.grid_fields = {"velocity"};
  pass.bind = [](State<2>& s) -> Kernel {
    return [&s, &loads = s.own<SurfaceLoads>()](const Instant& now) {
      for (std::size_t k = 0; k < loads.points.size(); ++k) {
        const Vec<2> v = loads.velocity(k, s.motion.data()), &f = loads.points[k].force;
        s.ledger.external_work += now.kick * (f[0] * v[0] + f[1] * v[1]);
      }
    };
  };
  return pass;
}

}  // namespace

std::vector<Pass<2>> traction_passes(const Setup<2>& setup) {
  std::vector<Pass<2>> passes{traction_pass(setup.method, *setup.traction, setup.accounts)};
  if (setup.accounts) passes.push_back(traction_work_pass());
  return passes;
}

template <int Dim>
EffectRecord<Dim> edge_traction_effect() {
  return traction_effect<Dim, TractionAlgorithm::edges>(50, "tractions by the corners of the domains on the surface");
}

template EffectRecord<2> edge_traction_effect();
template EffectRecord<3> edge_traction_effect();

}  // namespace assay::mpm
