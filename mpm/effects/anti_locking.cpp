// SPDX-License-Identifier: BSD-3-Clause
// F-bar: de Souza Neto, Peric, Dutko and Owen (1996); averaged over the cells of the grid by Coombs, Charlton, Cortis
// and Augarde (2018).
#include <algorithm>
#include <cmath>

#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

namespace {

/// Of the volume over which averages are taken and that after the step [m^Dim]: in the total formulation the reference
/// one, in the updated one that before the step.
template <int Dim>
std::size_t find_volumes(State<Dim>& s, const Block& block, double dt) {
  const auto F = components<Dim * Dim>(s, Column::deformation_gradient);
  const auto rate = components<Dim * Dim>(s, Column::velocity_gradient);
  const double* V = s.column(Column::volume);
  double *base = s.column(Column::step_volumes, 0), *after = s.column(Column::step_volumes, 1);
  const bool total = s.method.is_total();
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const Mat<Dim> before = load(F, p);
    Mat<Dim> change = load(rate, p);
    if (!total) change = product<Dim>(change, before);
    for (std::size_t c = 0; c < change.size(); ++c) change[c] = before[c] + dt * change[c];
    base[p] = total ? V[p] : V[p] * determinant<Dim>(before);
    after[p] = V[p] * determinant<Dim>(change);
  }
  return none_bad;
}

/// Sums over the cells, or over the nodes' multilinear functions, of the grid.
template <int Dim>
class VolumeAverage {
 public:
  VolumeAverage(const GridGeometry<Dim>& grid, const Images<Dim>& images, AntiLocking over)
      : grid_(grid), images_(&images), over_(over) {
    sums_.allocate(grid.nodes());
    touched_.reserve(grid.nodes());
  }

  void run(State<Dim>& s) {
    const bool total = s.method.is_total();
    const auto x = components<Dim>(s, total ? Column::reference_position : Column::position);
    const double *base = s.column(Column::step_volumes, 0), *after = s.column(Column::step_volumes, 1);
    double *now = s.column(Column::volume_scale, 0), *before = total ? s.column(Column::volume_scale, 1) : nullptr;
    for (std::size_t p = 0; p < s.particles; ++p) {
      visit(load(x, p), [&](std::size_t at, double share) {
        double* sums = sums_.node(at);
        if (sums[0] == 0) touched_.push_back(at);
        sums[0] += share * base[p];
        sums[1] += share * after[p];
      });
    }
    if (over_ == AntiLocking::node && !images_->empty()) {
      images_->fold(sums_, 2);  // scalars
      images_->unfold(sums_, 2);
    }
    for (std::size_t p = 0; p < s.particles; ++p) {
      double average = 0;
      visit(load(x, p),
            [&](std::size_t at, double share) { average += share * sums_.node(at)[1] / sums_.node(at)[0]; });
      if (before) before[p] = now[p] > 0 ? now[p] : 1;  // zero before the first step
      const double own = after[p] / base[p];
      now[p] = own > 0 && average > 0 ? std::pow(average / own, 1.0 / Dim) : 1;  // the stress pass reports it
    }
    if (images_->empty()) {
      for (const std::size_t at : touched_) std::fill_n(sums_.node(at), 2, 0.0);
    } else {
      sums_.zero();
    }
    touched_.clear();
  }

 private:
  /// body(cell or node, share of it)
  void visit(const std::array<double, Dim>& x, const auto& body) const {
    std::array<double, Dim> part{};
    std::size_t lowest = 0, stride = 1;
    std::array<std::size_t, Dim> strides{};
    for (std::size_t d = 0; d < Dim; ++d) {
      const double along = x[d] / grid_.spacing - (grid_.first[d] + grid_.offset[d]);
      const double cell = std::clamp(std::floor(along), 0.0, static_cast<double>(grid_.count[d] - 2));
      part[d] = std::clamp(along - cell, 0.0, 1.0);
      lowest += static_cast<std::size_t>(cell) * stride;
      strides[d] = stride;
      stride *= static_cast<std::size_t>(grid_.count[d]);
    }
    if (over_ == AntiLocking::cell) return body(images_->cell(lowest), 1.0);
    for (std::size_t n = 0; n < std::size_t{1} << Dim; ++n) {
      double share = 1;
      std::size_t node = lowest;
      for (std::size_t d = 0; d < Dim; ++d) {
        const bool upper = (n >> d & 1) != 0;
        share *= upper ? part[d] : 1 - part[d];
        node += upper ? strides[d] : 0;
      }
      if (share > 0) body(node, share);
    }
  }

  GridGeometry<Dim> grid_;
  const Images<Dim>* images_;
  AntiLocking over_;
  GridField<2> sums_;                 ///< of reference and current volume [m^Dim]
  std::vector<std::size_t> touched_;  ///< where they are not zero; a node can stand here more than once
};

/// Before `stress`: volumes of each particle, of which the ratio is averaged. In the updated formulation that of the
/// step, det(I + dt L); in the total one J.
template <int Dim>
Pass<Dim> step_volumes_pass(const Method& method) {
  return {{.name = "step_volumes",
           .slot = {stress_phase(method), Part::first},
           .doc = "volume of each particle before and after the step, or in the reference configuration and after it",
           .reads = {Column::velocity_gradient, Column::deformation_gradient, Column::volume},
           .writes = {Column::step_volumes}},
          [](State<Dim>& s) {
            return Kernel::over_blocks(
                [&s](const Instant& now, const Block& block) { return find_volumes(s, block, now.dt); });
          }};
}

/// After it: the ratio averaged over the cells or nodes around a particle, and the factor (averaged / own)^(1/Dim) of
/// F. In the updated formulation F keeps it: what F has of volume is then never a particle's own. In the total one F
/// stays the gradient of the motion, and the material alone sees it scaled.
template <int Dim>
Pass<Dim> average_volume_pass(const Method& method, AntiLocking over) {
  return {{.name = "average_volume",
           .slot = {stress_phase(method), Part::first},
           .doc = over == AntiLocking::cell ? "J averaged over the particles of each cell, for the stress"
                                            : "J averaged over the nodes' functions, for the stress",
           .reads = {Column::step_volumes, method.is_total() ? Column::reference_position : Column::position},
           .writes = {Column::volume_scale},
           .grid_fields = {"cell_volume"}},
          [over](State<Dim>& s) -> Kernel {
            auto average = std::make_shared<VolumeAverage<Dim>>(s.setup.grid, s.template own<Images<Dim>>(), over);
            return [&s, average](const Instant&) { average->run(s); };
          }};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> anti_locking_effect() {
  EffectRecord<Dim> effect{200, "the stress is computed with J averaged over cells or nodes", "remedies.anti_locking"};
  effect.called_for = [](const Setup<Dim>& s) { return option<AntiLocking>(s) != AntiLocking::none; };
  effect.keys = [](EffectOptions& options, Keys& key) {
    key("remedies.anti_locking",
        "F-bar: the stress uses J averaged over cells or nodes, for nearly incompressible materials",
        options.tell<AntiLocking>());
  };
  effect.example = "cell";
  effect.refusal = [](const Method& method, const EffectOptions&) -> std::string {
    if (!method.has_stages()) return {};
    return "forces of symplectic_rkn4 follow from positions, and an average from the way there: take leapfrog";
  };
  effect.in_title = [](const EffectOptions& options) -> std::string {
    return options.of<AntiLocking>() == AntiLocking::cell ? "J averaged over cells" : "J averaged over nodes";
  };
  effect.passes = [](const Setup<Dim>& s) {
    return std::vector{step_volumes_pass<Dim>(s.method), average_volume_pass<Dim>(s.method, option<AntiLocking>(s))};
  };
  effect.columns = {{Column::step_volumes, "step_volumes", "m^3",
                     "before the step (total formulation: reference volume) and after it, to be averaged",
                     [](const Setup<Dim>&) { return doubles(2); }},
                    {Column::volume_scale, "volume_scale", "1",
                     "of F, so that its J is averaged; in the total formulation of the step before, too",
                     [](const Setup<Dim>& s) { return doubles(s.method.is_total() ? 2 : 1); }, of_stress}};
  effect.grid_fields = [](const Setup<Dim>&) {
    return std::vector<GridFieldUse>{{"cell_volume", "reference and current volume, a cell or node", doubles(2)}};
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> anti_locking_effect();

}  // namespace assay::mpm
