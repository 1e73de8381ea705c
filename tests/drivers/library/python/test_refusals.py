# SPDX-License-Identifier: BSD-3-Clause
"""What the Python package refuses, and what it then says.

usage: test_refusals.py SOURCE_DIR [--without-numpy] [UNITTEST ARGUMENTS]; PYTHONPATH names the package
"""
import math
import os
import subprocess
import sys
import tempfile
import unittest
from array import array
from pathlib import Path

from support import POINTS, SCENE, SOURCE, listed

import assay

WRONG = """motion: {type: vortex,
  inner: wide}
material: {adapter: neo_hookean, parameters: {E: 1, nu: .3}, density: 1}
"""


class Refusals(unittest.TestCase):
    """Each kind of error has its class, and says where it is."""

    def test_a_name_that_is_no_field_of_points(self):
        points = assay.Problem(SCENE).points(POINTS)
        for name in ("X", "bb"):
            with self.assertRaises(assay.InputError) as caught:
                points(0.1, name)
            self.assertIn("is no field", str(caught.exception))

    def test_a_scene(self):
        with self.assertRaises(assay.InputError) as caught:
            assay.Problem(text=WRONG)
        error = caught.exception
        self.assertEqual((error.code, error.line), (2, 2))
        self.assertIn("inner", error.key)
        self.assertIsInstance(error, ValueError)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bad.yaml")
            Path(path).write_text(WRONG)
            for ask in (assay.Problem, assay.run):
                with self.assertRaises(assay.InputError) as caught:
                    ask(path)
                error = caught.exception
                self.assertTrue(error.file.endswith("bad.yaml"), error.file)
                self.assertEqual(error.line, 2)
                self.assertGreater(error.column, 1)
                self.assertIn("bad.yaml:2:", str(error))

    def test_a_scene_that_is_not_there(self):
        for arguments in ({"scene": "nowhere.yaml"}, {}, {"scene": SCENE, "text": "a"},
                          {"scene": SCENE, "sets": ["x"]}):
            with self.assertRaises(assay.InputError):
                assay.Problem(**arguments)
        with self.assertRaisesRegex(assay.InputError, "needs a list"):
            assay.Problem(SCENE, sets="grid.spacing=1")

    def test_arguments_are_called_as_in_python(self):
        with self.assertRaises(assay.InputError) as caught:
            assay.Problem(SCENE, sets={"motion.inner": "wide"})
        self.assertEqual(caught.exception.file, "sets")
        self.assertTrue(str(caught.exception).startswith("sets"), caught.exception)
        with self.assertRaises(assay.InputError) as caught:
            assay.Problem(SCENE, end=math.inf)
        self.assertEqual(caught.exception.key, "end")
        self.assertTrue(str(caught.exception).startswith("end:"), caught.exception)

    def test_points(self):
        problem = assay.Problem(SCENE)
        for X in ([[1.0]], [[1.0, 2.0, 3.0, 4.0]], [["a", "b"]], [[1.0, 2.0], [3.0]], 5, "ab", [1.0, 2.0, 3.0]):
            with self.assertRaises(assay.InputError, msg=repr(X)):
                problem.points(X)
        with self.assertRaises(assay.InputError) as caught:
            problem.points([[1.0, 0.0], [math.nan, 0.0]])
        self.assertEqual(caught.exception.point, 1)

    def test_calls(self):
        pts = assay.Problem(SCENE).points(POINTS)
        with self.assertRaises(assay.BeyondEnd):
            assay.Problem(str(SOURCE / "configs/models/vortex_j2_jaumann.yaml"),
                          sets=["force.tolerance=1e-3"], end=0.01).points(POINTS)(0.9, "b")
        for call in (lambda: pts(0.1), lambda: pts(0.1, "c"), lambda: pts(0.1, "b", first=6),
                     lambda: pts(math.nan, "b"), lambda: pts(0.1, "b", count=6),
                     lambda: pts(0.1, "x", "b", out=array("d", [0.0] * 10))):
            with self.assertRaises(assay.InputError):
                call()

    def test_outside(self):
        ring = assay.Problem(str(SOURCE / "configs/motions/twisting_ring.yaml"))
        pts = ring.points([[1.0, 0.0], [5.0, 0.0]])
        with self.assertRaises(assay.OutsideError) as caught:
            pts(0.1, "b")
        self.assertEqual((caught.exception.code, caught.exception.point), (5, 1))
        b, status = pts(0.1, "b", "status")
        self.assertEqual(listed(status), [0, 5])
        self.assertTrue(math.isnan(listed(b)[1][0]))
        self.assertEqual(listed(b)[0], listed(ring.points([[1.0, 0.0]])(0.1, "b"))[0])

    def test_a_library_of_another_version(self):
        code = "import assay; assay.Problem('x')"
        for library, words in {os.environ.get("ASSAY_OLD_LIBRARY", ""): ("0.0.9", assay.__version__, "older"),
                               "/nowhere/libassay.so.1": ("/nowhere/libassay.so.1", "ASSAY_LIBRARY"),
                               "libm.so.6": ("libm.so.6", "assay_version")}.items():
            if library:
                done = subprocess.run([sys.executable, "-c", code], env={**os.environ, "ASSAY_LIBRARY": library},
                                      capture_output=True, text=True, check=False)
                self.assertIn("SystemFailure", done.stderr)
                for word in words:
                    self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
