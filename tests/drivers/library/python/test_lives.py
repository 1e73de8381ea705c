# SPDX-License-Identifier: BSD-3-Clause
"""Handles of the Python package, threads, and what a call costs.

usage: test_lives.py SOURCE_DIR [--without-numpy] [UNITTEST ARGUMENTS]; PYTHONPATH names the package
"""
import copy
import ctypes
import gc
import os
import pickle
import random
import resource
import sys
import threading
import time
import unittest
import weakref
from pathlib import Path

from support import POINTS, SCENE, listed, needs_numpy, np

import assay
from assay import _library

CALLS_OVERHEAD = 60e-6  # s: 5 % of what 20,000 points cost at 60 ns each


def resource_children():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


class Lives(unittest.TestCase):
    """Handles are closed once, and no process is started."""

    def test_closing(self):
        with assay.Problem(SCENE) as problem:
            pts = problem.points(POINTS)
        with self.assertRaisesRegex(assay.InputError, "closed"):
            problem.points(POINTS)
        before = listed(pts(0.3, "b"))  # they keep their problem
        problem.close()
        self.assertEqual(listed(pts(0.3, "b")), before)
        pts.close()
        with self.assertRaises(assay.InputError):
            pts(0.3, "b")

    def test_the_last_reference(self):
        problem = assay.Problem(SCENE)
        pts = problem.points(POINTS)
        gone = weakref.ref(problem)
        del problem
        gc.collect()
        self.assertIsNone(gone())
        self.assertEqual(len(pts(0.3, "b")), 5)

    def test_no_process(self):
        children = Path(f"/proc/self/task/{os.getpid()}/children")
        if not children.exists():
            self.skipTest("no /proc")
        before = resource_children()
        pts = assay.Problem(SCENE).points(POINTS)
        self.assertEqual(children.read_text(), "")
        pts(0.3, "b")
        self.assertEqual(children.read_text(), "")
        self.assertEqual(resource_children(), before)

    def test_threads(self):
        times = [random.Random(3).uniform(0, 1) for _ in range(64)]
        pts = assay.Problem(SCENE).points([[0.75 + 0.001 * k, 0.1] for k in range(500)])
        serial = [listed(pts(t, "b")) for t in times]
        found = [None] * 64

        def work(thread):
            for k in random.Random(thread).sample(range(thread, 64, 8), 8):
                found[k] = listed(pts(times[k], "b"))

        threads = [threading.Thread(target=work, args=(k,)) for k in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, serial)

    def test_closing_while_a_thread_is_in_a_call(self):
        problem = assay.Problem(SCENE)
        for _ in range(20):
            pts = problem.points([[0.75 + 0.00002 * k, 0.1] for k in range(20000)])
            begun, ends = threading.Barrier(5), []

            def ask():
                begun.wait()
                try:
                    while True:
                        pts(0.3, "b")
                except assay.InputError as error:
                    ends.append(str(error))

            threads = [threading.Thread(target=ask) for _ in range(4)]
            for thread in threads:
                thread.start()
            begun.wait()
            time.sleep(0.005)
            pts.close()
            for thread in threads:
                thread.join()
            self.assertEqual(ends, ["Points: is closed"] * 4)

    def test_there_is_no_copy(self):
        problem = assay.Problem(SCENE)
        for handle in (problem, problem.points(POINTS)):
            for make in (copy.copy, copy.deepcopy, pickle.dumps):
                with self.assertRaisesRegex(assay.InputError, "has no copy"):
                    make(handle)

    def test_what_they_are_is_shown(self):
        with assay.Problem(SCENE) as problem:
            pts = problem.points(POINTS)
            self.assertEqual(repr(problem), "<assay.Problem: 2 dimensions, end 1 s>")
            self.assertEqual(repr(pts), "<assay.Points: 5 points in 2 dimensions>")
        self.assertIn("closed", repr(problem))
        self.assertNotIn("closed", repr(pts))

    @needs_numpy
    def test_a_call_costs_little(self):
        calls = 20  # of few points: what Python adds does not depend on their number
        X = np.random.default_rng(1).uniform(-1.3, 1.3, (20, 2))
        pts, out = assay.Problem(SCENE).points(X), np.empty((20, 2))
        view = _library.View(ctypes.sizeof(_library.View))
        view.b = _library.Field(out.ctypes.data, 2, 1)
        error = _library.ErrorStruct(ctypes.sizeof(_library.ErrorStruct))
        times = [[], []]
        for _ in range(50):  # processor time: others may want the processor, too
            began = time.thread_time()
            for _ in range(calls):
                pts._eval(pts._opened, 0.3, 0, 20, view, error)
            middle = time.thread_time()
            for _ in range(calls):
                pts(0.3, "b", out=out)
            times[0].append((middle - began) / calls)
            times[1].append((time.thread_time() - middle) / calls)
        bare, called = map(min, times)
        print(f"a call: {1e6 * bare:.1f} us in C, {1e6 * called:.1f} us from Python", file=sys.stderr)
        self.assertLess(called - bare, CALLS_OVERHEAD)


if __name__ == "__main__":
    unittest.main()
