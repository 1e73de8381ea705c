// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/body_force.hpp"
#include "mpm/effects/tractions.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"

namespace assay::mpm {

Pass<2> virtual_stress_pass(TractionForm form) {
  Pass<2> pass;
  pass.name = "virtual_stress";
  pass.stages = Stages::kicks;
  pass.doc = form == TractionForm::reference ? "the particles' stress without that of the exact P"
                                             : "the particles' stress without that of the exact motion";
  pass.reads = {Column::reference_position, Column::deformation_gradient, Column::stress};
  pass.writes = {Column::excess_stress};
  pass.bind = [form](State<2>& s) -> Kernel {
    s.stress_of_forces = Column::excess_stress;
    const auto field = fields_of_particles(s, {.stress = true});
    Kernel kernel;
    kernel.begin = [&s, field](const Instant& now) { field->set_time(time_of_forces(s.method, now)); };
    kernel.block = [&s, field, form](const Instant&, const Block& block) {
      const auto sigma = components<5>(s, Column::stress), excess = components<5>(s, Column::excess_stress);
      for (std::size_t p = block.begin; p < block.end; ++p) {
        const PlaneState exact = field->state(p);
        Mat<2> taken{exact.sigma[0], exact.sigma[1], exact.sigma[2], exact.sigma[3]};
        if (form == TractionForm::reference) {  // P F^T / J with the particle's own F
          const Mat<2> F = s.at<4>(Column::deformation_gradient, p), own = product<2>(F, inverse<2>(exact.F));
          const double ratio = determinant<2>(exact.F) / determinant<2>(F);
          taken = product<2>(taken, {own[0], own[2], own[1], own[3]});  // J_e sigma_e F_e^-T F^T / J
          for (double& component : taken) component *= ratio;
        }
        for (std::size_t c = 0; c < 4; ++c) excess[c][p] = sigma[c][p] - taken[c];
      }
      return none_bad;
    };
    return kernel;
  };
  return pass;
}

namespace {

std::vector<Pass<2>> virtual_stress_passes(const Setup<2>& setup) {
  std::vector<Pass<2>> passes{virtual_stress_pass(setup.traction->form)};
  passes.front().slot = {setup.method.update == Update::usf ? Phase::forces : Phase::to_grid, Part::first};
  if (setup.body_force && setup.inertia != Inertia::particles) {
    passes.push_back(inertia_pass(setup.method, setup.accounts));
  }
  return passes;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> virtual_stress_effect() {
  EffectRecord<Dim> effect{60, "tractions as the exact stress, continued beyond the surface", "traction.algorithm"};
  effect.called_for = [](const Setup<Dim>& s) { return has_traction(s, TractionAlgorithm::virtual_stress); };
  if constexpr (Dim == 2) effect.passes = virtual_stress_passes;
  effect.columns = {{Column::excess_stress, "excess_stress", "Pa",
                     "Cauchy stress without its exact extension, which virtual_stress takes off",
                     [](const Setup<Dim>&) { return doubles(stress_components<Dim>); }}};
  effect.asks_material = true;
  return effect;
}

template EffectRecord<2> virtual_stress_effect();
template EffectRecord<3> virtual_stress_effect();

}  // namespace assay::mpm
