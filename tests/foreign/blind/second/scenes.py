# SPDX-License-Identifier: BSD-3-Clause
"""The problems of the second set of blind cases; none is one of the first set. See there for what the names mean."""
import math

ELASTIC = {
    "mr": "{adapter: mooney_rivlin, parameters: {c10: 180, c01: 40, bulk_modulus: 1100}, density: 1200}",
    "svk": "{adapter: saint_venant_kirchhoff, parameters: {E: 2200, nu: 0.3}, density: 1300}",
    "zener": "{adapter: zener, density: 700,"
             " parameters: {E: 900, nu: 0.3, viscous_ratio: 0.5, relaxation_time: 0.25}}",
    "j2": "{adapter: j2_multiplicative, density: 900,"
          " parameters: {E: 1300, nu: 0.3, yield_stress: 45, hardening_modulus: 200}}",
}
MOTIONS = {  # motion, edge of the body, end
    "whirl": ("{type: vortex, inner: 0.4, outer: 1.1, period: 1.2, profile_power: 4,"
              " amplitude: {type: sine, peak: 0.22}}", ("box", -1.25, 1.25), 1.2),
    "wide": ("{type: twisting_ring, inner: 0.8, outer: 1.5, period: 1.4, expansion: 0.04, profile_power: 4,"
             " amplitude: {type: sine, peak: 0.15}}", ("ring", 0.8, 1.5), 1.4),
    "quick": ("{type: twisting_ring, inner: 0.6, outer: 1.3, period: 0.7, expansion: 0.05, profile_power: 4,"
              " amplitude: {type: sine, peak: 0.18}}", ("ring", 0.6, 1.3), 0.7),
    "spin": ("{type: rotating_stretch, stretch: 0.22, shear: 0.12, rotation: 1.3, axis: [0, 0, 1],"
             " rotate: simultaneous, period: 1.5}", ("box", -0.6, 0.6), 1.5),
    "bend": ("{type: homogeneous, path: path.csv, interpolation: spline}", ("box", 0.0, 1.0), 1.3),
    "draw": ("{type: homogeneous, period: 1.1, final: [[1.2, 0.18, 0], [0.06, 1.1, 0], [0, 0, 1]]}",
             ("box", 0.0, 1.0), 1.1),
    "standing": ("{type: axis_aligned, amplitude: {type: sine, peak: 0.06}, wave_speed: 1.0}", ("box", 0.0, 1.0), 1.0),
}


def path_text():
    """F(t) of a square that is sheared and pressed, and comes back."""
    rows = ["t,F11,F12,F21,F22"]
    for k in range(105):
        t = k / 80
        s = math.pi * t / 1.3
        rows.append(f"{t:.6g},{1 - 0.1 * math.sin(s)**2:.12g},{0.2 * math.sin(s):.12g},"
                    f"{0.05 * math.sin(2 * s):.12g},{1 + 0.2 * math.sin(s)**2:.12g}")
    return "\n".join(rows) + "\n"


LINE = "t,F11,F12,F21,F22\n0,1,0,0,1\n1.1,1.2,0.18,0.06,1.1\n"
