# SPDX-License-Identifier: BSD-3-Clause
"""The scoreboard of the standard set: figures of codes and methods, stored in the folder scoreboard beside this file.

usage: scoreboard.py --page PAGE: writes PAGE (docs/scoreboard.md) from the stored figures alone
       scoreboard.py --check PAGE: exit 1 if PAGE is another
       scoreboard.py --store JUDGED --name FOLDER --code NAME --method TEXT --note TEXT --version TEXT --command TEXT:
           takes the judge.json of all problems in JUDGED, which `assay standard judge` has written for one method
       scoreboard.py --run ASSAY FOLDER: runs in FOLDER what can be run here, and stores its figures. Exit 77 if a code
           is not there; the others are run all the same
"""
import argparse
import hashlib
import json
import os
import re
import sys

import scoreboard_runs as runs

STORE = os.path.join(runs.HERE, "scoreboard")
JUDGED = ["title", "verdict", "good", "order", "last_order", "expect", "warnings", "mistakes_of_code"]
ROUNDING = 1e-10  # of the displacement: below it an order means nothing


def stored_run(run):
    error = run.get("error") or {}
    return {"h": run["h"], "particles": run["particles"], "frames": run["frames"],
            "l2_max": error.get("l2_max"), "relative": error.get("relative"),
            "causes": [label.get("cause", "") if isinstance(label, dict) else label for label in run.get("labels", [])],
            "seconds": run.get("seconds"), "cores": run.get("cores")}


def hash_of(problem):
    """Of the scene of the set: an export writes all values into it, and its hash is another."""
    with open(os.path.join(runs.SCENES, problem + ".yaml"), "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def store(judged, about):
    """A file for each problem: what judge found without its histories, and who ran what where. Problems that were not
    judged now keep theirs."""
    folder = os.path.join(STORE, about["name"])
    os.makedirs(folder, exist_ok=True)
    for problem in runs.grids():
        path = os.path.join(judged, problem, "judge.json")
        if not os.path.exists(path):
            continue
        with open(path) as file:
            found = json.load(file)
        mistakes = found.get("mistakes_of_code") or {}
        found["mistakes_of_code"] = {"answer": mistakes.get("answer"), "sentence": mistakes.get("sentence")}
        made = found["provenance"]
        found["warnings"] = [re.sub(r"^\S*/(?=h_)", "", each) for each in found.get("warnings", [])]
        machines = {run.get("machine") for run in found["runs"]} - {None, ""}
        kept = {"problem": problem, "edition": runs.EDITION, "code": about["code"], "method": about["method"],
                "version": about["version"], "command": about["command"].replace("PROBLEM", problem),
                "note": about.get("note", ""), "machine": ", ".join(sorted(machines)),
                "problem_sha256": hash_of(problem), "scene_sha256": made["scene_sha256"],
                "assay": {"version": made["version"], "git": made["git"]},
                **{key: found.get(key) for key in JUDGED}, "runs": [stored_run(run) for run in found["runs"]]}
        with open(os.path.join(folder, problem + ".json"), "w") as file:
            file.write(json.dumps(kept, indent=1) + "\n")


def stored():
    """All files, by problem."""
    found = {problem: [] for problem in runs.grids()}
    for name in sorted(os.listdir(STORE)):
        for file_name in sorted(os.listdir(os.path.join(STORE, name))):
            with open(os.path.join(STORE, name, file_name)) as file:
                one = json.load(file)
            if one["edition"] == runs.EDITION:
                found[one["problem"]].append({**one, "name": name})
    return found


def figure(value, digits=2):
    if value is None:
        return "-"
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.{digits}g}"


def percent(value):
    if value is None:
        return "-"
    return "rounding" if value < ROUNDING else figure(100 * value) + " %"


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def cells_of(one):
    """method, finest grid, order, error, core s, verdict, scene"""
    last = one["runs"][-1]
    exact = last["relative"] is not None and last["relative"] < ROUNDING
    seconds = None if last["seconds"] is None else last["seconds"] * (last["cores"] or 1)
    order = "-" if exact or one["last_order"] is None else f"{one['last_order']:.2f}"
    whole = [run["h"] for run in one["runs"]] == runs.grids()[one["problem"]]
    verdict = ("good" if whole else "coarse") if one["good"] else "fails"
    return [f"`{one['name']}`", f"{last['h']:g}", order, percent(last["relative"]), figure(seconds), verdict,
            f"`{one['problem_sha256'][:8]}`"]


def mistake_of(one):
    """The sentence of judge about a mistake of the code, or nothing."""
    found = one["mistakes_of_code"]
    return "" if found["answer"] in (None, "none", "method", "not_asked") else found["sentence"]


def wrapped(text, width=118, indent="  "):
    lines, now = [], ""
    for word in text.split():
        if now and len(now) + 1 + len(word) > width:
            lines.append(now)
            now = indent + word
        else:
            now += (" " if now else "") + word
    return "\n".join(lines + [now]) + "\n"


def by_error(one):
    error = one["runs"][-1]["relative"]
    return (one["runs"][-1]["h"], error is None, error or 0)


INTRO = f"""# Scoreboard of the standard set, edition {runs.EDITION}

What codes and methods reach in the [standard set](standard.md), judged from the positions that they wrote. The figures
are those of the files in `tests/foreign/scoreboard`. Codes that cannot be installed everywhere stay there with the
version that was run. To add yours, [see below](#add-a-code).

- h is the finest grid that was run, in metres. The order is that between the two finest.
- The error is the largest L2 error of the displacement over time, as a share of the largest displacement.
- The cost in core s is that of the finest grid. Compare costs of one machine alone.
- `coarse` is the verdict if what was run is good, but the finest grid of the problem is missing.
- The scene is the beginning of the hash of its file in the set.
"""

DRIVEN = r"""
## Karamelo and NairnMPM

Both take the force as an expression. The decks come from `export`, and the results go back to `judge`:

```sh skip
assay standard export --to karamelo -o karamelo
cd karamelo/vortex_mild/h_0.05 && karamelo -i input.mpm
assay standard judge karamelo -o judged
```

The exported expressions are pieces of Chebyshev's polynomials, as for any material. For neo-Hookean elasticity the
force of this vortex has a closed form, which both codes evaluate about six times faster. The figures above are with it.
At 300 random points the two forms differ by less than 5e-6 m/s². With $R$ the reference radius, $A$ the peak of the
amplitude, $c = \mu/\rho_0$, $s = 4R - 4$, $q = 1 - s^2$, $S = \sin \pi t$ and $C = \cos \pi t$, between $R = 3/4$ and
$5/4$:

$$ b_r = R q^6 \left(1024\, c A^2 (1-q) S^2 - A^2 \pi^2 q^2 C^2\right), $$
$$ b_\theta = A S q^2 \left(96\, c s q - R (\pi^2 q^2 + 768\, c - 896\, c q)\right), $$

in m/s², along the radius and the angle of the current position.

Mistakes that stand in public copies of this force were planted in the same decks (`vortex_mild`, Karamelo total
Lagrangian with linear functions, NairnMPM with `lCPDI`). Judge named them from two grids, and from three with the last
two of NairnMPM:

| mistake | Karamelo | NairnMPM |
| --- | --- | --- |
| wrong sign of the inertia term | `inertia_term`, explains 99.9 % | `inertia_term`, 94.9 % |
| wrong sign of the stress term | `stress_term`, 98.2 % | `stress_term`, 98.6 %, "the code takes b at current positions" |
| rotated twice | `force_rotation`, 98.3 % | `force_place`, 98.7 %: from current positions the two are one |

No mistake was found in the codes themselves. uGIMP, `B2GIMP`, `B2SPLINE` and Karamelo's cubic functions fail by the
error of the method on these grids, or by order.

There is no particle code in Python or Julia among the packages of Debian or npm. None was run.
"""

ADD = """
## Add a code

Export the problems, run them, judge them, and store the figures:

```sh skip
assay standard export --to csv -o my_code
assay standard judge my_code -o judged
python3 tests/foreign/scoreboard.py --store judged/my_code --name my_code --code 'My code' --method 'FLIP' \\
  --version 1.2 --command 'my_code PROBLEM.in'
python3 tests/foreign/scoreboard.py --page docs/scoreboard.md
```
"""


def page():
    text, methods = INTRO, {}
    for problem, found in stored().items():
        if not found:
            continue
        bounds = ", ".join(f"{each['key']} {each['expected']}" for each in found[0]["expect"] or [])
        text += f"\n## {problem}\n\n{found[0]['title']}." + (f" Asked for: {bounds}." if bounds else "") + "\n\n"
        text += line(["method", "h", "order", "error", "core s", "verdict", "scene"]) + line(["---"] * 7)
        remarks = ""
        for one in sorted(found, key=by_error):
            methods.setdefault(one["name"], one)
            text += line(cells_of(one))
            if not one["good"]:
                remarks += wrapped(f"- `{one['name']}`: {one['verdict']}")
            if mistake_of(one):
                remarks += wrapped(f"- `{one['name']}`: {mistake_of(one)}")
        text += "\n" + remarks if remarks else ""
    text += "\n## Methods\n\nThe commands run one problem on one grid, or on all.\n\n"
    for name, one in sorted(methods.items()):
        note = f" {one['note']}" if one["note"] else ""
        text += wrapped(f"- `{name}`: {one['code']}, {one['method']}.{note} Version {one['version']}, on "
                        f"{one['machine'] or 'an unknown machine'}, judged by assay {one['assay']['version']} "
                        f"({one['assay']['git'][:8]}): `{one['command'].replace(one['problem'], 'PROBLEM')}`")
    return text + DRIVEN + ADD


def run_all(assay, folder):
    assay = os.path.abspath(assay)
    os.makedirs(folder, exist_ok=True)
    version = runs.call(assay, "--version").splitlines()[0].removeprefix("assay ")
    about = {}
    runs.call(assay, "standard", "-o", os.path.join(folder, "own"), good=(0, 1))
    for name, method in (("total_b2", "total B2, AFLIP"), ("cpdi2", "CPDI2, AFLIP")):
        about[os.path.join(folder, "own", name)] = {"name": "assay_" + name, "code": "assay", "method": method,
                                                    "version": version, "command": "assay standard --only PROBLEM"}
    for name, method, command in runs.own(assay, folder, [*runs.ELASTIC, "vortex3d"]):
        about[os.path.join(folder, name)] = {"name": name, "code": "assay", "method": method, "version": version,
                                             "command": command}
    others = {"fenicsx_bilinear": ("FEniCSx", "bilinear elements, lumped mass, central differences", "python3 run.py"),
              "lammps_peri": ("LAMMPS", "peridynamics, peri/lps", "python3 run.py"),
              "calculix_static": ("CalculiX", "plane elements, without inertia, Newton's method", "ccx calculix")}
    status = 0
    for name, (code, method, command) in others.items():
        lack = runs.missing(name)
        if lack:
            print(f"skipped {name}: {lack} is not there")
            status = 77
            continue
        runs.others(assay, folder, name)
        about[os.path.join(folder, name)] = {"name": name, "code": code, "method": method,
                                             "version": runs.version_of(name), "command": command}
    for results, one in about.items():
        judged = os.path.join(folder, "judged", os.path.basename(results))
        runs.call(assay, "standard", "judge", results, "-o", os.path.dirname(judged), good=(0, 1))
        store(judged, one)
    return status


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--page")
    words.add_argument("--check")
    words.add_argument("--store")
    words.add_argument("--run", nargs=2, metavar=("ASSAY", "FOLDER"))
    for name in ("name", "code", "method", "note", "version", "command"):
        words.add_argument("--" + name, default="")
    given = words.parse_args()
    status = 0
    if given.run:
        status = run_all(*given.run)
    if given.store:
        if not given.name:
            words.error("--store needs --name")
        store(given.store, vars(given))
    if given.page:
        text = page()
        with open(given.page, "w") as file:
            file.write(text)
    if given.check:
        with open(given.check) as file:
            if file.read() != page():
                print(f"{given.check} is not what the stored figures make: scoreboard.py --page {given.check}")
                return 1
    return status


if __name__ == "__main__":
    sys.exit(main())
