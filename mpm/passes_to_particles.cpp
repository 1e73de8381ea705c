// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_to_particles.hpp"

#include "mpm/bases.hpp"
#include "mpm/blocks.hpp"
#include "mpm/column_access.hpp"

namespace assay::mpm {

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

#define ASSAY_PASSES(BASIS, DIM)                                                    \
  template Pass<DIM> grid_to_particles_pass<BASIS<DIM>, DIM>(Transfer, bool, bool); \
  template Pass<DIM> velocity_gradient_pass<BASIS<DIM>, DIM>();

ASSAY_FOR_EACH_BASIS(ASSAY_PASSES)

}  // namespace assay::mpm
