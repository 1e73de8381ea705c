// SPDX-License-Identifier: BSD-3-Clause
// What the patch tests are run on: a square or cube of two particles a cell and axis, in arrangements, and a list of
// passes that probes can be put into.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "harness/check/battery.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/patch/methods.hpp"
#include "mpm/simulation.hpp"

namespace assay::mpm {

/// What every patch test takes besides the method.
template <int Dim>
struct Bench {
  std::shared_ptr<const Material> material;  ///< elastic, without history
  double density = 1000;                     ///< rho0 [kg/m^3]
  double wave_speed = 0;                     ///< fastest of the material at rest [m/s]
  bool quick = false;                        ///< coarser grids
  /// The passes of a step; a negative control plants a defect here.
  std::function<std::vector<Pass<Dim>>(const Setup<Dim>&)> passes = compose<Dim>;
};

inline constexpr double courant = 0.3;  ///< of the wave and the particle together

/// A square or cube of 1 m around the origin, `across` cells wide, with room around it: as many cells in the plane, a
/// few in space.
template <int Dim>
Setup<Dim> patch_setup(const Method& method, const Bench<Dim>& bench, int across);

/// Cells across the body in the tests that need no series of grids: in space as few as the basis with the widest
/// functions allows.
template <int Dim>
int cells_across(const Bench<Dim>& bench) {
  if (Dim == 3) return 4;
  return bench.quick ? 8 : 32;
}

/// Longest step for a body whose particles are as fast as `speed` [s].
template <int Dim>
double time_step(const Bench<Dim>& bench, int across, double speed) {
  return courant / (across * (bench.wave_speed + speed));
}

/// Numbers in [-1, 1), the same on every machine.
class Noise {
 public:
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }

 private:
  std::mt19937_64 engine_{20131};
};

/// Where the particles of the body are, and how they are deformed.
enum class Arrangement {
  seeded,    ///< as seeded, cell by cell
  shifted,   ///< that lattice moved by an irrational part of a cell
  deformed,  ///< stretched and sheared by `homogeneous_deformation`: the domains are parallelograms without gaps
  graded,    ///< deformed, and rows and columns of unequal width: the same without gaps, from `graded_seeds`
  jittered,  ///< deformed, and each particle, or each corner, moved by up to 0.3 of its distance to the next
};

/// The body cut into rows and columns whose widths differ by up to 0.6 of themselves, each rectangle a particle.
template <int Dim>
Seeds<Dim> graded_seeds(int across);

/// F of the last three: stretches, shear in every plane and rotation.
template <int Dim>
Mat<Dim> homogeneous_deformation();

/// Positions and F of the state, the same F for all particles. What is moved in the total formulation is the reference.
template <int Dim>
void arrange(State<Dim>& s, Arrangement arrangement);

/// Cauchy stress after F, components as in the stress column [Pa].
template <int Dim>
std::array<double, stress_components<Dim>> stress_at(const Material& material, const Mat<Dim>& F);

/// A X.
template <int Dim>
Vec<Dim> image_of(const Mat<Dim>& A, const Vec<Dim>& X) {
  Vec<Dim> found;
  for (std::size_t i = 0; i < Dim; ++i) {
    found[i] = A[i * Dim] * X[0];
    for (std::size_t j = 1; j < Dim; ++j) found[i] += A[i * Dim + j] * X[j];
  }
  return found;
}

/// body(i, x) for every node of the grid, in its order.
template <int Dim>
void for_every_node(const GridGeometry<Dim>& grid, const auto& body) {
  std::array<std::int32_t, Dim> at{};
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    Vec<Dim> x;
    for (std::size_t d = 0; d < Dim; ++d) x[d] = grid.coordinate(static_cast<int>(d), at[d]);
    body(i, x);
    for (std::size_t d = 0; d < Dim && ++at[d] == grid.count[d]; ++d) at[d] = 0;
  }
}

/// Behind the main pass of each of these phases. There must be one (std::logic_error): a probe that is not there sees
/// nothing.
template <int Dim>
void insert_after(std::vector<Pass<Dim>>& passes, const std::vector<Phase>& phases, const Pass<Dim>& probe);

/// In place of the main pass of that phase; there must be one.
template <int Dim>
void replace(std::vector<Pass<Dim>>& passes, Phase phase, const Pass<Dim>& other);

/// Momentum of the particles [N s], their angular momentum about the axes, in the plane about E_z alone [N m s], and
/// the sums of m |v| and m |x| |v|.
template <int Dim>
struct Momentum {
  std::array<double, Dim> linear{};
  std::array<double, 3> angular{};
  double scale = 0, angular_scale = 0;
};
template <int Dim>
Momentum<Dim> momentum_of(const State<Dim>& s);

/// What a patch test found: the error, the order at which it falls with h and dt, and a sentence.
struct Figure {
  double measure = 0;
  std::string sentence;
  std::optional<double> order = {};
};

/// Pass or fail by the threshold where the method promises it (`broken`: what it then is not), else n/a with the
/// reason.
check::TestResult judged(const Method& method, const std::string& id, const Figure& figure, double threshold,
                         const std::string& broken);

/// "1.2e-14".
std::string digits(double value);

/// One method's results.
struct MethodReport {
  Method method;
  std::vector<check::TestResult> tests;
  bool passes() const;
};

/// Every patch test of one method. What the method does not promise is measured too, and n/a.
template <int Dim>
MethodReport run_patch_tests(const Method& method, const Bench<Dim>& bench);

/// A bench for a material without history. Throws MaterialFailure.
template <int Dim>
Bench<Dim> bench_of(const std::shared_ptr<const Material>& material, bool quick);

// Each file of this folder holds one group.

/// Uniform motion through several cells: v uniform, F = I, momentum kept.
template <int Dim>
std::vector<check::TestResult> translation(const Method& method, const Bench<Dim>& bench);

/// Rigid rotation by an irrational angle under the body force that it needs: errors of displacement, F and J. In space
/// that of slabs about each axis, and that of a cube about (1, 2, 3).
template <int Dim>
std::vector<check::TestResult> rotation(const Method& method, const Bench<Dim>& bench);

/// Internal force at inner nodes of a body under constant stress, in five arrangements of the particles.
template <int Dim>
std::vector<check::TestResult> constant_stress(const Method& method, const Bench<Dim>& bench);

/// Force at all nodes of a loaded body under constant stress, its surface included: tension between two ends with free
/// sides, and tractions on all faces.
template <int Dim>
std::vector<check::TestResult> surface(const Method& method, const Bench<Dim>& bench);

/// Sum of the weights, of their gradients, and of both with the nodes' positions, on an irregular set.
template <int Dim>
std::vector<check::TestResult> completeness(const Method& method, const Bench<Dim>& bench);

/// Linear momentum, and angular momentum about every axis, over one step of an irregular set.
template <int Dim>
std::vector<check::TestResult> momentum(const Method& method, const Bench<Dim>& bench);

}  // namespace assay::mpm
