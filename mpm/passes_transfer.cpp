// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_transfer.hpp"

#include <cmath>

#include "mpm/basis_cpdi.hpp"
#include "mpm/basis_linear.hpp"
#include "mpm/basis_ugimp.hpp"
#include "mpm/blocks.hpp"

namespace assay::mpm {

namespace {

template <class B, int Dim>
B& basis_of(State<Dim>& s) {
  if (!s.basis) s.basis = std::make_shared<B>(s.setup.grid, s.setup.seeds.half_size, s.particles);
  return *static_cast<B*>(s.basis.get());
}

/// Pointers to the components of a column.
template <int N, int Dim>
std::array<double*, N> components(State<Dim>& s, Column which) {
  std::array<double*, N> pointers;
  for (int c = 0; c < N; ++c) pointers[static_cast<std::size_t>(c)] = s.column(which, c);
  return pointers;
}

template <std::size_t N>
std::array<double, N> load(const std::array<double*, N>& column, std::size_t p) {
  std::array<double, N> values;
  for (std::size_t c = 0; c < N; ++c) values[c] = column[c][p];
  return values;
}

/// Index of component (i, d) of the stress column: in plane strain 11, 12, 21, 22 come before 33.
template <int Dim>
constexpr std::size_t stress_index(std::size_t i, std::size_t d) {
  return i * Dim + d;
}

}  // namespace

template <class B, int Dim>
Pass<Dim> weights_pass() {
  Pass<Dim> pass;
  pass.name = "weights";
  pass.doc = "nodes, phi_ip and grad phi_ip of every particle, shared by the passes of the step";
  pass.called_for_by = "method.basis";
  pass.reads = {Column::position};
  if (B::uses_deformation) pass.reads.push_back(Column::deformation_gradient);
  pass.writes = {Column::weights};
  pass.bind = [](State<Dim>& s) -> Kernel {
    B& basis = basis_of<B>(s);
    return [&s, &basis](const Instant&) {
      const auto x = components<Dim>(s, Column::position);
      const auto F = components<Dim * Dim>(s, Column::deformation_gradient);
      FirstBad outside;
      for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
          if (!basis.place(p, load(x, p), B::uses_deformation ? load(F, p) : Mat<Dim>{})) outside.report(p);
        }
      });
      if (const auto p = outside.found()) {
        s.finding = Finding{Finding::Kind::unstable, "a particle or a corner of its domain left the grid",
                            static_cast<std::int64_t>(*p)};
      }
    };
  };
  return pass;
}

/// Particles that never move give the grid their mass once.
template <class B, int Dim>
std::vector<double> mass_of_held(const State<Dim>& s) {
  const Seeds<Dim>& seeds = s.setup.seeds;
  Mat<Dim> identity{};
  for (std::size_t d = 0; d < Dim; ++d) identity[d * Dim + d] = 1;
  GridField<1> mass;
  mass.allocate(s.setup.grid.nodes());
  B basis(s.setup.grid, seeds.half_size, 1);
  for (const auto& X : seeds.held) {
    if (basis.place(0, X, identity)) basis.template scatter<1, 0>(0, {s.setup.density * seeds.volume()}, {}, mass);
  }
  return std::vector<double>(mass.data(), mass.data() + mass.nodes());
}

template <class B, int Dim>
Pass<Dim> particles_to_grid_pass(bool hold_outside) {
  Pass<Dim> pass;
  pass.name = "particles_to_grid";
  pass.doc = "nodal mass and momentum";
  pass.called_for_by = "method";
  pass.reads = {Column::weights, Column::mass, Column::velocity};
  pass.grid_fields = {"mass", "momentum"};
  pass.bind = [hold_outside](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    if (hold_outside) s.held_mass = mass_of_held<B>(s);
    return [&s, &basis, hold_outside](const Instant&) {
      s.inertia.zero();
      if (hold_outside) {
        for (std::size_t i = 0; i < s.held_mass.size(); ++i) s.inertia.node(i)[0] = s.held_mass[i];
      }
      const double* mass = s.column(Column::mass);
      const auto v = components<Dim>(s, Column::velocity);
      for (std::size_t p = 0; p < s.particles; ++p) {
        std::array<double, Dim + 1> A;
        A[0] = mass[p];
        for (std::size_t d = 0; d < Dim; ++d) A[d + 1] = mass[p] * v[d][p];
        basis.template scatter<Dim + 1, 0>(p, A, {}, s.inertia);
      }
      s.inertia.reduce_ghosts();
    };
  };
  return pass;
}

template <class B, bool WithBody, int Dim>
void scatter_forces(State<Dim>& s, const B& basis) {
  s.force.zero();
  const auto F = components<Dim * Dim>(s, Column::deformation_gradient);
  const auto sigma = components<stress_components<Dim>>(s, Column::stress);
  const double *volume = s.column(Column::volume), *mass = s.column(Column::mass);
  std::array<double*, Dim> b{};
  if constexpr (WithBody) b = components<Dim>(s, Column::body_force);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double V = volume[p] * determinant<Dim>(load(F, p));
    std::array<double, Dim> A{};
    std::array<double, Dim * Dim> V_sigma;
    for (std::size_t i = 0; i < Dim; ++i) {
      if constexpr (WithBody) A[i] = mass[p] * b[i][p];
      for (std::size_t d = 0; d < Dim; ++d) V_sigma[i * Dim + d] = -V * sigma[stress_index<Dim>(i, d)][p];
    }
    basis.template scatter<Dim, Dim>(p, A, V_sigma, s.force);
  }
  s.force.reduce_ghosts();
}

template <class B, int Dim>
Pass<Dim> force_pass(bool with_body_force) {
  Pass<Dim> pass;
  pass.name = "grid_forces";
  pass.doc = with_body_force ? "nodal internal and body force" : "nodal internal force";
  pass.called_for_by = "method";
  pass.reads = {Column::weights, Column::stress, Column::volume, Column::deformation_gradient};
  if (with_body_force) {
    pass.reads.push_back(Column::mass);
    pass.reads.push_back(Column::body_force);
  }
  pass.grid_fields = {"force"};
  pass.bind = [with_body_force](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    if (with_body_force) return [&s, &basis](const Instant&) { scatter_forces<B, true>(s, basis); };
    return [&s, &basis](const Instant&) { scatter_forces<B, false>(s, basis); };
  };
  return pass;
}

/// `power`, where it is wanted: sum of m b . v by block, v the grid's velocity at the particle. (The FLIP particle's
/// own velocity is another one: with it the energy account would not close however short the step.)
template <class B, bool Flip, bool Gradient, int Dim>
void gather_motion(State<Dim>& s, const B& basis, double dt, std::vector<double>* power) {
  const auto x = components<Dim>(s, Column::position);
  const auto v = components<Dim>(s, Column::velocity);
  std::array<double*, Dim * Dim> L{};
  if constexpr (Gradient) L = components<Dim * Dim>(s, Column::velocity_gradient);
  constexpr int G = Gradient ? Dim : 0;
  const double* mass = s.column(Column::mass);
  std::array<double*, Dim> b{};
  if (power) b = components<Dim>(s, Column::body_force);
  FirstBad bad;
  for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t p = begin; p < end; ++p) {
      std::array<double, 2 * Dim> motion;
      std::array<double, G * Dim> gradient;
      basis.template gather<2 * Dim, G>(p, s.motion, motion, gradient);
      if (power) {
        for (std::size_t d = 0; d < Dim; ++d) sum += mass[p] * b[d][p] * motion[d];
      }
      double finite = 0;  // 0 times a number; not 0 where one of them is none
      for (std::size_t d = 0; d < Dim; ++d) {
        x[d][p] += dt * motion[d];
        v[d][p] = Flip ? v[d][p] + dt * motion[Dim + d] : motion[d];
        finite += 0 * (x[d][p] + v[d][p]);
      }
      if constexpr (Gradient) {
        for (std::size_t c = 0; c < Dim * Dim; ++c) L[c][p] = gradient[c];
      }
      if (!(finite == 0)) bad.report(p);
    }
    if (power) (*power)[begin / block_size] = sum;
  });
  if (power) {
    for (const double sum : *power) s.ledger.external_work += dt * sum;
  }
  if (const auto p = bad.found()) {
    s.finding = Finding{Finding::Kind::unstable, "a particle's position or velocity is not finite",
                        static_cast<std::int64_t>(*p)};
  }
}

template <class B, int Dim>
Pass<Dim> grid_to_particles_pass(Transfer transfer, bool with_velocity_gradient, bool with_work) {
  Pass<Dim> pass;
  pass.name = "grid_to_particles";
  pass.doc = transfer == Transfer::flip ? "positions by grid velocity, velocities by grid acceleration (FLIP)"
                                        : "positions and velocities by grid velocity (PIC)";
  pass.called_for_by = "method.transfer";
  pass.reads = {Column::weights, Column::position};
  if (transfer == Transfer::flip) pass.reads.push_back(Column::velocity);
  if (with_work) pass.reads.insert(pass.reads.end(), {Column::mass, Column::body_force});
  pass.writes = {Column::position, Column::velocity};
  if (with_velocity_gradient) pass.writes.push_back(Column::velocity_gradient);
  pass.grid_fields = {"velocity", "acceleration"};
  pass.bind = [transfer, with_velocity_gradient, with_work](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    const bool flip = transfer == Transfer::flip;
    const auto gather = with_velocity_gradient
                            ? (flip ? gather_motion<B, true, true, Dim> : gather_motion<B, false, true, Dim>)
                            : (flip ? gather_motion<B, true, false, Dim> : gather_motion<B, false, false, Dim>);
    const auto power = std::make_shared<std::vector<double>>((s.particles + block_size - 1) / block_size);
    return [&s, &basis, gather, power, with_work](const Instant& now) {
      gather(s, basis, now.dt, with_work ? power.get() : nullptr);
    };
  };
  return pass;
}

template <class B, int Dim>
Pass<Dim> velocity_gradient_pass() {
  Pass<Dim> pass;
  pass.name = "velocity_gradient";
  pass.doc = "L of the particles from the grid velocity";
  pass.called_for_by = "method.update";
  pass.reads = {Column::weights};
  pass.writes = {Column::velocity_gradient};
  pass.grid_fields = {"velocity"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    return [&s, &basis](const Instant&) {
      const auto L = components<Dim * Dim>(s, Column::velocity_gradient);
      for_blocks(s.particles, s.setup.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
          std::array<double, 2 * Dim> motion;
          std::array<double, Dim * Dim> gradient;
          basis.template gather<2 * Dim, Dim>(p, s.motion, motion, gradient);
          for (std::size_t c = 0; c < Dim * Dim; ++c) L[c][p] = gradient[c];
        }
      });
    };
  };
  return pass;
}

#define ASSAY_TRANSFER_PASSES(BASIS, DIM)                                           \
  template Pass<DIM> weights_pass<BASIS<DIM>, DIM>();                               \
  template Pass<DIM> particles_to_grid_pass<BASIS<DIM>, DIM>(bool);                 \
  template Pass<DIM> force_pass<BASIS<DIM>, DIM>(bool);                             \
  template Pass<DIM> grid_to_particles_pass<BASIS<DIM>, DIM>(Transfer, bool, bool); \
  template Pass<DIM> velocity_gradient_pass<BASIS<DIM>, DIM>();

ASSAY_TRANSFER_PASSES(LinearBasis, 2)
ASSAY_TRANSFER_PASSES(LinearBasis, 3)
ASSAY_TRANSFER_PASSES(UgimpBasis, 2)
ASSAY_TRANSFER_PASSES(UgimpBasis, 3)
ASSAY_TRANSFER_PASSES(CpdiBasis, 2)
ASSAY_TRANSFER_PASSES(CpdiBasis, 3)

}  // namespace assay::mpm
