# SPDX-License-Identifier: BSD-3-Clause
"""What was planted where. Truth and "separable" were written before judge was asked, but for m20, m21, m22 and u14:
these are like runs at which judge had failed. The truths of q14 and q17 were "unknown" at first. The paths of m15, q16,
u11 and u14 were tables with jumps of the acceleration at first: a right code was wrong by 84 % there.

A case: (name, code, scene, cells of the coarse grid, change, truth, separable). The fine grid has twice as many cells.
change: for mpm (mistake, size[, method]), else pairs of texts of the code that runs, old and new.
truth: names of mistakes that are the same in this motion, "unknown" where no dictionary has it, "none" if unspoilt.
separable: whether its effect should be at least four times the error of the fine grid, and like no other mistake.
"""
from codes import (BACK, CPDI, FLIP, FX_ASSAY, FX_BEGIN, FX_END, FX_FORCE, FX_INNER, FX_SMALL, GOOD, PIC, Q_B,
                   Q_BEGIN, Q_LOADS, Q_P, Q_T, XPIC)

CASES = [
    # Our own particle methods.
    ("m01", "mpm", "vortex_mr", 28, ("initial_velocity", 0, GOOD), {"initial_velocity"}, True),
    ("m02", "mpm", "vortex_zener", 28, ("initial_velocity", 0.5, GOOD), {"initial_velocity"}, True),
    ("m03", "mpm", "slow_svk", 32, ("body_force", 1.2, GOOD), {"body_force"}, True),
    ("m04", "mpm", "vortex_j2", 28, ("body_force", -1, GOOD), {"body_force"}, True),
    ("m05", "mpm", "ring_zener", 6, ("inertia_term", 0, GOOD), {"inertia_term"}, True),
    ("m06", "mpm", "vortex_zener", 28, ("stress_term", 0, GOOD), {"stress_term"}, True),
    ("m07", "mpm", "slow_mr", 32, ("force_rotation", 0, GOOD), {"force_rotation"}, True),
    ("m08", "mpm", "ring_svk", 6, ("force_rotation", 2, GOOD), {"force_rotation"}, True),
    ("m09", "mpm", "vortex_svk", 28, ("force_place", 0, GOOD), {"force_place"}, True),
    ("m10", "mpm", "turn_zener", 5, ("load_delay", 0.03, GOOD), {"load_delay"}, True),
    ("m11", "mpm", "ring_mr", 6, ("load_clock", 0.95, GOOD), {"load_clock"}, True),
    ("m12", "mpm", "ring_zener", 6, ("stiffness", 1.3, GOOD), {"stiffness"}, True),
    ("m13", "mpm", "waves_mr", 8, ("mass", 1.25, GOOD), {"mass", "stiffness"}, True),
    ("m14", "mpm", "slow_zener", 32, ("damping", 0.7, GOOD), {"damping"}, True),
    ("m15", "mpm", "path_mr", 5, ("tractions", -1, GOOD), {"tractions"}, True),
    ("m16", "mpm", "pull_svk", 5, ("tractions", 0, GOOD), {"tractions"}, True),
    ("m17", "mpm", "turn_svk", 5, ("body_force", 0.9, CPDI), {"body_force", "inertia_term"}, True),
    ("m18", "mpm", "vortex_mr", 28, ("gravity", 0.4, GOOD), {"unknown"}, False),
    ("m19", "mpm", "slow_svk", 32, ("no_y", 0, GOOD), {"unknown"}, False),
    ("m20", "mpm", "vortex_mr", 28, ("no_y", 0, GOOD), {"unknown"}, False),
    ("m21", "mpm", "waves_mr", 5, ("inertia_term", 2, GOOD), {"inertia_term"}, True),
    ("m22", "mpm", "slow_mr", 24, ("load_delay", 0.08, GOOD), {"load_delay"}, True),
    # FEniCSx.
    ("f01", "fenics", "vortex_mr", 28, [(FX_BEGIN, "    v = -v\n" + FX_BEGIN)], {"initial_velocity"}, True),
    ("f02", "fenics", "vortex_svk", 28, [(FX_FORCE, "return 0 * force(t)[row]")], {"body_force"}, True),
    ("f03", "fenics", "slow_mr", 32, [(FX_FORCE, "return 0.85 * force(t)[row]")], {"body_force"}, True),
    ("f04", "fenics", "slow_svk", 32, [(FX_END, FX_ASSAY), (FX_FORCE, FX_FORCE + " - 2 * known.points(X)(t, 'a')")],
     {"inertia_term"}, True),
    ("f05", "fenics", "vortex_mr", 28,
     [(FX_END, FX_ASSAY), (FX_FORCE, "return known.points(X + displacement)(t, 'b')")], {"force_place"}, True),
    ("f06", "fenics", "vortex_mr", 28, [(FX_FORCE, "return force(max(0, t - 0.05))[row]")], {"load_delay"}, True),
    ("f07", "fenics", "slow_svk", 32, [(FX_INNER, "- 0.8 * inner / (DENSITY * volume)")], {"stiffness", "mass"}, True),
    ("f08", "fenics", "vortex_svk", 28, FX_SMALL, {"unknown"}, False),
    ("f09", "box", "turn_svk", 5, [("+ on_faces\n", "+ 1.15 * on_faces\n")], {"tractions"}, True),
    ("f10", "box", "turn_svk", 5, [("return mass * b + on_faces", "return mass * b + on_faces - 0.6 * mass * v")],
     {"damping"}, True),
    ("f11", "box", "line_svk", 5, [("+ on_faces\n", "- on_faces\n")], {"tractions"}, True),
    # A code of our own.
    ("q01", "quads", "ring_svk", 8, [(Q_BEGIN, "v = 1.2 * v\n" + Q_BEGIN)], {"initial_velocity"}, True),
    ("q02", "quads", "ring_zener", 8, [(Q_B, "b = 2 * points(t, 'b')[:, :2]")], {"body_force"}, True),
    ("q03", "quads", "slow_mr", 24, [(Q_B, "b = points(t, 'b_static')[:, :2]")], {"inertia_term"}, True),
    ("q04", "quads", "ring_mr", 8, [(Q_B, "b = 2 * points(t, 'a')[:, :2] - points(t, 'b')[:, :2]")], {"stress_term"},
     True),
    ("q05", "quads", "ring_zener", 8, [(Q_B, Q_B + BACK.format("*"))], {"force_rotation"}, True),
    ("q06", "quads", "turn_zener", 6, [(Q_B, "b = problem.points(padded(x))(t, 'b')[:, :2]")], {"force_place"}, True),
    ("q07", "quads", "slow_zener", 24, [(Q_LOADS, Q_LOADS + "    t = max(0, t - dt)\n")], {"load_delay"}, False),
    ("q08", "quads", "ring_svk", 8, [(Q_LOADS, Q_LOADS + "    t = min(1.07 * t, problem.end)\n")], {"load_clock"},
     True),
    ("q09", "quads", "ring_mr", 8, [(Q_P, "P = 0.7 * stress(F, dt, memory)")], {"stiffness"}, True),
    ("q10", "quads", "ring_svk", 8, [('LAW["density"]', '1.4 * LAW["density"]')], {"mass"}, True),
    ("q11", "quads", "ring_zener", 8, [("* b + added", "* (b - 0.4 * v) + added")], {"damping"}, True),
    ("q12", "quads", "ring_svk", 8, [(Q_T, "T = 0 * surface.tractions(t, N)[:, :2]")], {"tractions"}, True),
    ("q13", "quads", "turn_zener", 6, [("        S = S + viscous\n", "")], {"unknown"}, False),
    ("q14", "quads", "ring_mr", 8, [("mass = DENSITY * volume", "mass = 1.5 * DENSITY * volume")],
     {"mass_of_inertia"}, False),
    ("q15", "quads", "ring_svk", 8, [('DATA.get("nu", 0)', '0.4')], {"unknown"}, False),
    ("q16", "quads", "path_mr", 6, [(Q_P, Q_P + "\n    P[..., 0, 1] = 0")], {"unknown"}, False),
    ("q17", "quads", "ring_zener", 8,
     [(Q_BEGIN, "v = 0 * v\n" + Q_BEGIN), (Q_T, "T = 0 * surface.tractions(t, N)[:, :2]")],
     {"initial_velocity", "tractions"}, False),  # two at once
    # Nothing is wrong with these.
    ("u01", "mpm", "vortex_mr", 28, ("none", 0, PIC), {"none"}, False),
    ("u02", "mpm", "slow_svk", 32, ("none", 0, FLIP), {"none"}, False),
    ("u03", "mpm", "ring_zener", 6, ("none", 0, CPDI), {"none"}, False),
    ("u04", "mpm", "turn_zener", 5, ("none", 0, PIC), {"none"}, False),
    ("u05", "mpm", "vortex_j2", 28, ("none", 0, XPIC), {"none"}, False),
    ("u06", "fenics", "vortex_mr", 14, [], {"none"}, False),
    ("u07", "fenics", "slow_svk", 16, [], {"none"}, False),
    ("u08", "box", "turn_svk", 4, [], {"none"}, False),
    ("u09", "quads", "ring_svk", 4, [], {"none"}, False),
    ("u10", "quads", "vortex_zener", 14, [], {"none"}, False),
    ("u11", "quads", "path_mr", 3, [], {"none"}, False),
    ("u13", "fenics", "vortex_svk", 20, [], {"none"}, False),
    ("u14", "quads", "path_zener", 4, [], {"none"}, False),
    ("u12", "mpm", "waves_mr", 4, ("none", 0, PIC), {"none"}, False),
]
