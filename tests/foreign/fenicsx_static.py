# SPDX-License-Identifier: BSD-3-Clause
"""FEniCSx 0.5 against the generalized vortex without inertia: Newton's method, with a tangent written by hand.

assay gives b_static, the body force that holds the body in its exact deformed state at each load. The same is solved
again with a fault in the tangent: the answer stays, the number of iterations does not.
usage: fenicsx_static.py; exit 1 if a bound is not met, 77 if a package is missing.
"""
import math
import sys
import time

try:
    import numpy as np
    import ufl
    from dolfinx import fem, mesh
    from mpi4py import MPI
    from petsc4py import PETSc
except ImportError as missing:
    print(f"skipped: {missing.name} is not there (Debian: python3-dolfinx)")
    sys.exit(77)
import assay

SCENE = """
motion:   {type: vortex, inner: 0.25, profile_power: 4, period: 1, amplitude: {type: sine, peak: 0.25}}
material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}, density: 1000}
"""
E, NU = 1e3, 0.3
LAMBDA, MU = E * NU / (1 + NU) / (1 - 2 * NU), E / 2 / (1 + NU)
HALF = 1.5  # of the square's edge; the ring ends at 1.25 [m]
LOADS = [0.25, 0.5]  # times, which are a parameter here: 0.5 is the largest deformation
CONVERGED = 1e-10  # residual, of the load's norm
LEAST_ORDER = 1.95
SAME_ANSWER = 1e-8  # difference of two converged answers [m]


def stress(F):
    return MU * (F - ufl.inv(F).T) + LAMBDA * ufl.ln(ufl.det(F)) * ufl.inv(F).T


def stress_change(F, dF, fault):
    """The author's tangent: dP of dF. fault: the shear stiffness of its second term is halved."""
    inverse = ufl.inv(F)
    shear = (0.5 if fault else 1) * (MU - LAMBDA * ufl.ln(ufl.det(F)))
    return MU * dF + shear * inverse.T * dF.T * inverse.T + LAMBDA * ufl.tr(inverse * dF) * inverse.T


def solve(n, fault=False):
    """Largest L2 error over the loads [m], mean number of Newton's iterations, last displacement."""
    square = mesh.create_rectangle(MPI.COMM_SELF, [[-HALF, -HALF], [HALF, HALF]], [n, n], mesh.CellType.quadrilateral)
    V = fem.VectorFunctionSpace(square, ("Lagrange", 1))
    u, b, test, trial = fem.Function(V), fem.Function(V), ufl.TestFunction(V), ufl.TrialFunction(V)

    # ---- what assay is asked for
    problem = assay.Problem(text=SCENE)
    X = V.tabulate_dof_coordinates()
    points = problem.points(X)

    F = ufl.Identity(2) + ufl.grad(u)  # plane strain: F33 = 1
    load = problem.density * ufl.inner(b, test) * ufl.dx
    residual = fem.form(ufl.inner(stress(F), ufl.grad(test)) * ufl.dx - load)
    load = fem.form(load)
    tangent = fem.form(ufl.inner(stress_change(F, ufl.grad(trial), fault), ufl.grad(test)) * ufl.dx)
    edge = mesh.locate_entities_boundary(square, 1, lambda x: np.full(x.shape[1], True))
    held = fem.dirichletbc(np.zeros(2), fem.locate_dofs_topological(V, 1, edge), V)

    solver = PETSc.KSP().create(MPI.COMM_SELF)
    solver.setType("preonly")
    solver.getPC().setType("lu")
    R = np.hypot(X[:, 0], X[:, 1])
    moves = (R > 0.25) & (R < 1.25)  # a lattice of equal nodes: volume-weighted is the mean over them
    worst = iterations = 0
    for t in LOADS:
        points(t, "b_static", out=b.x.array.reshape(-1, 2))
        for iteration in range(100):
            r = fem.petsc.assemble_vector(residual)
            fem.set_bc(r.array, [held])
            if r.norm() <= CONVERGED * fem.petsc.assemble_vector(load).norm():
                break
            A = fem.petsc.assemble_matrix(tangent, bcs=[held])
            A.assemble()
            solver.setOperators(A)
            change = r.duplicate()
            solver.solve(r, change)
            u.x.array[:] -= change.array
        else:
            raise RuntimeError("Newton's method has not converged in 100 iterations")
        iterations += iteration
        error = X[:, :2] + u.x.array.reshape(-1, 2) - points(t, "x")
        worst = max(worst, math.sqrt((error[moves]**2).sum(1).mean()))
    return worst, iterations / len(LOADS), u.x.array.copy()


def main():
    print("  n   tangent   iterations a load   largest L2 error [m]   order   seconds")
    good, before = True, None
    for n, fault in ((40, False), (80, False), (160, False), (80, True)):
        began = time.perf_counter()
        error, iterations, answer = solve(n, fault)
        order = math.log2(before / error) if before and not fault else math.nan
        print(f"{n:3d}   {'faulty ' if fault else 'correct'} {iterations:14.1f} {error:24.3e} {order:11.2f}"
              f" {time.perf_counter() - began:9.1f}")
        good = good and not order < LEAST_ORDER
        before = error
        if n == 80 and not fault:
            right, usual = answer, iterations
    good = good and abs(answer - right).max() < SAME_ANSWER and iterations > 2 * usual
    print("as expected" if good else f"NOT as expected: orders >= {LEAST_ORDER}, the same answer with a faulty tangent "
          "after more than twice the iterations")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
