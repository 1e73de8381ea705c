// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/tractions.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/basis/corners.hpp"
#include "mpm/effects/body_force.hpp"
#include "mpm/effects/surface_normals.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/step/surface_loads.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
Vec<Dim> times(const Mat<Dim>& A, const Vec<Dim>& v) {
  Vec<Dim> found{};
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) found[i] += A[i * Dim + j] * v[j];
  }
  return found;
}

template <int Dim>
Mat<Dim> tensor_of(const FieldState<Dim>& exact) {
  Mat<Dim> sigma;
  for (std::size_t c = 0; c < sigma.size(); ++c) sigma[c] = exact.sigma[stress_index<Dim>(c / Dim, c % Dim)];
  return sigma;
}

/// Where the corners of a piece are now, of a domain whose corners move.
template <int Dim>
auto corners_now(const State<Dim>& s, const SurfacePiece<Dim>& piece) {
  std::array<Vec<Dim>, SurfacePiece<Dim>::ends> x;
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (std::size_t d = 0; d < Dim; ++d)
      x[k][d] = s.column(Column::corners, static_cast<int>(Dim * piece.corners[k] + d))[piece.particle];
  }
  return x;
}

/// n ds of a piece for each of its ends: of the line or face between its corners where these move, else J F^-T N dA0 of
/// its particle in equal shares.
template <int Dim>
auto current_normals(const State<Dim>& s, const SurfacePiece<Dim>& piece) {
  std::array<Vec<Dim>, SurfacePiece<Dim>::ends> normals;
  if (s.has(Column::corners) && piece.on_corners) {
    normals = normals_of_ends(corners_now(s, piece), side_of(piece));
  } else {
    const Mat<Dim> F = s.template at<Dim * Dim>(Column::deformation_gradient, piece.particle);
    Vec<Dim> n = times<Dim>(inverse_transpose<Dim>(F, 1), piece.N_dA);  // of det F 1: the cofactor
    for (double& component : n) component /= static_cast<double>(normals.size());
    normals.fill(n);
  }
  return normals;
}

/// Forces on the ends of a piece, of whose middle the fields speak at `k` [N].
template <int Dim>
auto forces_on(const State<Dim>& s, const SurfacePiece<Dim>& piece, const auto& here, std::size_t k) {
  constexpr std::size_t ends = SurfacePiece<Dim>::ends;
  const Traction& traction = *s.setup.traction;
  const bool undeformed = traction.algorithm == TractionAlgorithm::undeformed_edges;
  std::array<Vec<Dim>, ends> forces;
  if (traction.form == TractionForm::reference && !undeformed) {
    Vec<Dim> force = times<Dim>(here.first_piola_kirchhoff(k), piece.N_dA);
    for (double& component : force) component /= static_cast<double>(ends);
    forces.fill(force);
    return forces;
  }
  auto normals = current_normals(s, piece);
  if (undeformed) {
    Vec<Dim> whole{};
    for (const auto& n : normals) {
      for (std::size_t d = 0; d < Dim; ++d) whole[d] += n[d];
    }
    const double share = length_of<Dim>(piece.N_dA) / length_of<Dim>(whole);
    for (auto& n : normals) {
      for (double& component : n) component *= share;
    }
  }
  const Mat<Dim> sigma = tensor_of<Dim>(here.state(k));
  for (std::size_t e = 0; e < ends; ++e) forces[e] = times<Dim>(sigma, normals[e]);
  return forces;
}

/// Where the force of a piece acts: the reference vectors from the particle, and at which of its ends; -1: at all.
template <int Dim>
std::vector<SurfacePoint<Dim>> points_of(const State<Dim>& s, const SurfacePiece<Dim>& piece) {
  const auto from_particle = [&](const std::array<double, Dim>& X) {
    Vec<Dim> offset;
    for (std::size_t d = 0; d < Dim; ++d) offset[d] = X[d] - s.setup.seeds.X[d][piece.particle];
    return offset;
  };
  const bool at_particles = s.setup.traction->algorithm == TractionAlgorithm::particles;
  if (at_particles || traits_of<Dim>(s.method.basis).is_spline()) {
    return {{piece.particle, -1, at_particles ? Vec<Dim>{} : from_particle(piece.middle), -1}};
  }
  std::vector<SurfacePoint<Dim>> points;
  for (std::size_t k = 0; k < SurfacePiece<Dim>::ends; ++k) {
    const int corner = piece.on_corners ? piece.corners[k] : -1;
    points.push_back({piece.particle, corner, from_particle(piece.X[k]), static_cast<int>(k)});
  }
  return points;
}

/// x of a point of the surface: where its corner is, or by its particle's F.
template <int Dim>
Vec<Dim> position_of(const State<Dim>& s, const SurfacePoint<Dim>& point, bool in_reference) {
  const std::size_t p = point.particle;
  Vec<Dim> x;
  if (s.has(Column::corners) && point.corner >= 0) {
    for (std::size_t d = 0; d < Dim; ++d) x[d] = s.column(Column::corners, Dim * point.corner + static_cast<int>(d))[p];
    return x;
  }
  x = s.template at<Dim>(in_reference ? Column::reference_position : Column::position, p);
  for (std::size_t i = 0; i < Dim; ++i) {
    if (in_reference) x[i] += point.offset[i];
    for (std::size_t j = 0; !in_reference && j < Dim; ++j)
      x[i] += s.column(Column::deformation_gradient, i * Dim + j)[p] * point.offset[j];
  }
  return x;
}

/// What the surface gives to the accounts: impulse and its moment.
template <int Dim>
void book(State<Dim>& s, const SurfacePoint<Dim>& point, double kick) {
  for (std::size_t d = 0; d < Dim; ++d) s.ledger.impulse[d] += kick * point.force[d];
  add_moment(s.ledger.angular_impulse, kick, position_of(s, point, false), point.force);
}

/// Forces of the pieces, shared out to the points of the surface.
template <int Dim>
void load_points(State<Dim>& s, SurfaceLoads<Dim>& loads, const InstantOf<Dim>& field) {
  std::size_t k = 0;
  const std::vector<SurfacePiece<Dim>>& surface = s.setup.seeds.surface;
  for (std::size_t begin = 0; begin < surface.size(); begin += block_size) {
    const std::size_t end = std::min(surface.size(), begin + block_size);
    const auto& here = field.window(begin, end);
    for (std::size_t e = begin; e < end; ++e) {
      const auto forces = forces_on(s, surface[e], here, e);
      for (; k < loads.points.size() && loads.points[k].piece == &surface[e]; ++k) {
        SurfacePoint<Dim>& point = loads.points[k];
        if (point.end >= 0) {
          point.force = forces[static_cast<std::size_t>(point.end)];
          continue;
        }
        point.force = {};
        for (const Vec<Dim>& force : forces) {
          for (std::size_t d = 0; d < Dim; ++d) point.force[d] += force[d];
        }
      }
    }
  }
}

/// The middles of the pieces, and the exact fields there.
template <int Dim>
struct Middles {
  std::array<std::vector<double>, Dim> X;
  std::shared_ptr<InstantOf<Dim>> field;

  explicit Middles(const State<Dim>& s) {
    std::array<std::span<const double>, Dim> places;
    for (std::size_t d = 0; d < Dim; ++d) {
      for (const SurfacePiece<Dim>& piece : s.setup.seeds.surface) X[d].push_back(piece.middle[d]);
      places[d] = X[d];
    }
    field = fields_at<Dim>(s, places, {.stress = true});
  }
};

template <int Dim>
void find_loads(State<Dim>& s) {
  std::vector<SurfacePoint<Dim>> points;
  for (const SurfacePiece<Dim>& piece : s.setup.seeds.surface) {
    for (SurfacePoint<Dim>& point : points_of(s, piece)) {
      point.piece = &piece;
      points.push_back(point);
    }
  }
  const bool at_particles = s.setup.traction->algorithm == TractionAlgorithm::particles;
  place_loads(s, std::move(points), at_particles);
}

/// Tractions of the exact motion to the grid's forces; with accounts their impulse, too.
template <int Dim>
Pass<Dim> traction_pass(const Method& method, const Traction& traction, bool accounts) {
  Pass<Dim> pass;
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
  if (traits_of<Dim>(method.basis).moves_corners) pass.reads.push_back(Column::corners);
  pass.grid_fields = {"force"};
  pass.bind = [accounts](State<Dim>& s) -> Kernel {
    find_loads(s);
    auto& loads = s.template own<SurfaceLoads<Dim>>();
    s.markers.emplace_back([&loads](LiveNodes<Dim>& live) {  // what nodes of their own were given is yet to be cleared
      for (std::size_t k = 0; k < loads.points.size(); ++k) live.mark(loads.reach(k));
    });
    return [&s, &loads, accounts, middles = std::make_shared<Middles<Dim>>(s)](const Instant& now) {
      middles->field->set_time(time_of_forces(s.method, now));
      load_points(s, loads, *middles->field);
      for (std::size_t k = 0; k < loads.points.size(); ++k) {
        SurfacePoint<Dim>& point = loads.points[k];
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
template <int Dim>
Pass<Dim> traction_work_pass() {
  Pass<Dim> pass;
  pass.name = "traction_work";
  pass.slot = {Phase::grid, Part::last};
  pass.stages = Stages::kicks;
  pass.doc = "work of the tractions with the velocity that they leave";
  pass.called_for_by = "output.accounts";
  pass.effects = {"energy_account"};
  pass.grid_fields = {"velocity"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    return [&s, &loads = s.template own<SurfaceLoads<Dim>>()](const Instant& now) {
      for (std::size_t k = 0; k < loads.points.size(); ++k) {
        const Vec<Dim> v = loads.velocity(k, s.motion.data()), &f = loads.points[k].force;
        double power = 0;
        for (std::size_t d = 0; d < Dim; ++d) power += f[d] * v[d];
        s.ledger.external_work += now.kick * power;
      }
    };
  };
  return pass;
}

}  // namespace

template <int Dim>
std::vector<Pass<Dim>> traction_passes(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> passes{traction_pass<Dim>(setup.method, *setup.traction, setup.accounts)};
  if (setup.accounts) passes.push_back(traction_work_pass<Dim>());
  return passes;
}

template <int Dim>
EffectRecord<Dim> edge_traction_effect() {
  return traction_effect<Dim, TractionAlgorithm::edges>(50, "tractions by the corners of the domains on the surface");
}

template EffectRecord<ASSAY_DIMENSION> edge_traction_effect();
template std::vector<Pass<ASSAY_DIMENSION>> traction_passes(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
