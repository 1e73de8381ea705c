# SPDX-License-Identifier: BSD-3-Clause
"""FEniCSx 0.5 with tractions: a square in the plane whose F is the same everywhere, Saint Venant-Kirchhoff.

usage: fenicsx_box.py SCENE LOWER UPPER CELLS OUT.npz. The forces on the nodes come from the library. blind.py runs
copies of it in which a line differs.
"""
import math
import sys

import assay
import numpy as np
import ufl
import yaml
from dolfinx import fem, mesh
from mpi4py import MPI

SCENE, LOWER, UPPER, CELLS, OUT = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4]), sys.argv[5]
MATERIAL = yaml.safe_load(open(SCENE))["material"]
E, NU, DENSITY = MATERIAL["parameters"]["E"], MATERIAL["parameters"]["nu"], MATERIAL["density"]
MU, LAMBDA = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))
FRAMES = 20

problem = assay.Problem(SCENE)
square = mesh.create_rectangle(MPI.COMM_SELF, [[LOWER] * 2, [UPPER] * 2], [CELLS] * 2, mesh.CellType.quadrilateral)
V = fem.VectorFunctionSpace(square, ("Lagrange", 1))
u, test = fem.Function(V), ufl.TestFunction(V)
F = ufl.Identity(2) + ufl.grad(u)
strain = (F.T * F - ufl.Identity(2)) / 2
P = F * (LAMBDA * ufl.tr(strain) * ufl.Identity(2) + 2 * MU * strain)
internal = fem.form(ufl.inner(P, ufl.grad(test)) * ufl.dx(metadata={"quadrature_degree": 3}))
ones = fem.Function(V)
ones.x.array[:] = 1
volume = fem.assemble_vector(fem.form(ufl.inner(ones, test) * ufl.dx)).array.reshape(-1, 2)
mass = DENSITY * volume

# The library wants corners in order around an element, and a box where the motion has three components.
X = V.tabulate_dof_coordinates()[:, :2]
elements = V.dofmap.list.array.reshape(-1, 4)[:, [0, 1, 3, 2]].astype(np.int64)
points = problem.points(np.pad(X, ((0, 0), (0, problem.dimension - 2))))
edges = np.concatenate([elements[:, [k, (k + 1) % 4]] for k in range(4)])
shared, first, count = np.unique(np.sort(edges, 1), axis=0, return_index=True, return_counts=True)
edges = edges[first[count == 1]]
along = X[edges[:, 1]] - X[edges[:, 0]]
normals = np.stack([along[:, 1], -along[:, 0]], 1)
normals *= np.sign((normals * (X[edges].mean(1) - X.mean(0))).sum(1))[:, None]  # outwards
normals = np.pad(normals, ((0, 0), (0, problem.dimension - 2)))
middles = problem.points(np.pad(X[edges].mean(1), ((0, 0), (0, problem.dimension - 2))))


def forces(t):
    """On the nodes, by b and by the tractions."""
    b = points(t, "b")[:, :2]
    T = middles.tractions(t, normals)[:, :2] * np.linalg.norm(along, axis=1)[:, None] / 2
    on_faces = np.zeros_like(X)
    for end in edges.T:
        np.add.at(on_faces, end, T)
    return mass * b + on_faces


def acceleration(t):
    inner = fem.assemble_vector(internal).array.reshape(-1, 2)
    return (forces(t) - inner) / mass


h = (UPPER - LOWER) / CELLS
steps = FRAMES * math.ceil(problem.end * problem.wave_speed / (0.4 * h * FRAMES))
dt = problem.end / steps
displacement, v = u.x.array.reshape(-1, 2), points(0.0, "v")[:, :2].copy()
frames = [(0.0, X.copy(), v.copy())]
a = acceleration(0)
for step in range(1, steps + 1):
    half = v + dt / 2 * a
    displacement += dt * half
    a = acceleration(step * dt)
    v = half + dt / 2 * a
    if step % (steps // FRAMES) == 0:
        frames.append((step * dt, X + displacement, v))
t, x, v = (np.array(values) for values in zip(*frames))
np.savez(OUT, t=t, id=np.arange(len(X)), X=X, x=x, v=v)
