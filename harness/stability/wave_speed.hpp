// SPDX-License-Identifier: BSD-3-Clause
// The fastest acoustic wave that a material carries along a baseline path: what limits an explicit time step.
#pragma once

#include "harness/motion/path.hpp"
#include "harness/stability/tangent_modulus.hpp"

namespace assay {

/// Largest c over all directions with rho0 c^2 an eigenvalue of A_iJkL N_J N_L, N = F^T n, |n| = 1 [m/s].
double fastest_wave(const TangentModulus& A, const Tensor& F, double density);

/// Of what a material gives as one: whether it can be one [m/s].
bool is_wave_speed(double c);

/// In which configuration a wave's way is measured: the grid of an updated formulation lies in the current one, that of
/// a total one in the reference one, where a body of stretch Lambda is thinner and is crossed as much faster.
enum class WaveFrame { current, reference };

/// The largest over the path, 0 <= t <= end [m/s]: the material's own (assay.wave_speed/1), which is of the current
/// configuration, or the probed one where it has none or 0 everywhere; in the reference one rho0 c^2 is the largest
/// eigenvalue of A_iJkL N_J N_L, |N| = 1. density: rho0 [kg/m^3]. Throws MaterialFailure.
double fastest_wave_on_path(const Material& material, const Path& path, double density, double end,
                            WaveFrame frame = WaveFrame::current);

}  // namespace assay
