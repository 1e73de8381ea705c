# SPDX-License-Identifier: BSD-3-Clause
"""Runs the standard set for the scoreboard: our own methods, and the codes of others that Debian has."""
import json
import os
import re
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
EDITION = 1
SCENES = os.path.join(HERE, "..", "..", "configs", "standard", str(EDITION))
ELASTIC = ["vortex_mild", "vortex_severe", "twisting_ring", "rotating_stretch", "homogeneous_traction", "axis_aligned"]

# folder: title, method of the scene. `assay standard` runs total_b2 and cpdi2 itself
OWN = {
    "assay_total_b3": ("total B3, AFLIP", "{basis: bspline3, formulation: total, transfer: aflip, mass: series, "
                                          "terms: 4, integrator: leapfrog, courant: 0.4}"),
    "assay_total_linear": ("total linear, FLIP", "{basis: linear, formulation: total, transfer: flip, mass: lumped, "
                                                 "courant: 0.4}"),
    "assay_cpdi_flip": ("CPDI, FLIP", "{basis: cpdi, formulation: updated, transfer: flip, update: usl, mass: lumped, "
                                      "courant: 0.4}"),
    "assay_cpdi_apic": ("CPDI, APIC", "{basis: cpdi, formulation: updated, transfer: apic, mass: lumped, "
                                      "courant: 0.4}"),
    "assay_ugimp_flip": ("uGIMP, FLIP", "{basis: ugimp, formulation: updated, transfer: flip, update: usl, "
                                        "mass: lumped, courant: 0.4}"),
}
# folder: target of export, problems (those that its driver can express), program for a grid or None for run.py of all
OTHERS = {
    "fenicsx_bilinear": ("fenics", ["vortex_mild", "vortex_severe", "vortex3d_small", "vortex3d"], None),
    "lammps_peri": ("lammps", ["vortex3d_small"], None),
    "calculix_static": ("abaqus", ["vortex_mild", "vortex_severe"], "calculix"),
}


def call(*words, cwd=None, good=(0,)):
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True)
    if done.returncode not in good:
        sys.exit(f"{' '.join(words)} ended with {done.returncode}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def grids():
    """Of each problem of the edition, in the order of the set."""
    with open(os.path.join(HERE, "..", "..", "drivers", "standard", f"edition_{EDITION}.yaml")) as file:
        found = re.findall(r"{id: (\w+), grids: \[(.*?)\]}", file.read())
    return {problem: [float(h) for h in text.split(",")] for problem, text in found}


def sets_in_space(problem):
    """What a run of the problem sets besides its method: its scene has neither method nor output."""
    if not problem.startswith("vortex3d"):
        return []
    with open(os.path.join(HERE, "..", "..", "drivers", "standard", f"edition_{EDITION}.yaml")) as file:
        block = file.read().split("\nin_space:", 1)[1]
    return re.findall(r"^  ((?:force|output)\S+): (\S+)$", block, re.M)


def processor():
    with open("/proc/cpuinfo") as file:
        for line in file:
            if line.startswith("model name"):
                return f"{line.split(':', 1)[1].strip()}, {os.cpu_count()} cores"
    return os.uname().machine


def write_cost(path, seconds):
    with open(path, "w") as cost:
        cost.write(f"seconds: {seconds:.6g}\ncores: 1\nmachine: '{processor()}'\n")


def own(assay, folder, problems):
    """Runs the methods of OWN; the folder of each is for `assay standard judge`. Yields name, title, command."""
    for name, (title, method) in OWN.items():
        for problem in problems:
            for h in grids()[problem]:
                out = os.path.join(folder, name, problem, f"h_{h:g}")
                # a run that becomes unstable leaves what it has, and judge says that it ends early
                call(assay, "run", os.path.join(SCENES, problem + ".yaml"), "-o", out, "--quiet", "--threads", "1",
                     "--set", f"grid.spacing={h:g}", "--set", "expect={}", "--set", f"method={method}",
                     *(word for key, value in sets_in_space(problem) for word in ("--set", f"{key}={value}")),
                     good=(0, 1, 2, 3, 4))
                result = os.path.join(out, "result.json")
                if os.path.exists(result):
                    with open(result) as file:
                        seconds = json.load(file).get("step_cpu_s", 0)
                    if seconds > 0:
                        write_cost(os.path.join(out, "cost.yaml"), seconds)
        with open(os.path.join(folder, name, "judge.map.yaml"), "w") as file:
            file.write(f"code: 'assay, {title}'\n")
        yield name, title, f"assay run PROBLEM.yaml --set 'method={method}'"


def missing(name):
    """What a code of OTHERS lacks here, or nothing."""
    module = {"fenicsx_bilinear": "dolfinx", "lammps_peri": "lammps"}.get(name)
    if module is None:
        return "" if shutil.which("ccx") else "ccx"
    try:
        __import__(module)
        return ""
    except (ImportError, OSError):
        return module


def version_of(name):
    package = {"fenicsx_bilinear": "python3-dolfinx", "lammps_peri": "python3-lammps",
               "calculix_static": "calculix-ccx"}
    return "Debian " + call("dpkg-query", "-W", "-f", "${Version}", package[name]).strip()


def child_seconds():
    return os.times().children_user


def others(assay, folder, name):
    """Exports to a code of OTHERS and runs it."""
    target, problems, deck = OTHERS[name]
    out = os.path.join(folder, name)
    call(assay, "standard", "export", "--to", target, "--only", ",".join(problems), "-o", out)
    for problem in problems:
        there = os.path.join(out, problem)
        if deck is None:
            call(sys.executable, "run.py", cwd=there)
        for grid in (f"h_{h:g}" for h in grids()[problem]):
            cost = os.path.join(there, grid, "out.cost.yaml")
            if deck is not None:
                begin = child_seconds()
                call("ccx", deck, cwd=os.path.join(there, grid))
                seconds = child_seconds() - begin
                call(sys.executable, "../dat_to_csv.py", cwd=os.path.join(there, grid))
            else:  # the driver has measured it
                with open(cost) as file:
                    seconds = float(re.search(r"^seconds: (\S+)", file.read(), re.M)[1])
            write_cost(cost, seconds)
