// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/passes_to_particles.hpp"

#include "mpm/affine.hpp"
#include "mpm/bases.hpp"
#include "mpm/blocks.hpp"
#include "mpm/column_access.hpp"

namespace assay::mpm {

/// The particle's velocity after the step: the grid's, its own and what the grid gains, or a blend.
enum class Velocity { of_grid, kept, blended };

/// `power`, where it is wanted: sum of m b . v by block, v the grid's velocity at the particle. (The FLIP particle's
/// own velocity is another one: with it the energy account would not close however short the step.)
template <class B, Velocity Kind, bool Gradient, int Dim>
void gather_motion(State<Dim>& s, const B& basis, const Instant& now, std::vector<double>* power) {
  const auto x = components<Dim>(s, Column::position);
  const auto v = components<Dim>(s, Column::velocity);
  std::array<double*, Dim * Dim> L{};
  if constexpr (Gradient) L = components<Dim * Dim>(s, Column::velocity_gradient);
  constexpr int G = Gradient ? Dim : 0;
  [[maybe_unused]] const double flip = s.setup.method.flip;
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
        x[d][p] += now.dt * motion[d];
        const double kept = v[d][p] + now.kick * motion[Dim + d];
        v[d][p] = Kind == Velocity::of_grid ? motion[d]
                  : Kind == Velocity::kept  ? kept
                                            : flip * kept + (1 - flip) * motion[d];
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
    for (const double sum : *power) s.ledger.external_work += now.dt * sum;
  }
  if (const auto p = bad.found()) {
    s.finding = Finding{Finding::Kind::unstable, "a particle's position or velocity is not finite",
                        static_cast<std::int64_t>(*p)};
  }
}

template <class B, int Dim>
auto gather_of(Velocity kind, bool gradient) {
  switch (kind) {
    case Velocity::of_grid:
      return gradient ? gather_motion<B, Velocity::of_grid, true, Dim>
                      : gather_motion<B, Velocity::of_grid, false, Dim>;
    case Velocity::kept:
      return gradient ? gather_motion<B, Velocity::kept, true, Dim> : gather_motion<B, Velocity::kept, false, Dim>;
    case Velocity::blended:
      break;
  }
  return gradient ? gather_motion<B, Velocity::blended, true, Dim> : gather_motion<B, Velocity::blended, false, Dim>;
}

template <class B, int Dim>
Pass<Dim> grid_to_particles_pass(const Method& method, bool with_velocity_gradient, bool with_work) {
  Pass<Dim> pass;
  pass.name = "grid_to_particles";
  pass.doc = !method.keeps_velocity() ? "positions and velocities by grid velocity"
             : method.flip == 1       ? "positions by grid velocity, velocities by grid acceleration"
                                      : "positions by grid velocity, velocities by both";
  pass.called_for_by = "method.transfer";
  pass.reads = {Column::weights, Column::position};
  if (method.keeps_velocity()) pass.reads.push_back(Column::velocity);
  if (with_work) pass.reads.insert(pass.reads.end(), {Column::mass, Column::body_force});
  pass.writes = {Column::position, Column::velocity};
  if (with_velocity_gradient) pass.writes.push_back(Column::velocity_gradient);
  pass.grid_fields = {"velocity", "acceleration"};
  const Velocity kind = !method.keeps_velocity() ? Velocity::of_grid
                        : method.flip == 1       ? Velocity::kept
                                                 : Velocity::blended;
  pass.bind = [kind, with_velocity_gradient, with_work](State<Dim>& s) -> Kernel {
    const B& basis = basis_of<B>(s);
    const auto gather = gather_of<B, Dim>(kind, with_velocity_gradient);
    const auto power = std::make_shared<std::vector<double>>((s.particles + block_size - 1) / block_size);
    return [&s, &basis, gather, power, with_work](const Instant& now) {
      gather(s, basis, now, with_work ? power.get() : nullptr);
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
          const Mat<Dim> gradient = velocity_gradient<Dim>(basis, p, s.motion);
          for (std::size_t c = 0; c < Dim * Dim; ++c) L[c][p] = gradient[c];
        }
      });
    };
  };
  return pass;
}

#define ASSAY_PASSES(BASIS, DIM)                                                         \
  template Pass<DIM> grid_to_particles_pass<BASIS<DIM>, DIM>(const Method&, bool, bool); \
  template Pass<DIM> velocity_gradient_pass<BASIS<DIM>, DIM>();

ASSAY_FOR_EACH_BASIS(ASSAY_PASSES)
#undef ASSAY_PASSES

}  // namespace assay::mpm
