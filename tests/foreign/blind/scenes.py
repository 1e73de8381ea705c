# SPDX-License-Identifier: BSD-3-Clause
"""The problems of the blind cases: motions with the edges of their bodies, and materials."""
import math

ELASTIC = {
    "mr": "{adapter: mooney_rivlin, parameters: {c10: 240, c01: 90, bulk_modulus: 1500}, density: 900}",
    "svk": "{adapter: saint_venant_kirchhoff, parameters: {E: 1500, nu: 0.25}, density: 800}",
    "zener": "{adapter: zener, density: 950,"
             " parameters: {E: 800, nu: 0.35, viscous_ratio: 0.7, relaxation_time: 0.15}}",
    "j2": "{adapter: j2_multiplicative, density: 1050,"
          " parameters: {E: 1600, nu: 0.28, yield_stress: 60, hardening_modulus: 300}}",
}
MOTIONS = {  # motion, edge of the body, end
    "vortex": ("{type: vortex, inner: 0.5, outer: 1.2, period: 0.8, profile_power: 4,"
               " amplitude: {type: sine, peak: 0.3}}", ("box", -1.4, 1.4), 0.8),
    "slow": ("{type: vortex, inner: 0.6, outer: 1.5, period: 1.6, profile_power: 4,"
             " amplitude: {type: sine, peak: 0.2}}", ("box", -1.6, 1.6), 1.6),
    "ring": ("{type: twisting_ring, inner: 0.5, outer: 1.1, period: 1.1, expansion: 0.06, profile_power: 4,"
             " amplitude: {type: sine, peak: 0.2}}", ("ring", 0.5, 1.1), 1.1),
    "turn": ("{type: rotating_stretch, stretch: 0.35, shear: 0.2, rotation: 0.8, axis: [0, 0, 1],"
             " rotate: simultaneous, period: 1.2}", ("box", -0.5, 0.5), 1.2),
    "path": ("{type: homogeneous, path: path.csv, interpolation: spline}", ("box", 0.0, 1.0), 1.0),
    "line": ("{type: homogeneous, path: line.csv}", ("box", 0.0, 1.0), 0.7),
    "pull": ("{type: homogeneous, period: 0.7, final: [[1.35, 0.1, 0], [0, 1.15, 0], [0, 0, 1]]}",
             ("box", 0.0, 1.0), 0.7),
    "waves": ("{type: axis_aligned, amplitude: {type: sine, peak: 0.08}, wave_speed: 1.3}", ("box", 0.0, 1.0),
              1 / 1.3),
}


def path_text():
    """F(t) of a square that is stretched and sheared and comes back."""
    rows = ["t,F11,F12,F21,F22"]
    for k in range(81):
        t = k / 80
        rows.append(f"{t:.6g},{1 + 0.3 * math.sin(math.pi * t)**2:.12g},{0.075 * math.sin(2 * math.pi * t):.12g},0,"
                    f"{1 + 0.12 * math.sin(math.pi * t):.12g}")
    return "\n".join(rows) + "\n"


LINE = "t,F11,F12,F21,F22\n0,1,0,0,1\n0.7,1.35,0.1,0,1.15\n"
