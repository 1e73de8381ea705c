# SPDX-License-Identifier: BSD-3-Clause
"""Verbs of the program through the Python package.

usage: test_program.py SOURCE_DIR [--without-numpy] [UNITTEST ARGUMENTS]; PYTHONPATH names the package
"""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import SCENE, SOURCE, listed

import assay
from assay import _program


class Verbs(unittest.TestCase):
    """The program's verbs return plain objects."""

    def test_run(self):
        with tempfile.TemporaryDirectory() as folder:
            kept = os.path.join(folder, "result")
            result = assay.run(str(SOURCE / "configs/paper/vortex_cpdi.yaml"), folder=kept,
                               sets={"grid.spacing": 0.125, "expect": {}, "output.errors": 4, "output.particles": 0})
            self.assertTrue(os.path.exists(os.path.join(kept, "report.html")))
        self.assertEqual((result.status, result.outcome, result["t"]), (0, "completed", 1.0))
        self.assertEqual(max(result.tables.errors["l2"]), result.error.l2_max)
        with self.assertRaises(AttributeError):
            result.nothing

    def test_run_that_finds(self):
        result = assay.run(str(SOURCE / "configs/paper/vortex_cpdi.yaml"), sets={
            "grid.spacing": 0.125, "expect": {"error.l2_max": {"below": 1e-9}}, "output.errors": 2,
            "output.particles": 0})
        self.assertEqual(result.status, 1)

    def test_tabulate(self):
        result = assay.tabulate(SCENE, points=[(0.5, 0.25), (1.0, 0.5)])
        self.assertEqual(listed(result.tables.points["xi"]), [0.5, 1.0])
        self.assertGreater(len(result.tables.sheet["tau12"]), 2)
        problem = assay.Problem(text=Path(SCENE).read_text())
        self.assertEqual(listed(problem.tabulate().tables.sheet["tau12"]), listed(result.tables.sheet["tau12"]))

    def test_check(self):
        result = assay.check("neo_hookean", quick=True, parameters={"E": 1e3, "nu": 0.3})
        self.assertEqual((result.status, result.verdict), (0, "pass"))
        self.assertEqual({test.verdict for test in result.tests} - {"pass", "n/a"}, set())
        with self.assertRaises(assay.InputError):
            assay.check("no_such_material")

    def test_version(self):
        said = subprocess.run([_program._program(), "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said.split()[1], assay.__version__)
        self.assertEqual(assay.library_version(), assay.__version__)


if __name__ == "__main__":
    unittest.main()
