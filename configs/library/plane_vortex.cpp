// SPDX-License-Identifier: BSD-3-Clause
// A material point code of its own, verified: total Lagrangian, bilinear functions, 2 x 2 points a cell, FLIP.
//   c++ -std=c++17 -O2 plane_vortex.cpp -o plane_vortex $(pkg-config --cflags --libs assay)
//   ./plane_vortex plane_vortex.yaml
#include <assay.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

using Vector = std::array<double, 2>;
using Problem = std::unique_ptr<assay_problem, decltype(&assay_close)>;
using Points = std::unique_ptr<assay_points, decltype(&assay_points_close)>;

/// What the library refuses is thrown.
void need(int code, const assay_error& error) {
  if (code != ASSAY_DONE) throw std::runtime_error(error.message);
}

/// The author's material: neo-Hookean, P = mu (F - F^-T) + lambda ln J F^-T in plane strain.
std::array<double, 4> stress(const std::array<double, 4>& F) {
  const double E = 1e3, nu = 0.3, mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const double J = F[0] * F[3] - F[1] * F[2];
  const std::array<double, 4> inverse_t{F[3] / J, -F[2] / J, -F[1] / J, F[0] / J};
  std::array<double, 4> P{};
  for (int c = 0; c < 4; ++c) P[c] = mu * (F[c] - inverse_t[c]) + lambda * std::log(J) * inverse_t[c];
  return P;
}

/// The largest error over time [m]: root mean square over the particles of the ring, n x n cells on [-1.5, 1.5]^2.
double error_of(const assay_problem* problem, int n) {
  assay_error error = ASSAY_ERROR_INIT;
  assay_facts facts = ASSAY_FACTS_INIT;
  need(assay_get_facts(problem, &facts, &error), error);
  const double h = 3.0 / n, mass = facts.density * h * h / 4;
  const int steps = static_cast<int>(std::ceil(facts.end * facts.wave_speed / (0.3 * h)));
  const double dt = facts.end / steps;
  std::vector<Vector> X;
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < 2 * n; ++j) X.push_back({-1.5 + h * (j + 0.5) / 2, -1.5 + h * (i + 0.5) / 2});
  std::vector<Vector> x(X.size()), v(X.size()), b(X.size()), exact(X.size());
  std::vector<std::array<double, 4>> F(X.size(), {1, 0, 0, 1});

  const assay_const_field given{X[0].data(), 2, 1};
  assay_points* made = nullptr;
  need(assay_points_open(problem, X.size(), 2, &given, &made, &error), error);
  const Points points(made, assay_points_close);
  assay_view seeds = ASSAY_VIEW_INIT, force = ASSAY_VIEW_INIT, judge = ASSAY_VIEW_INIT;
  seeds.x = {x[0].data(), 2, 1}, seeds.v = {v[0].data(), 2, 1};
  force.b = {b[0].data(), 2, 1}, judge.x = {exact[0].data(), 2, 1};
  const auto ask = [&](double t, const assay_view& view) {
    need(assay_eval(points.get(), t, 0, X.size(), &view, &error), error);
  };
  ask(0, seeds);                             // 1. the seeds: x and v at t = 0

  /// Calls act(node, function, its slope) for the four nodes around particle p.
  const auto around = [&](std::size_t p, const auto& act) {
    const Vector at{(X[p][0] + 1.5) / h, (X[p][1] + 1.5) / h};
    const int i = static_cast<int>(at[0]), j = static_cast<int>(at[1]);
    for (int k = 0; k < 4; ++k) {
      const double right = k % 2, up = k / 2, s = 1 - std::abs(at[0] - i - right), r = 1 - std::abs(at[1] - j - up);
      act((j + k / 2) * (n + 1) + i + k % 2, s * r, Vector{(2 * right - 1) * r / h, s * (2 * up - 1) / h});
    }
  };
  std::vector<Vector> momentum((n + 1) * (n + 1)), impulse(momentum.size());
  std::vector<double> masses(momentum.size());
  double largest = 0;
  for (int step = 0; step < steps; ++step) {
    ask(step * dt, force);                   // 2. the force: b at the particles, now
    std::fill(momentum.begin(), momentum.end(), Vector{});
    std::fill(impulse.begin(), impulse.end(), Vector{});
    std::fill(masses.begin(), masses.end(), 0.0);
    for (std::size_t p = 0; p < X.size(); ++p) {
      const auto P = stress(F[p]);
      around(p, [&](int node, double N, const Vector& slope) {
        masses[node] += mass * N;
        for (int c = 0; c < 2; ++c) {
          const double inner = h * h / 4 * (P[2 * c] * slope[0] + P[2 * c + 1] * slope[1]);
          momentum[node][c] += mass * N * v[p][c];
          impulse[node][c] += (step ? dt : dt / 2) * (mass * N * b[p][c] - inner);   // to the middle of the step
        }
      });
    }
    double sum = 0, count = 0;
    ask((step + 1) * dt, judge);             // 3. the judgement: the exact x
    for (std::size_t p = 0; p < X.size(); ++p) {
      around(p, [&](int node, double N, const Vector& slope) {
        for (int c = 0; c < 2; ++c) {
          const double velocity = (momentum[node][c] + impulse[node][c]) / masses[node];
          v[p][c] += N * impulse[node][c] / masses[node];
          x[p][c] += dt * N * velocity;
          for (int d = 0; d < 2; ++d) F[p][2 * c + d] += dt * velocity * slope[d];
        }
      });
      if (std::abs(std::hypot(X[p][0], X[p][1]) - 1) >= 0.25) continue;
      sum += std::pow(x[p][0] - exact[p][0], 2) + std::pow(x[p][1] - exact[p][1], 2), ++count;
    }
    largest = std::max(largest, std::sqrt(sum / count));
  }
  return largest;
}

int main(int argc, char** argv) try {
  assay_options options = ASSAY_OPTIONS_INIT;
  options.scene = argc > 1 ? argv[1] : "plane_vortex.yaml";
  assay_error error = ASSAY_ERROR_INIT;
  assay_problem* made = nullptr;
  need(assay_open(&options, &made, &error), error);
  const Problem problem(made, assay_close);
  const double coarse = error_of(problem.get(), 32), fine = error_of(problem.get(), 64);
  std::printf("errors %.3e and %.3e m, order %.2f\n", coarse, fine, std::log2(coarse / fine));
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
