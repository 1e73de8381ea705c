# SPDX-License-Identifier: BSD-3-Clause
"""What the Python package answers in this process is what the program answers.

usage: test_values.py SOURCE_DIR [--without-numpy] [UNITTEST ARGUMENTS]; PYTHONPATH names the package
"""
import csv
import io
import math
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import POINTS, SCENE, SPATIAL, flat, listed

import assay
from assay import _program


def evaluated(scene, points, t):
    """Rows of `assay eval`, by their columns."""
    letters = "XYZ"[:len(points[0])]
    text = ",".join(letters) + ",t\n" + "".join(",".join(map(repr, [*point, t])) + "\n" for point in points)
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "points.csv")
        Path(file).write_text(text)
        done = subprocess.run([_program._program(), "eval", scene, "--points", file], check=True, capture_output=True,
                              text=True)
    return [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(io.StringIO(done.stdout))]


class Values(unittest.TestCase):
    """What is asked in this process is what the program answers, to the last bit."""

    def agree(self, scene, points, t):
        problem = assay.Problem(scene)
        pts, rows = problem.points(points), evaluated(scene, points, t)
        letters = "xyz"[:problem.dimension]
        x, v, a, b, F, P, sigma = map(listed, pts(t, "x", "v", "a", "b", "F", "P", "sigma"))
        for p, row in enumerate(rows):
            for name, found in (("", x), ("v", v), ("a", a), ("b", b)):
                self.assertEqual([row[name + letter] for letter in letters], found[p], (name, p))
            for name, found in (("F", F), ("P", P)):
                for i in range(3):
                    for j in range(3):
                        column = f"{name}{i + 1}{j + 1}"
                        if column in row:
                            self.assertEqual(row[column], found[p][i][j], column)
            for k, column in enumerate(("s11", "s22", "s33", "s12", "s13", "s23")):
                if column in row:
                    self.assertEqual(row[column], sigma[p][k], column)

    def test_plane(self):
        for t in (0.0, 0.3, 0.5, 1.0):
            self.agree(SCENE, POINTS, t)

    def test_space(self):
        self.agree(SPATIAL, [[0.1, 0.2, 0.3], [0.4, -0.1, 0.2], [0.0, 0.3, -0.35]], 0.21)

    def test_shapes(self):
        pts = assay.Problem(SCENE).points(POINTS)
        self.assertEqual(len(pts), 5)
        for field, shape in {"x": (5, 2), "b_static": (5, 2), "F": (5, 3, 3), "sigma": (5, 6), "status": (5,)}.items():
            found = pts(0.1, field)
            for extent in shape:
                self.assertEqual(len(found), extent, field)
                found = found[0]
        self.assertEqual(listed(pts(0.1, "status")), [0] * 5)
        self.assertEqual(len(assay.Problem(SCENE).points([])(0.1, "b")), 0)

    def test_static(self):
        a, b, static = map(flat, assay.Problem(SCENE).points(POINTS)(0.3, "a", "b", "b_static"))
        for one, other, rest in zip(a, b, static):
            self.assertAlmostEqual(one + rest, other, delta=1e-12 * (1 + abs(other)))

    def test_third_component_is_ignored_in_the_plane(self):
        problem = assay.Problem(SCENE)
        lifted = problem.points([[*point, 7.0] for point in POINTS])
        self.assertEqual(listed(lifted(0.3, "b")), listed(problem.points(POINTS)(0.3, "b")))

    def test_parts_make_the_whole(self):
        pts = assay.Problem(SCENE).points(POINTS)
        self.assertEqual(listed(pts(0.3, "b", count=2)) + listed(pts(0.3, "b", first=2)), listed(pts(0.3, "b")))

    def test_sets_and_text(self):
        text = Path(SCENE).read_text()
        one = assay.Problem(SCENE, sets=["motion.amplitude.peak=0.1"]).points(POINTS)(0.3, "b")
        other = assay.Problem(text=text, sets={"motion.amplitude.peak": 0.1}).points(POINTS)(0.3, "b")
        self.assertEqual(listed(one), listed(other))
        self.assertNotEqual(listed(one), listed(assay.Problem(SCENE).points(POINTS)(0.3, "b")))

    def test_facts(self):
        problem = assay.Problem(SCENE)
        self.assertEqual((problem.dimension, problem.end, problem.period, problem.density), (2, 1.0, 1.0, 1000.0))
        self.assertGreater(problem.wave_speed, math.sqrt(1e3 * 0.7 / (1.3 * 0.4) / 1e3))  # more than at rest
        self.assertGreater(problem.particle_speed, 0.25 * math.pi * 0.98)                # of the circle R = 1
        self.assertEqual(problem.warnings, [])
        self.assertIsInstance(problem.description, dict)
        self.assertIn("2 dimensions", repr(problem))

    def test_current_positions_lead_back(self):
        problem = assay.Problem(SCENE)
        x, b = problem.points(POINTS)(0.3, "x", "b")
        X, found, status = problem.at_current(x, 0.3, "X", "b", "status")
        self.assertEqual(listed(status), [0] * 5)
        for one, other in zip(flat(X) + flat(found), flat(POINTS) + flat(b)):
            self.assertAlmostEqual(one, other, delta=1e-9 * (1 + abs(other)))

    def test_tractions_are_the_stress_on_the_normal(self):
        pts = assay.Problem(SCENE).points(POINTS)
        normals = [[1.0, 0.0], [0.0, 2.0], [3.0, 4.0], [-1.0, 0.0], [0.0, 1.0]]
        P = listed(pts(0.3, "P"))
        for found, stress, (one, two) in zip(listed(pts.tractions(0.3, normals)), P, normals):
            for i in range(2):
                exact = (stress[i][0] * one + stress[i][1] * two) / math.hypot(one, two)
                self.assertAlmostEqual(found[i], exact, delta=1e-12 * (1 + abs(exact)))

    def test_cells(self):
        corners = [[[1.0, 0.0], [1.01, 0.0], [1.01, 0.01], [1.0, 0.01]]]
        problem = assay.Problem(SCENE)
        cells = problem.cells(corners)
        self.assertEqual(len(cells), 1)
        self.assertAlmostEqual(listed(cells.volumes)[0], 1e-4, delta=1e-15)
        for one, other in zip(flat(cells(0.3)), flat(problem.points([[1.005, 0.005]])(0.3, "b"))):
            self.assertAlmostEqual(one, other, delta=5e-2)  # a mean over 0.01 m of what changes over 0.25 m

    def test_loads_of_a_patch_add_up_to_the_force_on_it(self):
        side = [-1.5 + 0.25 * k for k in range(13)]
        X = [[x, y] for y in side for x in side]
        quads = [[j * 13 + i, j * 13 + i + 1, j * 13 + i + 14, j * 13 + i + 13] for j in range(12) for i in range(12)]
        problem = assay.Problem(SCENE)
        mesh = problem.mesh(X, quads, "quadrilateral", gauss=8)
        self.assertEqual(len(mesh), 169)
        for c in range(2):  # the vortex moves no centre of mass, and nothing pulls at the square
            self.assertAlmostEqual(sum(row[c] for row in listed(mesh.loads(0.3))), 0.0, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
