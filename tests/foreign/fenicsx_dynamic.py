# SPDX-License-Identifier: BSD-3-Clause
"""FEniCSx 0.5 against the generalized vortex: total Lagrangian, bilinear elements, lumped mass, central differences.

Nothing in FEniCSx is changed. assay gives the initial velocity, the body force at the nodes, and the exact positions
with which the error is measured. usage: fenicsx_dynamic.py; exit 1 if a bound is not met, 77 if a package is missing.
"""
import math
import sys
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

SCENE = """
motion:   {type: vortex, profile_power: 4, period: 1, amplitude: {type: sine, peak: 0.25}}
material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}, density: 1000}
"""
E, NU = 1e3, 0.3
LAMBDA, MU = E * NU / (1 + NU) / (1 - 2 * NU), E / 2 / (1 + NU)
HALF = 1.5  # of the square's edge; the ring ends at 1.25 [m]
COURANT = 0.5
LEAST_ORDER, MOST_AT_64 = 1.95, 4e-3


def largest_error(n):
    """Largest L2 error of the displacement over time [m], n x n elements."""
    square = mesh.create_rectangle(MPI.COMM_SELF, [[-HALF, -HALF], [HALF, HALF]], [n, n], mesh.CellType.quadrilateral)
    V = fem.VectorFunctionSpace(square, ("Lagrange", 1))
    u, test = fem.Function(V), ufl.TestFunction(V)
    F = ufl.Identity(2) + ufl.grad(u)  # plane strain: F33 = 1
    P = MU * (F - ufl.inv(F).T) + LAMBDA * ufl.ln(ufl.det(F)) * ufl.inv(F).T
    internal = fem.form(ufl.inner(P, ufl.grad(test)) * ufl.dx)

    # ---- what assay is asked for
    problem = assay.Problem(text=SCENE)
    X = V.tabulate_dof_coordinates()
    points = problem.points(X)
    b = np.empty((len(X), 2))
    x = points(0, "x")

    ones = fem.Function(V)
    ones.x.array[:] = 1
    volume = fem.assemble_vector(fem.form(ufl.inner(ones, test) * ufl.dx)).array.reshape(-1, 2)
    R = np.hypot(X[:, 0], X[:, 1])
    weight = np.where((R > 0.75) & (R < 1.25), volume[:, 0], 0)  # where the exact motion moves
    weight /= weight.sum()

    def acceleration(t):
        points(t, "b", out=b)  # per mass [m/s^2]
        force = fem.assemble_vector(internal).array.reshape(-1, 2)
        return b - force / (problem.density * volume)

    steps = math.ceil(problem.period / (COURANT * 2 * HALF / n / problem.wave_speed))
    dt, worst = problem.period / steps, 0
    displacement = u.x.array.reshape(-1, 2)
    velocity = points(0, "v") + 0.5 * dt * acceleration(0)  # at dt/2
    for step in range(1, steps + 1):
        displacement += dt * velocity
        points(step * dt, "x", out=x)
        worst = max(worst, math.sqrt(weight @ ((X[:, :2] + displacement - x)**2).sum(1)))
        velocity += dt * acceleration(step * dt)
    return worst, steps


def main():
    print("  n   steps   largest L2 error [m]   order   seconds")
    good, before = True, None
    for n in (32, 64, 128):
        began = time.perf_counter()
        error, steps = largest_error(n)
        order = math.log2(before / error) if before else math.nan
        print(f"{n:3d} {steps:7d} {error:18.3e} {order:11.2f} {time.perf_counter() - began:9.1f}")
        good = good and not order < LEAST_ORDER and (n != 64 or error <= MOST_AT_64)
        before = error
    print("as expected" if good else f"NOT as expected: orders >= {LEAST_ORDER}, at n = 64 <= {MOST_AT_64:g} m")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
