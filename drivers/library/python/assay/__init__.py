# SPDX-License-Identifier: BSD-3-Clause
"""The exact motion, stress and body force of an assay scene, at your own points.

    import assay

    problem = assay.Problem("vortex.yaml", sets=["motion.amplitude.peak=0.25"])
    points = problem.points(X)              # X: reference positions [m], shape (n, 2) or (n, 3)
    x, v = points(0.0, "x", "v")            # at t = 0: positions [m], velocities [m/s]
    points(0.5, "b", out=force)             # body force per mass [m/s^2], written into an array of yours

Problem, its points, cells and meshes are answered by the library libassay in this process: no program is started.
run, tabulate and check start the program `assay` and return what it found. SI units throughout.

numpy is optional. Any float64 array with the buffer protocol is read and written in place, whatever its strides; lists
are read, too. Without numpy results are nested lists.

Calls may come from any number of threads at once, with times in any order: they run at the same time.
"""
from ._errors import BeyondEnd, Error, InputError, MaterialFailure, OutsideError, SystemFailure
from ._library import __version__, library_version
from ._problem import Cells, Mesh, Points, Problem
from ._program import Result, check, run, tabulate

__all__ = ["BeyondEnd", "Cells", "Error", "InputError", "MaterialFailure", "Mesh", "OutsideError", "Points", "Problem",
           "Result", "SystemFailure", "__version__", "check", "library_version", "run", "tabulate"]
