# SPDX-License-Identifier: BSD-3-Clause
"""FEniCSx 0.5 against the vortex in a ball: total Lagrangian, trilinear hexahedra, lumped mass, central differences.

assay gives the initial velocity and the body force at the nodes; what FEniCSx writes goes to `assay judge`. The axis is
tilted, so every component of the stress bears load. The same is run again with mistakes in the stress: 13 and 23
exchanged, 13 halved. usage: fenicsx_space.py ASSAY, ASSAY: the program; exit 1 if judge does not find the order of the
right code, or does not see a mistake; 77 if a package is missing.
"""
import json
import math
import os
import subprocess
import sys
import tempfile
import time

try:
    import numpy as np
    import ufl
    from dolfinx import fem, mesh
    from mpi4py import MPI
except ImportError as missing:
    print(f"skipped: {missing.name} is not there (Debian: python3-dolfinx)")
    sys.exit(77)
import assay

HERE = os.path.dirname(os.path.abspath(__file__))
SCENE = os.path.join(HERE, "..", "..", "configs", "standard", "1", "vortex3d.yaml")
E, NU = 1e3, 0.3
LAMBDA, MU = E * NU / (1 + NU) / (1 - 2 * NU), E / 2 / (1 + NU)
HALF = 1.2  # of the cube's edge; the ball ends at 1 [m]
COURANT, FRAMES = 0.5, 20
LEAST_ORDER, MOST_AT_32 = 1.95, 1.2e-3


def right(s):
    return s


def exchanged(s):
    """13 and 23, as of a Voigt vector in another order."""
    return ufl.as_tensor([[s[0, 0], s[0, 1], s[1, 2]], [s[1, 0], s[1, 1], s[0, 2]], [s[2, 1], s[2, 0], s[2, 2]]])


def halved(s):
    """13, as of an engineering strain that is taken for a tensor's component."""
    return ufl.as_tensor([[s[0, 0], s[0, 1], s[0, 2] / 2], [s[1, 0], s[1, 1], s[1, 2]],
                          [s[2, 0] / 2, s[2, 1], s[2, 2]]])


def run(problem, n, mistake, path):
    """Moves n x n x n elements, writes positions and velocities of the nodes over time."""
    cube = mesh.create_box(MPI.COMM_SELF, [[-HALF] * 3, [HALF] * 3], [n] * 3, mesh.CellType.hexahedron)
    V = fem.VectorFunctionSpace(cube, ("Lagrange", 1))
    u, test = fem.Function(V), ufl.TestFunction(V)
    F = ufl.Identity(3) + ufl.grad(u)
    J = ufl.det(F)
    cauchy = mistake((MU * (F * F.T - ufl.Identity(3)) + LAMBDA * ufl.ln(J) * ufl.Identity(3)) / J)
    dx = ufl.dx(metadata={"quadrature_degree": 3})  # two Gauss points in each direction
    internal = fem.form(ufl.inner(J * cauchy * ufl.inv(F).T, ufl.grad(test)) * dx)

    # ---- what assay is asked for
    X = V.tabulate_dof_coordinates()
    points = problem.points(X)
    b = np.empty_like(X)

    ones = fem.Function(V)
    ones.x.array[:] = 1
    volume = fem.assemble_vector(fem.form(ufl.inner(ones, test) * dx)).array.reshape(-1, 3)

    def acceleration(t):
        points(t, "b", out=b)  # per mass [m/s^2]
        return b - fem.assemble_vector(internal).array.reshape(-1, 3) / (problem.density * volume)

    steps = FRAMES * math.ceil(problem.period / (COURANT * 2 * HALF / n / problem.wave_speed) / FRAMES)
    dt = problem.period / steps
    displacement = u.x.array.reshape(-1, 3)
    v, a = points(0, "v"), acceleration(0)
    frames = [(0.0, X.copy(), v)]
    for step in range(1, steps + 1):
        half = v + 0.5 * dt * a  # the velocity in the middle of the step
        displacement += dt * half
        a = acceleration(step * dt)
        v = half + 0.5 * dt * a
        if step % (steps // FRAMES) == 0:
            frames.append((step * dt, X + displacement, v))
    t, x, v = (np.array(values) for values in zip(*frames))
    np.savez(path, t=t, id=np.arange(len(X)), X=X, volume=volume[:, 0], x=x, v=v)


def judged(program, ladder, mistake, folder):
    """The exit status of `assay judge`, and what it has found."""
    problem = assay.Problem(SCENE)
    files = [os.path.join(folder, f"{mistake.__name__}_{n}.npz") for n in ladder]
    for n, path in zip(ladder, files):
        with np.errstate(all="ignore"):  # a body may fly apart
            run(problem, n, mistake, path)
    h = ",".join(f"{2 * HALF / n:g}" for n in ladder)
    done = subprocess.run([program, "judge", SCENE, *files, "--h", h, "--order", str(LEAST_ORDER), "-o",
                           os.path.join(folder, mistake.__name__), "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"assay judge ended with {done.returncode}: {done.stderr}")
    return done.returncode, json.loads(done.stdout)


def main(program):
    good = True
    for mistake, ladder in ((right, [16, 24, 32]), (exchanged, [16, 24]), (halved, [16, 24])):
        began = time.perf_counter()
        with tempfile.TemporaryDirectory() as folder:
            status, found = judged(os.path.abspath(program), ladder, mistake, folder)
        errors = [grid["error"]["l2_max"] for grid in found["runs"]]
        for n, error in zip(ladder, errors):
            print(f"{mistake.__name__}, {n} x {n} x {n} elements: largest L2 error {error or math.nan:.3e} m")
        print(f"  {time.perf_counter() - began:.1f} s; judge ends with {status}: {found['verdict']}")
        of_data = any(grid["labels"] for grid in found["runs"])  # nothing is wrong with how the files are written
        good = good and not of_data and (status == 0 and errors[-1] <= MOST_AT_32 if mistake is right else status == 1)
    print("as expected" if good else f"NOT as expected: order >= {LEAST_ORDER}, at n = 32 <= {MOST_AT_32:g} m, and "
          "status 1 with each mistake")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
