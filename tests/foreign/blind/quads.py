# SPDX-License-Identifier: BSD-3-Clause
"""A small finite element code: total Lagrangian, bilinear quadrilaterals on a box or a ring, lumped mass, explicit.

usage: quads.py SCENE BODY CELLS OUT.npz, BODY: box:LOWER:UPPER (a square) or ring:INNER:OUTER. blind.py runs copies of
it in which a line differs.
"""
import sys

import assay
import numpy as np
import yaml

SCENE, BODY, CELLS, OUT = sys.argv[1], sys.argv[2].split(":"), int(sys.argv[3]), sys.argv[4]
FRAMES, COURANT = 20, 0.3
LAW = yaml.safe_load(open(SCENE))["material"]
DATA, LAW, DENSITY = LAW["parameters"], LAW["adapter"], LAW["density"]
E, NU = DATA.get("E", 0), DATA.get("nu", 0)
MU, LAMBDA = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))
ONE = np.eye(3)
problem = assay.Problem(SCENE)


def mesh(low, high, n):
    """Nodes, elements, and (node, normal, length) of the ends of the edges on the surface."""
    line = low + (high - low) / n * np.arange(n + 1)
    if BODY[0] == "box":
        X, m = np.stack(np.meshgrid(line, line), -1).reshape(-1, 2), n
    else:                                                        # columns go outwards, rows around
        m = round(2 * np.pi * low * n / (high - low))
        angle = 2 * np.pi * np.arange(m) / m
        X = (line[None, :, None] * np.stack([np.cos(angle), np.sin(angle)], -1)[:, None]).reshape(-1, 2)
    rows = len(X) // (n + 1)
    node = np.arange(len(X)).reshape(rows, n + 1)
    up = np.roll(node, -1, 0) if BODY[0] == "ring" else node[1:]
    here = node[:len(up)]
    elements = np.stack([here[:, :-1], here[:, 1:], up[:, 1:], up[:, :-1]], -1).reshape(-1, 4)
    edges = [(here[:, c], up[:, c], c) for c in (0, -1)] + [(node[r, :-1], node[r, 1:], r) for r in (0, -1)]
    surface = []
    for k, (a, b, last) in enumerate(edges if BODY[0] == "box" else edges[:2]):
        length = np.linalg.norm(X[b] - X[a], axis=1)
        for end in (a, b):
            N = np.tile(np.eye(2)[k // 2], (len(a), 1)) if BODY[0] == "box" else X[end] / abs(line[last])
            surface.append((end, N if last else -N, length / 2))
    return X, elements, *(np.concatenate(parts) for parts in zip(*surface))


def stress(F, dt, memory):
    """First Piola-Kirchhoff stress; memory: C^-1 before and the viscous stress of a Zener solid."""
    C = np.swapaxes(F, -1, -2) @ F
    if LAW == "saint_venant_kirchhoff":
        strain = (C - ONE) / 2
        return F @ (LAMBDA * np.trace(strain, axis1=-2, axis2=-1)[..., None, None] * ONE + 2 * MU * strain)
    J, inverse = np.linalg.det(F)[..., None, None], np.linalg.inv(C)
    if LAW == "mooney_rivlin":
        trace = np.trace(C, axis1=-2, axis2=-1)[..., None, None]
        second = (trace**2 - np.trace(C @ C, axis1=-2, axis2=-1)[..., None, None]) / 2
        S = 2 * DATA["c10"] * J**(-2 / 3) * (ONE - trace / 3 * inverse) + DATA["bulk_modulus"] * np.log(J) * inverse
        S = S + 2 * DATA.get("c01", 0) * J**(-4 / 3) * (trace * ONE - C - 2 / 3 * second * inverse)
    else:                                                        # zener
        S = MU * (ONE - inverse) + LAMBDA * np.log(J) * inverse
        D = dt / DATA["relaxation_time"]
        before, viscous = memory or (ONE, 0 * S)
        viscous = np.exp(-D) * viscous + DATA["viscous_ratio"] * MU * (before - inverse) * (-np.expm1(-D) / D)
        memory[:] = [inverse, viscous]
        S = S + viscous
    return F @ S


X, elements, face, N, length = mesh(float(BODY[1]), float(BODY[2]), CELLS)
corner = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
natural = corner * (1 + corner[None, :, ::-1] * corner[:, None, ::-1] / np.sqrt(3)) / 4
jacobian = np.einsum("eki,gkd->egid", X[elements], natural)
weight, slopes = np.linalg.det(jacobian), np.einsum("gkd,egdi->egki", natural, np.linalg.inv(jacobian))
shape = np.prod(1 + corner[None] * corner[:, None] / np.sqrt(3), -1) / 4
volume = np.bincount(elements.ravel(), np.einsum("eg,gk->ek", weight, shape).ravel(), len(X))
mass = DENSITY * volume


def padded(vectors):                                             # some plane motions have three components
    return np.pad(vectors, ((0, 0), (0, problem.dimension - 2)))


points, surface, N = problem.points(padded(X)), problem.points(padded(X[face])), padded(N)


def added(values, nodes):
    return np.stack([np.bincount(nodes.ravel(), values[..., i].ravel(), len(X)) for i in (0, 1)], 1)


def loads(t, x, v):
    """Forces on the nodes but for those of the stress."""
    b = points(t, "b")[:, :2]
    T = surface.tractions(t, N)[:, :2]
    return DENSITY * volume[:, None] * b + added(T * length[:, None], face)


def inner(x, dt, memory):
    F = np.zeros(weight.shape + (3, 3))
    F[..., 2, 2] = 1
    F[..., :2, :2] = np.einsum("eki,egkd->egid", x[elements], slopes)
    P = stress(F, dt, memory)
    return added(np.einsum("egid,egkd,eg->eki", P[..., :2, :2], slopes, weight), elements)


h = (float(BODY[2]) - float(BODY[1])) / CELLS
steps = FRAMES * int(np.ceil(problem.end * problem.wave_speed / (COURANT * h) / FRAMES))
dt, memory = problem.end / steps, []
x, v = (field[:, :2].copy() for field in points(0.0, "x", "v"))
frames = [(0.0, x.copy(), v.copy())]
a = (loads(0, x, v) - inner(x, dt, memory)) / mass[:, None]
for step in range(1, steps + 1):
    v = v + dt / 2 * a
    x = x + dt * v
    a = (loads(step * dt, x, v) - inner(x, dt, memory)) / mass[:, None]
    v = v + dt / 2 * a
    if step % (steps // FRAMES) == 0:
        frames.append((step * dt, x.copy(), v.copy()))
t, x, v = (np.array(values) for values in zip(*frames))
np.savez(OUT, t=t, id=np.arange(len(X)), X=X, x=x, v=v, volume=volume)
