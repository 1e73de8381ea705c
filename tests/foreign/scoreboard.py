# SPDX-License-Identifier: BSD-3-Clause
"""The scoreboard of the standard set: our own methods, FEniCSx and LAMMPS run it, and judge reads what they leave.

usage: scoreboard.py ASSAY FOLDER PAGE: runs everything in FOLDER and writes PAGE (docs/scoreboard.md). Exit 77 if a code
is not there.
"""
import os
import subprocess
import sys

FENICS = ["vortex_mild", "vortex_severe", "vortex3d_small"]  # those whose energy its driver has, in reasonable time
LAMMPS = ["vortex3d_small"]


def call(*words, cwd=None, good=(0,)):
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True)
    if done.returncode not in good:
        sys.exit(f"{' '.join(words)} ended with {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")


def machine_of(own):
    """The line of the first cost.yaml of our own runs that names the machine."""
    for path, _, files in os.walk(own):
        if "cost.yaml" in files:
            with open(os.path.join(path, "cost.yaml")) as cost:
                return [line for line in cost if line.startswith("machine:")][0]
    sys.exit(f"no run in {own} has finished")


def name_machine(problem, line):
    for grid in os.listdir(problem):
        cost = os.path.join(problem, grid, "out.cost.yaml")
        if os.path.exists(cost):
            with open(cost) as before:
                rest = [each for each in before if not each.startswith("machine:")]
            with open(cost, "w") as after:
                after.writelines(rest + [line])


def main(assay, folder, page):
    assay = os.path.abspath(assay)
    os.makedirs(folder, exist_ok=True)
    call(assay, "standard", "-o", "own", cwd=folder, good=(0, 1))
    for target, problems, module in (("fenics", FENICS, "dolfinx"), ("lammps", LAMMPS, "lammps")):
        try:
            __import__(module)
        except ImportError:
            print(f"skipped: {module} is not there")
            sys.exit(77)
        call(assay, "standard", "export", "--to", target, "--only", ",".join(problems), "-o", target, cwd=folder)
        for problem in problems:
            call(sys.executable, "run.py", cwd=os.path.join(folder, target, problem))
            name_machine(os.path.join(folder, target, problem), machine_of(os.path.join(folder, "own")))
    call(assay, "standard", "judge", "own/total_b2", "own/cpdi2", "fenics", "lammps", "-o", "card", "--markdown",
         os.path.abspath(page), cwd=folder, good=(0, 1))


if __name__ == "__main__":
    main(*sys.argv[1:])
