# SPDX-License-Identifier: BSD-3-Clause
"""What a caller gives is taken as it is, or refused: nothing is changed without a word before it reaches the library.

usage: test_arguments.py SOURCE_DIR [--without-numpy] [UNITTEST ARGUMENTS]; PYTHONPATH names the package
"""
import unittest
from fractions import Fraction
from pathlib import Path

from support import POINTS, SCENE, listed, needs_numpy, np

import assay

SQUARE, CELL = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [[0.9, 0.0], [1.0, 0.0], [1.0, 0.1], [0.9, 0.1]]
NO_NUMBERS = ("a", "0.3", b"1", None, [0.3], True, 1j, {}, lambda: 0.3)


class Arguments(unittest.TestCase):
    """Each kind of argument, wherever it is taken."""

    @classmethod
    def setUpClass(cls):
        cls.problem = assay.Problem(SCENE)
        cls.pts = cls.problem.points(POINTS)

    def refuses(self, call, values, key=None):
        for value in values:
            with self.assertRaises(assay.Error, msg=repr(value)) as caught:
                call(value)
            self.assertIsInstance(caught.exception, ValueError, repr(value))
            if key:
                self.assertTrue(caught.exception.key.startswith(key), (caught.exception.key, value))
                self.assertIn(key, str(caught.exception))

    def test_times(self):
        cells, mesh = self.problem.cells([CELL]), self.problem.mesh(SQUARE, [[0, 1, 2, 3]], "quadrilateral")
        for call in (lambda t: self.pts(t, "b"), lambda t: self.pts.tractions(t, POINTS), cells, mesh.loads,
                     lambda t: self.problem.at_current(POINTS, t, "b")):
            self.refuses(call, NO_NUMBERS, "t")
        self.refuses(lambda t: self.pts(t, "b"), (-1.0, float("nan"), float("inf"), 10**400))
        self.assertEqual(listed(self.pts(Fraction(1, 4), "b")), listed(self.pts(0.25, "b")))

    def test_ends(self):
        self.refuses(lambda end: assay.Problem(SCENE, end=end), (*(v for v in NO_NUMBERS if v is not None), 0, -1.0))

    def test_whole_numbers(self):
        beyond = (2**31, 2**32 + 1, 2**40, 2**70, -1, 1.0, "1", True, None)
        self.refuses(lambda n: assay.Problem(SCENE, threads=n), beyond, "threads")
        self.refuses(lambda n: assay.run(SCENE, threads=n), beyond, "threads")
        self.refuses(lambda n: self.problem.mesh(SQUARE, [[0, 1, 2, 3]], "quadrilateral", gauss=n), beyond, "gauss")
        self.refuses(lambda n: self.pts(0.1, "b", first=n), (2**64, -1, 1.0, "1", None), "first")
        self.refuses(lambda n: self.pts(0.1, "b", count=n), (2**64, -1, 1.0, "1"), "count")

    def test_fields(self):
        self.refuses(lambda name: self.pts(0.1, name), ("X", "bb", "", None, 7, ["b"], b"b"), "field")
        self.refuses(lambda name: self.pts(0.1, name, name), ("b",))

    def test_texts(self):
        self.refuses(lambda text: assay.Problem(text=text), (b"motion:", 7, ["a"], "a: \0", "a: \ud800"), "text")
        self.refuses(lambda text: assay.run(text=text), (b"motion:", "a: \0", "a: \ud800"), "text")
        self.refuses(assay.Problem, (7, ["a"], "a\0b", ""), "scene")
        self.refuses(lambda element: self.problem.mesh(SQUARE, [[0, 1, 2, 3]], element),
                     (["quadrilateral"], 9, None, "quad"), "mesh.element")

    def test_changes_of_a_scene(self):
        self.refuses(lambda sets: assay.Problem(SCENE, sets=sets),
                     ("a=1", b"a=1", 7, [3], [None], {3: 1}, {"motion.period": 1j}, {"motion.period": [1, {2, 3}]},
                      ["motion.period=\0"]), "sets")
        self.assertEqual(assay.Problem(SCENE, sets=None).period, 1.0)
        self.assertEqual(assay.Problem(SCENE, sets={"motion.period": 2}).period, 2.0)

    def test_rows(self):
        for make in (self.problem.points, self.problem.cells,
                     lambda X: self.problem.mesh(X, [[0, 1, 2, 3]], "quadrilateral"),
                     lambda N: self.pts.tractions(0.1, N), lambda x: self.problem.at_current(x, 0.1, "b")):
            self.refuses(make, (None, 5, "ab", ["ab"], [["1", "2"]], [[1j, 0]], [[True, False]], [[None, 1.0]],
                                [[1.0, 2.0], [3.0]], [[[1.0], [2.0, 3.0]]], {}, {"X": 1}))
        for table in ([[0, 1, 2, 2.7]], [[0.0, 1.0, 2.0, 3.0]], [["0", "1", "2", "3"]], [[0, 1, 2, None]],
                      [[0, 1, 2, 2**70]], [[0, 1, 2, -1]], [[0, 1, 2]], 7, None):
            self.refuses(lambda nodes: self.problem.mesh(SQUARE, nodes, "quadrilateral"), (table,))

    @needs_numpy
    def test_numbers_of_numpy(self):
        expected = listed(self.pts(0.25, "b"))
        for t in (np.float64(0.25), np.float32(0.25), np.array(0.25)):
            self.assertEqual(listed(self.pts(t, "b", first=np.int64(0), count=np.int32(5))), expected)
        self.refuses(lambda t: self.pts(t, "b"),
                     (np.array([0.25]), np.str_("0.25"), np.bool_(True), np.complex128(1)), "t")
        peak = assay.Problem(SCENE, sets={"motion.period": np.float32(2), "motion.inner": np.float64(0.5)})
        self.assertEqual(peak.period, 2.0)
        for X in (np.array(POINTS, dtype=complex), np.array(POINTS, dtype=object), np.array(POINTS).astype(str),
                  np.ma.masked_array(POINTS, mask=True),
                  np.zeros((5, 2), dtype="m8[s]")):
            self.refuses(self.problem.points, (X,), "points.X")
        self.refuses(lambda out: self.pts(0.1, "b", out=out),
                     (np.ma.masked_array(np.zeros((5, 2)), mask=False), np.zeros((5, 2), dtype=complex),
                      np.broadcast_to(np.zeros(2), (5, 2)), np.zeros((5, 2), dtype=">f8")))
        self.refuses(lambda nodes: self.problem.mesh(SQUARE, nodes, "quadrilateral"),
                     (np.array([[0.0, 1, 2, 3]]), np.array([[0, 1, 2, 2**63]], dtype=np.uint64)), "mesh")

    def test_words_of_a_command(self):
        for call in (assay.check, assay.run, assay.tabulate):
            for word in ("--help", "-h", "--version", "-"):
                with self.assertRaises(assay.InputError, msg=word):
                    call(word)
            self.refuses(call, (7, None, "a\0b", ""))
        self.refuses(lambda points: assay.tabulate(SCENE, points=points), (7, "ab", [1.0], [(1.0, "a")], [(1.0, None)]))
        self.refuses(lambda value: assay.check("neo_hookean", quick=True, symbol=value), ("a\0b",))


if __name__ == "__main__":
    unittest.main()
