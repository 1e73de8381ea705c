// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/patch/patch.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/stability/wave_speed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "mpm/basis/corners.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

constexpr double jitter = 0.3;  ///< of the distance between particles, and of the cuts between rows and columns
constexpr std::array<double, 2> shift{0.31830988618379067, -0.43429448190325182};  ///< of h: 1/pi, -lg e

/// Of a corner at X: the same for all domains that share it.
Vec<2> moved_corner(const Vec<2>& X, double distance) {
  const auto wave = [&](double along, double across) { return std::sin(1234.5 * along + 3456.7 * across); };
  return {jitter * distance * wave(X[0], X[1]), jitter * distance * wave(X[1], -X[0])};
}

/// Corners follow their particle. Where the particles are moved one by one the corners are, instead, and the particle's
/// volume is that between them.
void arrange_corners(State<2>& s, const Mat<2>& F, bool jittered) {
  const auto column = [&](std::size_t c, std::size_t d) -> double* { return s.column(Column::corners, 2 * c + d); };
  for (std::size_t p = 0; p < s.particles; ++p) {
    Corners<2> corners;
    const double distance = s.setup.seeds.half_size[0];
    for (std::size_t c = 0; c < corners.size(); ++c) {
      Vec<2> X{column(c, 0)[p], column(c, 1)[p]};
      const Vec<2> moved = jittered ? moved_corner(X, distance) : Vec<2>{};
      for (std::size_t d = 0; d < 2; ++d) X[d] += moved[d];
      for (std::size_t d = 0; d < 2; ++d) {
        const double shifted =
            s.column(Column::position, d)[p] - (F[2 * d] * s.column(Column::reference_position, 0)[p] +
                                                F[2 * d + 1] * s.column(Column::reference_position, 1)[p]);
        corners[c][d] = column(c, d)[p] = F[2 * d] * X[0] + F[2 * d + 1] * X[1] + (jittered ? 0 : shifted);
      }
    }
    if (!jittered) continue;
    const CornerAverage<2> average = average_over(corners);
    s.column(Column::volume)[p] = average.volume / determinant<2>(F);
    for (std::size_t d = 0; d < 2; ++d) {
      double middle = 0;
      for (std::size_t c = 0; c < corners.size(); ++c) middle += average.value[c] * corners[c][d];
      s.column(Column::position, d)[p] = middle;
    }
  }
}

}  // namespace

Setup<2> patch_setup(const Method& method, const Bench& bench, int across) {
  Setup<2> setup;
  const double h = 1.0 / across;
  setup.method = method;
  setup.grid = grid_around<2>({-0.5, -0.5}, {0.5, 0.5}, h, across);
  setup.seeds = cartesian_lattice<2>({-0.5, -0.5}, {0.5, 0.5}, h, {2, 2}, [](const auto&) { return Fate::stepped; });
  setup.density = bench.density;
  setup.material = bench.material;
  return setup;
}

double time_step(const Bench& bench, int across, double speed) {
  return courant / (across * (bench.wave_speed + speed));
}

Seeds<2> graded_seeds(int across) {
  const int along = 2 * across;
  const double distance = 1.0 / along;
  Noise noise;
  std::array<std::vector<double>, 2> cuts;
  for (auto& cut : cuts) {
    for (int k = 0; k <= along; ++k) cut.push_back(k * distance - 0.5);
    for (std::size_t k = 1; k + 1 < cut.size(); ++k) cut[k] += jitter * distance * noise();
  }
  Seeds<2> seeds;
  seeds.half_size.fill(0.5 * distance);
  for (std::size_t j = 1; j < cuts[1].size(); ++j) {
    for (std::size_t i = 1; i < cuts[0].size(); ++i) {
      const double width = cuts[0][i] - cuts[0][i - 1], height = cuts[1][j] - cuts[1][j - 1];
      seeds.X[0].push_back(cuts[0][i - 1] + 0.5 * width);
      seeds.X[1].push_back(cuts[1][j - 1] + 0.5 * height);
      seeds.volumes.push_back(width * height);
      seeds.half_edges.push_back({0.5 * width, 0, 0, 0.5 * height});
    }
  }
  return seeds;
}

Mat<2> homogeneous_deformation() { return {1.07, 0.21, -0.04, 0.93}; }

void arrange(State<2>& s, Arrangement arrangement) {
  const bool is_deformed = arrangement != Arrangement::seeded && arrangement != Arrangement::shifted;
  const Mat<2> F = is_deformed ? homogeneous_deformation() : Mat<2>{1, 0, 0, 1};
  Noise noise;
  const bool total = s.setup.method.is_total();  // whose weights are those of the reference configuration
  for (std::size_t p = 0; p < s.particles; ++p) {
    Vec<2> X{s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p]}, moved{};
    for (std::size_t d = 0; d < 2; ++d) {
      if (arrangement == Arrangement::shifted) moved[d] = shift[d] * s.setup.grid.spacing;
      if (arrangement == Arrangement::jittered) moved[d] = 2 * jitter * s.setup.seeds.half_size[d] * noise();
      if (total) s.column(Column::reference_position, d)[p] = X[d] += moved[d];
    }
    for (std::size_t d = 0; d < 2; ++d) {
      s.column(Column::position, d)[p] = F[2 * d] * X[0] + F[2 * d + 1] * X[1] + (total ? 0 : moved[d]);
    }
    for (int c = 0; c < 4; ++c) s.column(Column::deformation_gradient, c)[p] = F[static_cast<std::size_t>(c)];
  }
  if (s.has(Column::corners)) arrange_corners(s, F, arrangement == Arrangement::jittered);
}

std::array<double, stress_components<2>> stress_at(const Material& material, const Mat<2>& F) {
  const std::array<double, 9> tensor{F[0], F[1], 0, F[2], F[3], 0, 0, 0, 1};
  std::array<double, 9> sigma{};
  material.update(0, 1, 1, tensor.data(), tensor.data(), nullptr, nullptr, sigma.data());
  return {sigma[0], sigma[1], sigma[3], sigma[4], sigma[8]};
}

void insert_after(std::vector<Pass<2>>& passes, const std::vector<Phase>& phases, const Pass<2>& probe) {
  const std::size_t before = passes.size();
  for (std::size_t k = 0; k < passes.size(); ++k) {
    const Slot& slot = passes[k].slot;
    if (slot.part != Part::main || std::find(phases.begin(), phases.end(), slot.phase) == phases.end()) continue;
    passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(++k), probe);
  }
  if (passes.size() == before) throw std::logic_error("no pass to put " + probe.name + " behind");
}

void replace(std::vector<Pass<2>>& passes, Phase phase, const Pass<2>& other) {
  bool found = false;
  for (Pass<2>& pass : passes) {
    if (pass.slot == Slot{phase}) pass = other, found = true;
  }
  if (!found) throw std::logic_error("no pass for " + other.name + " to replace");
}

Momentum momentum_of(const State<2>& s) {
  Momentum sum;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double m = s.column(Column::mass)[p];
    const double x = s.column(Column::position, 0)[p], y = s.column(Column::position, 1)[p];
    const double vx = s.column(Column::velocity, 0)[p], vy = s.column(Column::velocity, 1)[p];
    sum.linear[0] += m * vx;
    sum.linear[1] += m * vy;
    sum.angular += m * (x * vy - y * vx);
    if (s.setup.method.is_affine() && s.setup.method.affine == Affine::moment) {  // sum phi r x v
      sum.angular += m * (s.column(Column::affine, 2)[p] - s.column(Column::affine, 1)[p]);
    }
    sum.scale += m * std::hypot(vx, vy);
    sum.angular_scale += m * std::hypot(x, y) * std::hypot(vx, vy);
  }
  return sum;
}

check::TestResult judged(const Method& method, const std::string& id, const Figure& figure, double threshold,
                         const std::string& broken) {
  check::TestResult result{.id = id, .order = figure.order, .sentence = figure.sentence};
  if (!std::isnan(figure.measure)) result.measure = figure.measure;
  const std::string reason = exemption(method, id);
  if (!reason.empty()) {
    result.verdict = check::Verdict::not_applicable;
    result.sentence += "; not promised: " + reason;
    return result;
  }
  result.threshold = threshold;
  if (!(figure.measure <= threshold)) {
    result.verdict = check::Verdict::fail;
    result.cause = broken;
  }
  return result;
}

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

bool MethodReport::passes() const {
  return std::none_of(tests.begin(), tests.end(),
                      [](const auto& test) { return test.verdict == check::Verdict::fail; });
}

MethodReport run_patch_tests(const Method& method, const Bench& bench) {
  MethodReport report{method, {}};
  for (const auto group : {completeness, translation, rotation, constant_stress, surface, momentum}) {
    for (check::TestResult& result : group(method, bench)) report.tests.push_back(std::move(result));
  }
  return report;
}

Bench bench_of(std::shared_ptr<const Material> material, bool quick) {
  Bench bench{.material = std::move(material), .quick = quick};
  bench.wave_speed = fastest_wave_on_path(*bench.material, Homogeneous{}.baseline(), bench.density, 0);
  return bench;
}

}  // namespace assay::mpm
