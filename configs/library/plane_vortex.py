# SPDX-License-Identifier: BSD-3-Clause
"""A finite element code of its own, verified: total Lagrangian, bilinear quadrilaterals, lumped mass, explicit.

python3 plane_vortex.py plane_vortex.yaml     needs the package assay and numpy
"""
import sys

import assay
import numpy as np

E, NU = 1e3, 0.3                                                      # the author's material [Pa]
MU, LAMBDA = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))
CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])


def stress(F):
    """Neo-Hookean in plane strain: P = mu (F - F^-T) + lambda ln J F^-T, shape (..., 2, 2)."""
    inverse = np.swapaxes(np.linalg.inv(F), -1, -2)
    return MU * (F - inverse) + LAMBDA * np.log(np.linalg.det(F))[..., None, None] * inverse


def grid(n):
    """n x n elements on [-1.5, 1.5]^2: size, nodes, nodes of elements, volumes of nodes, slopes at 2 x 2 points."""
    h = 3 / n
    line = -1.5 + h * np.arange(n + 1)
    X = np.stack(np.meshgrid(line, line), -1).reshape(-1, 2)
    first = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    elements = np.stack([first, first + 1, first + n + 2, first + n + 1], 1)
    volumes = np.bincount(elements.ravel(), minlength=len(X)) * h * h / 4
    opposite = 1 + CORNERS[None, :, ::-1] * CORNERS[:, None, ::-1] / np.sqrt(3)   # (point, node, direction)
    return h, X, elements, volumes, CORNERS * opposite / (2 * h)


def error_of(problem, n):
    """The largest error over time [m]: root mean square over the nodes of the ring."""
    h, X, elements, volumes, slopes = grid(n)
    steps = int(np.ceil(problem.end * problem.wave_speed / (0.3 * h)))
    dt, ring, largest = problem.end / steps, abs(np.hypot(*X.T) - 1) < 0.25, 0.0
    points = problem.points(X)
    x, v = points(0.0, "x", "v")                                      # 1. the seeds: x and v at t = 0
    b, exact = np.empty_like(X), np.empty_like(X)
    for k in range(steps):
        points(k * dt, "b", out=b)                                    # 2. the force: b at the nodes, now
        F = np.einsum("eki,gkd->egid", x[elements], slopes)
        f = -h * h / 4 * np.einsum("egid,gkd->eki", stress(F), slopes)
        inner = np.stack([np.bincount(elements.ravel(), f[..., i].ravel(), len(X)) for i in (0, 1)], 1)
        a = b + inner / (problem.density * volumes[:, None])
        v += a * (dt if k else dt / 2)                                # to the middle of the step
        x += v * dt
        points((k + 1) * dt, "x", out=exact)                          # 3. the judgement: the exact x
        largest = max(largest, np.sqrt(((x - exact)[ring] ** 2).sum(1).mean()))
    return largest


if __name__ == "__main__":
    vortex = assay.Problem(sys.argv[1] if len(sys.argv) > 1 else "plane_vortex.yaml")
    coarse, fine = error_of(vortex, 32), error_of(vortex, 64)
    print(f"errors {coarse:.3e} and {fine:.3e} m, order {np.log2(coarse / fine):.2f}")
