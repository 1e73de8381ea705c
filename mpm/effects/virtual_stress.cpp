// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/body_force.hpp"
#include "mpm/effects/tractions.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"

namespace assay::mpm {

namespace {

/// Cauchy's, row-major, in space of its six components.
template <int Dim>
Mat<Dim> tensor_of_stress(const auto& sigma) {
  Mat<Dim> found;
  for (std::size_t c = 0; c < found.size(); ++c) found[c] = sigma[stress_index<Dim>(c / Dim, c % Dim)];
  return found;
}

template <int Dim>
Mat<Dim> transposed_of(const Mat<Dim>& A) {
  Mat<Dim> found;
  for (std::size_t c = 0; c < found.size(); ++c) found[c] = A[c % Dim * Dim + c / Dim];
  return found;
}

}  // namespace

template <int Dim>
Pass<Dim> virtual_stress_pass(TractionForm form) {
  Pass<Dim> pass;
  pass.name = "virtual_stress";
  pass.stages = Stages::kicks;
  pass.doc = form == TractionForm::reference ? "the particles' stress without that of the exact P"
                                             : "the particles' stress without that of the exact motion";
  pass.reads = {Column::reference_position, Column::deformation_gradient, Column::stress};
  pass.writes = {Column::excess_stress};
  pass.bind = [form](State<Dim>& s) -> Kernel {
    s.stress_of_forces = Column::excess_stress;
    const auto field = fields_of_particles<Dim>(s, {.stress = true});
    Kernel kernel;
    kernel.begin = [&s, field](const Instant& now) { field->set_time(time_of_forces(s.method, now)); };
    kernel.block = [&s, field, form](const Instant&, const Block& block) {
      const auto sigma = components<stress_components<Dim>>(s, Column::stress);
      const auto excess = components<Dim * Dim>(s, Column::excess_stress);
      const auto& here = field->window(block.begin, block.end);
      for (std::size_t p = block.begin; p < block.end; ++p) {
        const FieldState<Dim> exact = here.state(p);
        Mat<Dim> taken = tensor_of_stress<Dim>(exact.sigma);
        if (form == TractionForm::reference) {  // P F^T / J with the particle's own F
          const Mat<Dim> F = s.template at<Dim * Dim>(Column::deformation_gradient, p);
          const double ratio = determinant<Dim>(exact.F) / determinant<Dim>(F);
          // J_e sigma_e F_e^-T F^T / J
          taken = product<Dim>(taken, transposed_of<Dim>(product<Dim>(F, inverse<Dim>(exact.F))));
          for (double& component : taken) component *= ratio;
        }
        const Mat<Dim> own = tensor_of_stress<Dim>(load(sigma, p));
        for (std::size_t c = 0; c < taken.size(); ++c) excess[c][p] = own[c] - taken[c];
      }
      return none_bad;
    };
    return kernel;
  };
  return pass;
}

namespace {

template <int Dim>
std::vector<Pass<Dim>> virtual_stress_passes(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> passes{virtual_stress_pass<Dim>(setup.traction->form)};
  passes.front().slot = {setup.method.update == Update::usf ? Phase::forces : Phase::to_grid, Part::first};
  if (setup.body_force && setup.inertia != Inertia::particles) {
    passes.push_back(inertia_pass<Dim>(setup.method, setup.accounts));
  }
  return passes;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> virtual_stress_effect() {
  EffectRecord<Dim> effect{60, "tractions as the exact stress, continued beyond the surface", "traction.algorithm"};
  effect.called_for = [](const Setup<Dim>& s) { return has_traction(s, TractionAlgorithm::virtual_stress); };
  effect.passes = virtual_stress_passes<Dim>;
  effect.columns = {{Column::excess_stress, "excess_stress", "Pa",
                     "Cauchy stress without its exact extension, which virtual_stress takes off",
                     [](const Setup<Dim>&) { return doubles(excess_components<Dim>); }}};
  effect.asks_material = true;
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> virtual_stress_effect();
template Pass<ASSAY_DIMENSION> virtual_stress_pass(TractionForm);

}  // namespace assay::mpm
