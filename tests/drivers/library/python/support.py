# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python package share. Imported first: it hides numpy where a test is asked to do without."""
import sys
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(1))
if "--without-numpy" in sys.argv:
    sys.argv.remove("--without-numpy")
    sys.modules["numpy"] = None  # an import of it now fails
try:
    import numpy as np
except ImportError:
    np = None

SCENE = str(SOURCE / "configs/library/plane_vortex.yaml")
SPATIAL = str(SOURCE / "configs/motions/vortex3d.yaml")
POINTS = [[1.0, 0.0], [0.9, 0.1], [-0.3, 0.8], [0.6, -0.9], [1.4, 0.2]]
needs_numpy = unittest.skipIf(np is None, "numpy is hidden")


def listed(values):
    return values.tolist() if hasattr(values, "tolist") else [listed(v) if isinstance(v, (list, tuple)) else v
                                                              for v in values]


def flat(values):
    return [number for row in listed(values) for number in (flat(row) if isinstance(row, list) else [row])]
