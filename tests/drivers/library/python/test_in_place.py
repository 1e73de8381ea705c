# SPDX-License-Identifier: BSD-3-Clause
"""The Python package reads and fills memory of the caller where it lies.

usage: test_in_place.py SOURCE_DIR [--without-numpy] [UNITTEST ARGUMENTS]; PYTHONPATH names the package
"""
import unittest
from array import array

from support import POINTS, SCENE, flat, listed, needs_numpy, np

import assay


class InPlace(unittest.TestCase):
    """Memory of the caller is filled where it lies."""

    def setUp(self):
        self.pts = assay.Problem(SCENE).points(POINTS)
        self.b = listed(self.pts(0.3, "b"))

    def test_flat_buffers(self):
        out = array("d", [9.0] * 10)
        self.assertIs(self.pts(0.3, "b", out=out), out)
        self.assertEqual(out.tolist(), flat(self.b))
        view = memoryview(array("d", [9.0] * 20))[::2]
        self.pts(0.3, "b", out=view)
        self.assertEqual(view.tolist(), flat(self.b))

    def test_several(self):
        x, b, status = array("d", [0.0] * 10), array("d", [0.0] * 10), array("i", [9] * 5)
        found = self.pts(0.3, "x", "b", "F", "status", out=(x, b, None, status))
        self.assertIs(found[0], x)
        self.assertIs(found[1], b)
        self.assertEqual(b.tolist(), flat(self.b))
        self.assertEqual(status.tolist(), [0] * 5)
        self.assertEqual(len(found[2]), 5)

    @needs_numpy
    def test_strides(self):
        layouts = {"rows": np.empty((5, 2)), "columns": np.empty((5, 2), order="F"),
                   "backwards": np.empty((5, 2))[::-1], "mirrored": np.empty((5, 2))[:, ::-1],
                   "part": np.empty((5, 3, 4))[:, :2, 2],
                   "transposed": np.empty((2, 5)).T}
        for name, out in layouts.items():
            self.assertIs(self.pts(0.3, "b", out=out), out)
            self.assertEqual(out.tolist(), self.b, name)
        F = np.empty((5, 9))
        self.pts(0.3, "F", out=F)
        self.assertEqual(F.reshape(5, 3, 3).tolist(), self.pts(0.3, "F").tolist())
        whole = np.full((10, 2), 7.0)
        self.pts(0.3, "b", out=whole[::2])
        self.assertEqual(whole[1::2].tolist(), [[7.0, 7.0]] * 5)

    @needs_numpy
    def test_points_of_any_layout(self):
        problem = assay.Problem(SCENE)
        wide = np.array([[*point, 5.0, 5.0] for point in POINTS])
        for X in (np.array(POINTS, order="F"), wide[:, :2], np.array(POINTS)[::-1][::-1], np.array(POINTS).ravel(),
                  memoryview(np.array(POINTS))):
            self.assertEqual(listed(problem.points(X)(0.3, "b")), self.b)
        whole = problem.points(np.array([[1, 0], [0, 1]]))(0.3, "b")  # of another type: converted
        self.assertEqual(listed(whole)[0], self.b[0])

    def test_the_points_are_a_copy(self):
        X = array("d", flat(POINTS))
        pts = assay.Problem(SCENE).points(X)
        X[0] = 99.0
        X.append(1.0)  # nothing holds it any more
        self.assertEqual(listed(pts(0.3, "b")), self.b)

    def test_what_does_not_fit_is_refused(self):
        for out in (array("d", [0.0] * 9), array("f", [0.0] * 10), b"\0" * 80, [0.0] * 10, None if np is None else
                    np.empty((2, 5)), 7):
            if out is None:
                continue
            with self.assertRaises(assay.InputError) as caught:
                self.pts(0.3, "b", out=out)
            self.assertIn(caught.exception.key, ("b", "out"))
        with self.assertRaisesRegex(assay.InputError, r"\(5, 2\)"):
            self.pts(0.3, "b", out=array("d", [0.0] * 9))


if __name__ == "__main__":
    unittest.main()
