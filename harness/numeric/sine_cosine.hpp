// SPDX-License-Identifier: BSD-3-Clause
// Sine and cosine of many angles at once: no branch, no call, so that compilers make vector instructions of it.
#pragma once

#include <cmath>

namespace assay {

/// Beyond, the angle is not reduced exactly enough [rad].
inline constexpr double largest_angle = 1e5;

/// Both to 1 unit in the last place [of 1 where the value is small] for |x| <= largest_angle. By Cody and Waite's
/// reduction to |r| <= pi/4 and the polynomials of fdlibm (k_sin.c, k_cos.c).
inline void sine_cosine(double x, double& sine, double& cosine) {
  constexpr double two_over_pi = 6.36619772367581382433e-01;
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52: what is added to it is rounded
  constexpr double half_pi_1 = 1.57079632673412561417e+00, half_pi_2 = 6.07710050630396597660e-11,
                   half_pi_3 = 2.02226624871116645580e-21;  // their sum is pi/2; the first two have 33 bits
  const double quarters = (x * two_over_pi + to_integer) - to_integer;
  const double r = ((x - quarters * half_pi_1) - quarters * half_pi_2) - quarters * half_pi_3;
  const double z = r * r;
  const double s = r + r * z *
                           (-1.66666666666666324348e-01 +
                            z * (8.33333333332248946124e-03 +
                                 z * (-1.98412698298579493134e-04 +
                                      z * (2.75573137070700676789e-06 +
                                           z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
  const double c =
      1 - (0.5 * z - z * z *
                         (4.16666666666666019037e-02 +
                          z * (-1.38888888888741095749e-03 +
                               z * (2.48015872894767294178e-05 +
                                    z * (-2.75573143513906633035e-07 +
                                         z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11))))));
  const double half = 0.5 * quarters, quarter = 0.25 * quarters;
  const double odd = 2 * std::abs(half - ((half + to_integer) - to_integer));  // 1 in odd quarters, else 0
  // cos and sin of quarters * pi/2 are 1, 0, -1, 0 and 0, 1, 0, -1.
  const double turn = quarter - ((quarter + to_integer) - to_integer);  // 0, +-1/4, +-1/2
  const double cos_turn = (1 - odd) * (1 - 4 * std::abs(turn)), sin_turn = 4 * odd * turn;
  sine = s * cos_turn + c * sin_turn;
  cosine = c * cos_turn - s * sin_turn;
}

}  // namespace assay
