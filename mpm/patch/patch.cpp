// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/patch/patch.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/stability/wave_speed.hpp"

#include <algorithm>
#include <stdexcept>

#include "mpm/basis/corners.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

constexpr double jitter = 0.3;  ///< of the distance between particles, and of the cuts between rows and columns
constexpr std::array<double, 3> shift{0.31830988618379067, -0.43429448190325182,
                                      0.36787944117144233};  ///< of h: 1/pi, -lg e, 1/e
/// Cells around a body in space: it flies through four, and its corners reach into three more.
constexpr int room_in_space = 8;

/// Of a corner at X: the same for all domains that share it.
template <int Dim>
Vec<Dim> moved_corner(const Vec<Dim>& X, double distance) {
  const auto wave = [&](double along, double across) { return std::sin(1234.5 * along + 3456.7 * across); };
  if constexpr (Dim == 2) return {jitter * distance * wave(X[0], X[1]), jitter * distance * wave(X[1], -X[0])};
  if constexpr (Dim == 3) {
    return {jitter * distance * wave(X[0] + X[2], X[1]), jitter * distance * wave(X[1] - X[0], X[2]),
            jitter * distance * wave(X[2] - X[1], -X[0])};
  }
}

/// Corners follow their particle. Where the particles are moved one by one the corners are, instead, and the particle's
/// volume is that between them.
template <int Dim>
void arrange_corners(State<Dim>& s, const Mat<Dim>& F, bool jittered) {
  const auto column = [&](std::size_t c, std::size_t d) -> double* { return s.column(Column::corners, Dim * c + d); };
  for (std::size_t p = 0; p < s.particles; ++p) {
    Corners<Dim> corners;
    const double distance = s.setup.seeds.half_size[0];
    const Vec<Dim> seeded = image_of<Dim>(F, s.template at<Dim>(Column::reference_position, p));
    for (std::size_t c = 0; c < corners.size(); ++c) {
      Vec<Dim> X;
      for (std::size_t d = 0; d < Dim; ++d) X[d] = column(c, d)[p];
      const Vec<Dim> moved = jittered ? moved_corner<Dim>(X, distance) : Vec<Dim>{};
      for (std::size_t d = 0; d < Dim; ++d) X[d] += moved[d];
      const Vec<Dim> x = image_of<Dim>(F, X);
      for (std::size_t d = 0; d < Dim; ++d) {
        const double shifted = s.column(Column::position, d)[p] - seeded[d];
        corners[c][d] = column(c, d)[p] = x[d] + (jittered ? 0 : shifted);
      }
    }
    if (!jittered) continue;
    const CornerAverage<Dim> average = average_over(corners);
    s.column(Column::volume)[p] = average.volume / determinant<Dim>(F);
    for (std::size_t d = 0; d < Dim; ++d) {
      double middle = 0;
      for (std::size_t c = 0; c < corners.size(); ++c) middle += average.value[c] * corners[c][d];
      s.column(Column::position, d)[p] = middle;
    }
  }
}

template <int Dim>
Mat<Dim> identity() {
  Mat<Dim> found{};
  for (std::size_t d = 0; d < Dim; ++d) found[d * (Dim + 1)] = 1;
  return found;
}

}  // namespace

template <int Dim>
Setup<Dim> patch_setup(const Method& method, const Bench<Dim>& bench, int across) {
  Setup<Dim> setup;
  const double h = 1.0 / across;
  Vec<Dim> lower, upper;
  std::array<int, Dim> per_cell;
  lower.fill(-0.5), upper.fill(0.5), per_cell.fill(2);
  setup.method = method;
  setup.grid = grid_around<Dim>(lower, upper, h, Dim == 2 ? across : room_in_space);
  setup.seeds = cartesian_lattice<Dim>(lower, upper, h, per_cell, [](const auto&) { return Fate::stepped; });
  setup.density = bench.density;
  setup.material = bench.material;
  return setup;
}

template <int Dim>
Seeds<Dim> graded_seeds(int across) {
  const int along = 2 * across;
  const double distance = 1.0 / along;
  Noise noise;
  std::array<std::vector<double>, Dim> cuts;
  for (auto& cut : cuts) {
    for (int k = 0; k <= along; ++k) cut.push_back(k * distance - 0.5);
    for (std::size_t k = 1; k + 1 < cut.size(); ++k) cut[k] += jitter * distance * noise();
  }
  Seeds<Dim> seeds;
  seeds.half_size.fill(0.5 * distance);
  std::array<std::size_t, Dim> at{};
  for (std::size_t d = 0; d < Dim;) {
    double volume = 1;
    Mat<Dim> half_edges{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double lower = cuts[axis][at[axis]], width = cuts[axis][at[axis] + 1] - lower;
      seeds.X[axis].push_back(lower + 0.5 * width);
      volume *= width;
      half_edges[axis * (Dim + 1)] = 0.5 * width;
    }
    seeds.volumes.push_back(volume);
    seeds.half_edges.push_back(half_edges);
    for (d = 0; d < Dim && ++at[d] + 1 == cuts[d].size(); ++d) at[d] = 0;
  }
  return seeds;
}

template <int Dim>
Mat<Dim> homogeneous_deformation() {
  if constexpr (Dim == 2) return {1.07, 0.21, -0.04, 0.93};
  if constexpr (Dim == 3) return {1.13, 0.15, -0.12, -0.04, 0.98, 0.11, -0.05, 0.08, 1.09};
}

template <int Dim>
void arrange(State<Dim>& s, Arrangement arrangement) {
  const bool is_deformed = arrangement != Arrangement::seeded && arrangement != Arrangement::shifted;
  const Mat<Dim> F = is_deformed ? homogeneous_deformation<Dim>() : identity<Dim>();
  Noise noise;
  const bool total = s.setup.method.is_total();  // whose weights are those of the reference configuration
  for (std::size_t p = 0; p < s.particles; ++p) {
    Vec<Dim> X = s.template at<Dim>(Column::reference_position, p), moved{};
    for (std::size_t d = 0; d < Dim; ++d) {
      if (arrangement == Arrangement::shifted) moved[d] = shift[d] * s.setup.grid.spacing;
      if (arrangement == Arrangement::jittered) moved[d] = 2 * jitter * s.setup.seeds.half_size[d] * noise();
      if (total) s.column(Column::reference_position, d)[p] = X[d] += moved[d];
    }
    const Vec<Dim> x = image_of<Dim>(F, X);
    for (std::size_t d = 0; d < Dim; ++d) s.column(Column::position, d)[p] = x[d] + (total ? 0 : moved[d]);
    for (std::size_t c = 0; c < F.size(); ++c) s.column(Column::deformation_gradient, c)[p] = F[c];
  }
  if (s.has(Column::corners)) arrange_corners(s, F, arrangement == Arrangement::jittered);
}

template <int Dim>
std::array<double, stress_components<Dim>> stress_at(const Material& material, const Mat<Dim>& F) {
  std::array<double, 9> tensor{1, 0, 0, 0, 1, 0, 0, 0, 1}, sigma{};
  for (std::size_t c = 0; c < F.size(); ++c) tensor[3 * (c / Dim) + c % Dim] = F[c];
  material.update(0, 1, 1, tensor.data(), tensor.data(), nullptr, nullptr, sigma.data());
  std::array<double, stress_components<Dim>> found;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) found[stress_index<Dim>(i, j)] = sigma[3 * i + j];
  }
  if (Dim == 2) found[4] = sigma[8];
  return found;
}

template <int Dim>
void insert_after(std::vector<Pass<Dim>>& passes, const std::vector<Phase>& phases, const Pass<Dim>& probe) {
  const std::size_t before = passes.size();
  for (std::size_t k = 0; k < passes.size(); ++k) {
    const Slot& slot = passes[k].slot;
    if (slot.part != Part::main || std::find(phases.begin(), phases.end(), slot.phase) == phases.end()) continue;
    passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(++k), probe);
  }
  if (passes.size() == before) throw std::logic_error("no pass to put " + probe.name + " behind");
}

template <int Dim>
void replace(std::vector<Pass<Dim>>& passes, Phase phase, const Pass<Dim>& other) {
  bool found = false;
  for (Pass<Dim>& pass : passes) {
    if (pass.slot == Slot{phase}) pass = other, found = true;
  }
  if (!found) throw std::logic_error("no pass for " + other.name + " to replace");
}

template <int Dim>
Momentum<Dim> momentum_of(const State<Dim>& s) {
  Momentum<Dim> sum;
  const bool with_moments = s.setup.method.is_affine() && s.setup.method.affine == Affine::moment;  // sum phi v (x) r
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double m = s.column(Column::mass)[p];
    const auto x = s.template at<Dim>(Column::position, p), v = s.template at<Dim>(Column::velocity, p);
    for (std::size_t d = 0; d < Dim; ++d) sum.linear[d] += m * v[d];
    add_moment(sum.angular, m, x, v);
    for (std::size_t i = 0; with_moments && i < (Dim == 2 ? 1 : 3); ++i) {
      const std::size_t j = (i + 1) % Dim;
      sum.angular[(i + 2) % 3] +=
          m * (s.column(Column::affine, j * Dim + i)[p] - s.column(Column::affine, i * Dim + j)[p]);
    }
    sum.scale += m * length_of<Dim>(v);
    sum.angular_scale += m * length_of<Dim>(x) * length_of<Dim>(v);
  }
  return sum;
}

template <int Dim>
MethodReport run_patch_tests(const Method& method, const Bench<Dim>& bench) {
  MethodReport report{method, {}};
  for (const auto group :
       {completeness<Dim>, translation<Dim>, rotation<Dim>, constant_stress<Dim>, surface<Dim>, momentum<Dim>}) {
    for (check::TestResult& result : group(method, bench)) report.tests.push_back(std::move(result));
  }
  return report;
}

template <int Dim>
Bench<Dim> bench_of(const std::shared_ptr<const Material>& material, bool quick) {
  Bench<Dim> bench{.material = material, .quick = quick};
  bench.wave_speed = fastest_wave_on_path(*bench.material, Homogeneous{}.baseline(), bench.density, 0);
  return bench;
}

template Setup<ASSAY_DIMENSION> patch_setup(const Method&, const Bench<ASSAY_DIMENSION>&, int);
template Seeds<ASSAY_DIMENSION> graded_seeds(int);
template Mat<ASSAY_DIMENSION> homogeneous_deformation<ASSAY_DIMENSION>();
template void arrange(State<ASSAY_DIMENSION>&, Arrangement);
template std::array<double, stress_components<ASSAY_DIMENSION>> stress_at<ASSAY_DIMENSION>(const Material&,
                                                                                           const Mat<ASSAY_DIMENSION>&);
template void insert_after(std::vector<Pass<ASSAY_DIMENSION>>&, const std::vector<Phase>&,
                           const Pass<ASSAY_DIMENSION>&);
template void replace(std::vector<Pass<ASSAY_DIMENSION>>&, Phase, const Pass<ASSAY_DIMENSION>&);
template Momentum<ASSAY_DIMENSION> momentum_of(const State<ASSAY_DIMENSION>&);
template MethodReport run_patch_tests(const Method&, const Bench<ASSAY_DIMENSION>&);
template Bench<ASSAY_DIMENSION> bench_of(const std::shared_ptr<const Material>&, bool);

}  // namespace assay::mpm
