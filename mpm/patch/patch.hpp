// SPDX-License-Identifier: BSD-3-Clause
// What the patch tests are run on: a square body of 2x2 particles a cell, in arrangements, and a list of passes that
// probes can be put into.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "harness/check/battery.hpp"
#include "mpm/basis/basis.hpp"
#include "mpm/patch/methods.hpp"
#include "mpm/simulation.hpp"

namespace assay::mpm {

/// What every patch test takes besides the method.
struct Bench {
  std::shared_ptr<const Material> material;  ///< elastic, without history
  double density = 1000;                     ///< rho0 [kg/m^3]
  double wave_speed = 0;                     ///< fastest of the material at rest [m/s]
  bool quick = false;                        ///< coarser grids
  /// The passes of a step; a negative control plants a defect here.
  std::function<std::vector<Pass<2>>(const Setup<2>&)> passes = compose<2>;
};

inline constexpr double courant = 0.3;  ///< of the wave and the particle together

/// A square of 1 m around the origin, `across` cells wide, with as many cells of room around it.
Setup<2> patch_setup(const Method& method, const Bench& bench, int across);

/// Longest step for a body whose particles are as fast as `speed` [s].
double time_step(const Bench& bench, int across, double speed);

/// Numbers in [-1, 1), the same on every machine.
class Noise {
 public:
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-52 - 1; }

 private:
  std::mt19937_64 engine_{20131};
};

/// Where the particles of the square are, and how they are deformed.
enum class Arrangement {
  seeded,    ///< as seeded, cell by cell
  shifted,   ///< that lattice moved by an irrational part of a cell
  deformed,  ///< stretched and sheared by `homogeneous_deformation`: the domains are parallelograms without gaps
  graded,    ///< deformed, and rows and columns of unequal width: the same without gaps, from `graded_seeds`
  jittered,  ///< deformed, and each particle, or each corner, moved by up to 0.3 of its distance to the next
};

/// The square cut into rows and columns whose widths differ by up to 0.6 of themselves, each rectangle a particle.
Seeds<2> graded_seeds(int across);

/// F of the last three: stretches, shear and rotation.
Mat<2> homogeneous_deformation();

/// Positions and F of the state, the same F for all particles. What is moved in the total formulation is the reference.
void arrange(State<2>& s, Arrangement arrangement);

/// Cauchy stress after F, components as in the stress column [Pa].
std::array<double, stress_components<2>> stress_at(const Material& material, const Mat<2>& F);

/// Behind the main pass of each of these phases. There must be one (std::logic_error): a probe that is not there sees
/// nothing.
void insert_after(std::vector<Pass<2>>& passes, const std::vector<Phase>& phases, const Pass<2>& probe);

/// In place of the main pass of that phase; there must be one.
void replace(std::vector<Pass<2>>& passes, Phase phase, const Pass<2>& other);

/// Momentum of the particles [N s], their angular momentum about E_z [N m s], and the sums of m |v| and m |x| |v|.
struct Momentum {
  std::array<double, 2> linear{};
  double angular = 0, scale = 0, angular_scale = 0;
};
Momentum momentum_of(const State<2>& s);

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
MethodReport run_patch_tests(const Method& method, const Bench& bench);

/// A bench for a material without history. Throws MaterialFailure.
Bench bench_of(std::shared_ptr<const Material> material, bool quick);

// Each file of this folder holds one group.

/// Uniform motion through several cells: v uniform, F = I, momentum kept.
std::vector<check::TestResult> translation(const Method& method, const Bench& bench);

/// Rigid rotation by an irrational angle under the body force that it needs: errors of displacement, F and J.
std::vector<check::TestResult> rotation(const Method& method, const Bench& bench);

/// Internal force at inner nodes of a body under constant stress, in five arrangements of the particles.
std::vector<check::TestResult> constant_stress(const Method& method, const Bench& bench);

/// Force at all nodes of a loaded body under constant stress, its surface included: tension between two ends with free
/// sides, and tractions on all faces.
std::vector<check::TestResult> surface(const Method& method, const Bench& bench);

/// Sum of the weights, of their gradients, and of both with the nodes' positions, on an irregular set.
std::vector<check::TestResult> completeness(const Method& method, const Bench& bench);

/// Linear and angular momentum over one step of an irregular set.
std::vector<check::TestResult> momentum(const Method& method, const Bench& bench);

}  // namespace assay::mpm
