// SPDX-License-Identifier: BSD-3-Clause
// A material point code that knows nothing of assay: total Lagrangian, bilinear functions, 2 x 2 points a cell, FLIP.
// It reads what `assay export --to csv` writes, with tractions or without. usage: particles FOLDER H WAVE_SPEED END
// EDGE, EDGE: half of the square's edge; writes FOLDER/out.csv
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "force_table.h"

using Vector = std::array<double, 2>;

namespace {

/// Neo-Hookean, E = 1000 Pa, nu = 0.3, in plane strain.
std::array<double, 4> stress(const std::array<double, 4>& F) {
  const double E = 1e3, nu = 0.3, mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
  const double J = F[0] * F[3] - F[1] * F[2];
  const std::array<double, 4> inverse_t{F[3] / J, -F[2] / J, -F[1] / J, F[0] / J};
  std::array<double, 4> P{};
  for (std::size_t c = 0; c < 4; ++c) P[c] = mu * (F[c] - inverse_t[c]) + lambda * std::log(J) * inverse_t[c];
  return P;
}

struct Particles {
  std::vector<int> id;
  std::vector<Vector> X, v;
  std::vector<double> volume, mass;
};

/// Rows of numbers below a known line.
template <std::size_t Columns>
std::vector<std::array<double, Columns>> read_rows(const std::string& file, const std::string& head) {
  std::vector<std::array<double, Columns>> rows;
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) return rows;
  if (line != head) std::exit(2);
  while (std::getline(in, line)) {
    std::array<double, Columns> row{};
    char* at = line.data();
    for (double& value : row) value = std::strtod(at, &at), ++at;
    rows.push_back(row);
  }
  return rows;
}

Particles read_seeds(const std::string& file) {
  Particles all;
  for (const auto& row : read_rows<7>(file, "id,X,Y,volume,mass,vx,vy")) {
    all.id.push_back(static_cast<int>(row[0]));
    all.X.push_back({row[1], row[2]}), all.v.push_back({row[5], row[6]});
    all.volume.push_back(row[3]), all.mass.push_back(row[4]);
  }
  return all;
}

}  // namespace

int main(int, char** argv) {
  constexpr int frames = 10;
  const std::string folder = argv[1];
  const double spacing = std::atof(argv[2]), wave = std::atof(argv[3]), end = std::atof(argv[4]);
  const double h = 2 * spacing, edge = std::atof(argv[5]);
  const int n = static_cast<int>(std::lround(2 * edge / h));
  const int steps = frames * static_cast<int>(std::ceil(end * wave / (0.3 * h) / frames));
  const double dt = end / steps;
  Particles p = read_seeds(folder + "/seeds.csv");
  force_table force;
  if (force_table_read(&force, (folder + "/force.bin").c_str()) != 0) return 3;
  if (force.points != static_cast<std::int64_t>(p.X.size())) return 4;
  const auto faces = read_rows<6>(folder + "/faces.csv", "id,X,Y,NX,NY,area");  // none where there are no tractions
  force_table tractions{};
  if (!faces.empty() && force_table_read(&tractions, (folder + "/tractions.bin").c_str()) != 0) return 6;
  std::vector<Vector> load(faces.size());
  std::vector<Vector> x = p.X, b(p.X.size());
  std::vector<std::array<double, 4>> F(p.X.size(), {1, 0, 0, 1});
  const auto around = [&](const Vector& X, const auto& act) {
    const Vector at{(X[0] + edge) / h, (X[1] + edge) / h};
    const int i = std::min(static_cast<int>(at[0]), n - 1), j = std::min(static_cast<int>(at[1]), n - 1);
    for (int c = 0; c < 4; ++c) {
      const double right = c % 2, up = c / 2, s = 1 - std::abs(at[0] - i - right), r = 1 - std::abs(at[1] - j - up);
      act(static_cast<std::size_t>((j + c / 2) * (n + 1) + i + c % 2), s * r,
          Vector{(2 * right - 1) * r / h, s * (2 * up - 1) / h});
    }
  };
  std::vector<Vector> momentum(static_cast<std::size_t>((n + 1) * (n + 1))), impulse(momentum.size());
  std::vector<double> masses(momentum.size());
  std::ofstream out(folder + "/out.csv");
  out.precision(17);
  out << "t,id,X,Y,x,y,vx,vy\n";
  for (int step = 0; step <= steps; ++step) {
    force_table_at(&force, step * dt, b[0].data());
    std::fill(momentum.begin(), momentum.end(), Vector{});
    std::fill(impulse.begin(), impulse.end(), Vector{});
    std::fill(masses.begin(), masses.end(), 0.0);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const auto P = stress(F[k]);
      around(p.X[k], [&](std::size_t node, double N, const Vector& slope) {
        masses[node] += p.mass[k] * N;
        for (std::size_t c = 0; c < 2; ++c) {
          const double inner = p.volume[k] * (P[2 * c] * slope[0] + P[2 * c + 1] * slope[1]);
          momentum[node][c] += p.mass[k] * N * p.v[k][c];
          impulse[node][c] += (step > 0 ? dt : dt / 2) * (p.mass[k] * N * b[k][c] - inner);  // to the middle of a step
        }
      });
    }
    if (!faces.empty()) force_table_at(&tractions, step * dt, load[0].data());
    for (std::size_t k = 0; k < faces.size(); ++k) {
      around({faces[k][1], faces[k][2]}, [&](std::size_t node, double N, const Vector&) {
        for (std::size_t c = 0; c < 2; ++c) impulse[node][c] += (step > 0 ? dt : dt / 2) * N * faces[k][5] * load[k][c];
      });
    }
    const std::vector<Vector> before = p.v, now = x;
    for (std::size_t k = 0; k < x.size(); ++k) {
      around(p.X[k], [&](std::size_t node, double N, const Vector& slope) {
        for (std::size_t c = 0; c < 2; ++c) {
          const double velocity = (momentum[node][c] + impulse[node][c]) / masses[node];
          p.v[k][c] += N * impulse[node][c] / masses[node];
          x[k][c] += dt * N * velocity;
          for (std::size_t d = 0; d < 2; ++d) F[k][2 * c + d] += dt * velocity * slope[d];
        }
      });
    }
    for (std::size_t k = 0; step % (steps / frames) == 0 && k < x.size(); ++k) {
      out << step * dt << ',' << p.id[k] << ',' << p.X[k][0] << ',' << p.X[k][1] << ',' << now[k][0] << ','
          << now[k][1];
      for (std::size_t c = 0; c < 2; ++c) out << ',' << (step > 0 ? 0.5 * (before[k][c] + p.v[k][c]) : before[k][c]);
      out << '\n';
    }
  }
  force_table_free(&force);
  force_table_free(&tractions);
  return out.good() ? 0 : 5;
}
