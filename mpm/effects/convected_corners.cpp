// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/basis/corners.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
void begin_corners(State<Dim>& s, std::size_t p) {
  const Seeds<Dim>& seeds = s.setup.seeds;
  Vec<Dim> X;
  Mat<Dim> half{};
  for (std::size_t d = 0; d < Dim; ++d) X[d] = seeds.X[d][p], half[d * Dim + d] = seeds.half_size[d];
  const Corners<Dim> corners = seeds.corners.empty()
                                   ? corners_of<Dim>(X, seeds.half_edges.empty() ? half : seeds.half_edges[p])
                                   : seeds.corners[p];
  for (int k = 0; k < corner_components<Dim>; ++k) {
    s.column(Column::corners, k)[p] = corners[static_cast<std::size_t>(k / Dim)][static_cast<std::size_t>(k % Dim)];
  }
}

}  // namespace

template <int Dim>
EffectRecord<Dim> convected_corners_effect() {
  EffectRecord<Dim> effect{140, "corners of the domains move one by one", "method.basis"};
  effect.called_for = [](const Setup<Dim>& s) { return traits_of<Dim>(s.method.basis).moves_corners; };
  effect.columns = {{Column::corners, "corners", "m", "of the domain, where they move one by one",
                     [](const Setup<Dim>&) { return doubles(corner_components<Dim>); }}};
  effect.prepare = [](State<Dim>& s) {
    for (std::size_t p = 0; s.has(Column::corners) && p < s.particles; ++p) begin_corners(s, p);
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> convected_corners_effect();

}  // namespace assay::mpm
