# SPDX-License-Identifier: BSD-3-Clause
"""The finite element code of plane_vortex.py without inertia: Newton's method, on the nodes of the ring.

python3 quasi_static.py plane_vortex.yaml     needs the package assay and numpy
"""
import sys

import assay
import numpy as np
from plane_vortex import LAMBDA, MU, grid, stress


def tangent(F):
    """dP_ij/dF_kl of the author's material, shape (..., 2, 2, 2, 2)."""
    G = np.swapaxes(np.linalg.inv(F), -1, -2)
    one = MU * np.einsum("ik,jl->ijkl", np.eye(2), np.eye(2))
    twist = (MU - LAMBDA * np.log(np.linalg.det(F)))[..., None, None, None, None]
    return one + twist * np.einsum("...il,...kj->...ijkl", G, G) + LAMBDA * np.einsum("...ij,...kl->...ijkl", G, G)


def error_of(problem, n, increments=4):
    """The largest error over the increments to T/2 [m], and the most iterations that one of them took."""
    h, X, elements, volumes, slopes = grid(n)
    ring = abs(np.hypot(*X.T) - 1) < 0.25
    free = np.repeat(ring, 2)                                                    # what lies outside is held
    rows = (2 * elements[:, :, None] + np.arange(2)).reshape(len(elements), 8)   # the unknowns of each element
    points, x, largest, most = problem.points(X), X.copy(), 0.0, 0
    for t in np.linspace(0, problem.period / 2, increments + 1)[1:]:
        load = problem.density * volumes[:, None] * points(t, "b_static")        # t is a parameter
        for iteration in range(1, 30):
            F = np.einsum("eki,gkd->egid", x[elements], slopes)
            inner = h * h / 4 * np.einsum("egid,gkd->eki", stress(F), slopes)
            residual = load.ravel() - np.bincount(rows.ravel(), inner.ravel(), 2 * len(X))
            stiffness = np.zeros((2 * len(X), 2 * len(X)))
            each = h * h / 4 * np.einsum("gaj,egijkl,gbl->eaibk", slopes, tangent(F), slopes, optimize=True)
            np.add.at(stiffness, (rows[:, :, None], rows[:, None, :]), each.reshape(-1, 8, 8))
            step = np.linalg.solve(stiffness[np.ix_(free, free)], residual[free])
            x.reshape(-1)[free] += step
            if abs(step).max() < 1e-11:
                break
        most = max(most, iteration)
        largest = max(largest, np.sqrt(((x - points(t, "x"))[ring] ** 2).sum(1).mean()))
    return largest, most


if __name__ == "__main__":
    vortex = assay.Problem(sys.argv[1] if len(sys.argv) > 1 else "plane_vortex.yaml")
    (coarse, _), (fine, iterations) = error_of(vortex, 16), error_of(vortex, 32)
    print(f"errors {coarse:.3e} and {fine:.3e} m, order {np.log2(coarse / fine):.2f}, at most {iterations} iterations")
