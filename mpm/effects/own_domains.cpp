// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "mpm/basis/basis.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
std::size_t domain_bytes(const Setup<Dim>& setup) {
  return traits_of<Dim>(setup.method.basis).domain_components * sizeof(double);
}

/// Half edges as the basis wants them. Half sizes along the axes, where the domains do not follow these: of a cube of
/// the same volume.
template <int Dim>
void begin_domain(State<Dim>& s, std::size_t p) {
  const Seeds<Dim>& seeds = s.setup.seeds;
  Mat<Dim> half{};
  for (std::size_t d = 0; d < Dim; ++d) half[d * (Dim + 1)] = seeds.half_size[d];
  if (!seeds.half_edges.empty()) half = seeds.half_edges[p];
  if (domain_bytes(s.setup) == half.size() * sizeof(double)) {
    for (int c = 0; c < Dim * Dim; ++c) s.column(Column::domain, c)[p] = half[static_cast<std::size_t>(c)];
    return;
  }
  for (int d = 0; d < Dim; ++d) s.column(Column::domain, d)[p] = 0.5 * std::pow(seeds.volume(p), 1.0 / Dim);
}

}  // namespace

template <int Dim>
EffectRecord<Dim> own_domains_effect() {
  EffectRecord<Dim> effect{150, "particles' domains differ, by their lattice or as they are shortened", "body.lattice"};
  effect.called_for = [](const Setup<Dim>& s) {
    return (!s.seeds.half_edges.empty() || option<LargestDomain>(s).cells > 0) && domain_bytes(s) > 0;
  };
  effect.columns = {
      {Column::domain, "domain", "m", "half edges of the reference domain, where they differ", domain_bytes}};
  effect.prepare = [](State<Dim>& s) {
    for (std::size_t p = 0; s.has(Column::domain) && p < s.particles; ++p) begin_domain(s, p);
  };
  effect.called_by = [](const Setup<Dim>& s) -> std::string {
    return s.seeds.half_edges.empty() ? "remedies.largest_domain" : "body.lattice";
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> own_domains_effect();

}  // namespace assay::mpm
