// SPDX-License-Identifier: BSD-3-Clause
// Convected domains that grow too long are shortened: Homel, Brannon and Guilkey (2016).
#include <cmath>

#include "harness/numeric/number_text.hpp"
#include "mpm/basis/corners.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

namespace {

/// Factor that brings a vector's length down to `most`.
double shortening(double x, double y, double most) {
  const double length = std::hypot(x, y);
  return length > most ? most / length : 1;
}

/// Half diagonals a = r1 + r2 and b = r1 - r2 of the deformed domain, each shortened by itself. Area goes as both
/// factors: a domain that was not turned inside out is not.
std::array<double, 4> shortened(const std::array<double, 4>& r, double most) {
  const double ax = r[0] + r[1], ay = r[2] + r[3], bx = r[0] - r[1], by = r[2] - r[3];
  const double a = 0.5 * shortening(ax, ay, most), b = 0.5 * shortening(bx, by, most);
  return {a * ax + b * bx, a * ax - b * bx, a * ay + b * by, a * ay - b * by};
}

void limit_half_edges(State<2>& s, const Block& block, double most) {
  const auto F = components<4>(s, Column::deformation_gradient), domain = components<4>(s, Column::domain);
  const Seeds<2>& seeds = s.setup.seeds;
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const Mat<2> f = load(F, p);
    Mat<2> half{seeds.half_size[0], 0, 0, seeds.half_size[1]};
    if (!seeds.half_edges.empty()) half = seeds.half_edges[p];
    const Mat<2> r = product<2>(f, half), kept = shortened(r, most);
    if (kept != r) half = product<2>(inverse<2>(f), kept);
    for (std::size_t c = 0; c < 4; ++c) domain[c][p] = half[c];
  }
}

/// Each corner is drawn towards the middle of its diagonal, which stays.
void limit_corners(State<2>& s, const Block& block, double most) {
  const auto x = components<corner_components<2>>(s, Column::corners);
  for (std::size_t p = block.begin; p < block.end; ++p) {
    for (const std::size_t c : {0, 1}) {
      const std::size_t opposite = 3 - c;
      const double dx = 0.5 * (x[2 * opposite][p] - x[2 * c][p]), dy = 0.5 * (x[2 * opposite + 1][p] - x[2 * c + 1][p]);
      const double factor = shortening(dx, dy, most);
      if (factor == 1) continue;
      const double mx = x[2 * c][p] + dx, my = x[2 * c + 1][p] + dy;
      x[2 * c][p] = mx - factor * dx, x[2 * c + 1][p] = my - factor * dy;
      x[2 * opposite][p] = mx + factor * dx, x[2 * opposite + 1][p] = my + factor * dy;
    }
  }
}

/// Before `weights`: half edges of the reference domain such that no corner of the deformed one is farther from its
/// particle than the scene says; of domains whose corners move one by one, these corners.
std::vector<Pass<2>> limiting_passes(const Setup<2>& setup) {
  const bool moves_corners = traits_of<2>(setup.method.basis).moves_corners;
  return {{{.name = "limit_domains",
            .slot = {Phase::weights, Part::first},
            .doc = "domains that reach too far are shortened",
            .reads = {moves_corners ? Column::corners : Column::deformation_gradient},
            .writes = {moves_corners ? Column::corners : Column::domain}},
           [moves_corners](State<2>& s) {
             const double most = option<LargestDomain>(s.setup).cells * s.setup.grid.spacing;
             return Kernel::over_blocks([&s, most, moves_corners](const Instant&, const Block& block) {
               moves_corners ? limit_corners(s, block, most) : limit_half_edges(s, block, most);
               return none_bad;
             });
           }}};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> largest_domain_effect() {
  EffectRecord<Dim> effect{210, "domains that reach too far are shortened", "remedies.largest_domain"};
  effect.called_for = [](const Setup<Dim>& s) { return Dim == 2 && option<LargestDomain>(s).cells > 0; };
  effect.keys = [](EffectOptions& options, Keys& key) {
    double& cells = options.tell<LargestDomain>().cells;
    key("remedies.largest_domain", "largest distance of a corner of a cpdi or cpdi2 domain from its particle [cells]",
        cells, {.range = {.lower = 0.1, .upper = 1e6}, .derived = "as they deform", .shown = cells > 0});
  };
  effect.example = "0.5";
  effect.refusal = [](const Method& method, const EffectOptions&) -> std::string {
    if (!method.is_total() && traits_of<2>(method.basis).convects) return {};
    return "is of domains that deform with their particle: of " + bases_that(&BasisTraits::convects, "and") +
           " in the updated formulation";
  };
  effect.in_title = [](const EffectOptions& options) {
    return "domains to " + rounded_text(options.of<LargestDomain>().cells, 3) + " h";
  };
  if constexpr (Dim == 2) effect.passes = limiting_passes;
  effect.around = "domains that differ, of cpdi";
  return effect;
}

template EffectRecord<2> largest_domain_effect();
template EffectRecord<3> largest_domain_effect();

}  // namespace assay::mpm
