# SPDX-License-Identifier: BSD-3-Clause
"""Mistakes that were planted without a look at the dictionary of judge, in three codes; what judge says of them.

usage: blind.py [--second] ASSAY FOLDER [CASE or MOTION...]; the environment variable PLANTED_MPM names the program of
planted_mpm.cpp, and PYTHONPATH has the package assay. --second: the cases of the folder second. Exit 1 if a right code
is accused, a name is wrong, or fewer than 90 % of the separable mistakes are found; 77 if a package is not there.
"""
import json
import math
import os
import subprocess
import sys
import time

try:
    import dolfinx  # noqa: F401
    import numpy  # noqa: F401
    import yaml  # noqa: F401
    import assay  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing.name} is not there")
    sys.exit(77)
HERE = os.path.dirname(os.path.abspath(__file__))
if "--second" in sys.argv:
    sys.argv.remove("--second")
    sys.path.insert(0, os.path.join(HERE, "second"))
from cases import CASES
from codes import RING, text_of
from scenes import ELASTIC, LINE, MOTIONS, path_text

LEAST_FOUND = 0.9


def call(*words, cwd, good=(0,)):
    done = subprocess.run(words, cwd=cwd, capture_output=True, text=True)
    if done.returncode not in good:
        said = done.stdout[-2000:] + done.stderr[-2000:]
        raise RuntimeError(f"{' '.join(words)} ended with {done.returncode}\n{said}")


def edited(text, edits):
    for old, new in edits:
        if text.count(old) != 1:
            raise RuntimeError(f"the code has {text.count(old)} times: {old}")
        text = text.replace(old, new)
    return text


def write(folder, name, text):
    with open(os.path.join(folder, name), "w") as file:
        file.write(text)


def read(name):
    with open(name) as file:
        return file.read()


def ran(program, code, scene, cells, change, folder):
    """Runs the case on two grids: names of its outputs, their spacings, and more words for judge."""
    kind, low, high = MOTIONS[scene.split("_")[0]][1]
    grids = [(high - low) / n for n in (cells, 2 * cells)]
    outputs = []
    if code == "fenics":
        call(program, "export", "scene.yaml", "--to", "fenics", "--grids", ",".join(map(repr, grids)), "-o", "run",
             cwd=folder)
        run = os.path.join(folder, "run")
        write(run, "run.py", edited(read(os.path.join(run, "run.py")), change))
        call(sys.executable, "run.py", cwd=run)
        names = sorted((each for each in os.listdir(run) if each.startswith("h_")), key=lambda each: -float(each[2:]))
        return [f"run/{each}/out.npz" for each in names], grids, ["--map", "run/judge.map.yaml"]
    for n, h in zip((cells, 2 * cells), grids):
        out = f"out_{n}." + ("csv" if code == "mpm" else "npz")
        if code == "mpm":
            mistake, size, method = change
            call(os.environ["PLANTED_MPM"], "scene.yaml", out, mistake, repr(size), f"grid.spacing={h!r}",
                 f"method={method}", *(RING if kind == "ring" else []), cwd=folder)
        else:
            source = {"quads": "quads.py", "box": "fenicsx_box.py"}[code]
            write(folder, source, edited(read(os.path.join(HERE, source)), change))
            body = [f"{kind}:{low}:{high}"] if code == "quads" else [repr(low), repr(high)]
            call(sys.executable, source, "scene.yaml", *body, str(n), out, cwd=folder)
        outputs.append(out)
    return outputs, grids, []


def judged(program, code, scene, cells, change, folder):
    os.makedirs(folder, exist_ok=True)
    write(folder, "scene.yaml", text_of(scene, MOTIONS, ELASTIC))
    write(folder, "path.csv", path_text())
    write(folder, "line.csv", LINE)
    outputs, grids, more = ran(program, code, scene, cells, change, folder)
    name = "run/scene.yaml" if more else "scene.yaml"
    call(program, "judge", name, *outputs, "--h", ",".join(map(repr, grids)), *more, "-o", "judged", cwd=folder,
         good=(0, 1))
    answer = json.loads(read(os.path.join(folder, "judged", "judge.json")))
    labels = {label["cause"] for run in answer["runs"] for label in run["labels"]} - {"ends_early"}
    return {**answer["mistakes_of_code"], "data": labels}


def named(found):
    """The mistakes that the sentence names."""
    return [each for each in found["mistakes"] if each["sentence"] in found["sentence"]]


def verdict(truth, separable, found):
    """Of a case: ok, or what judge did wrong. Of doubtful answers none is an accusation, and none a find."""
    names = {each["mistake"] for each in named(found)} if found["answer"] in ("named", "alike") else set()
    if found["data"]:
        return "WRONG DATA"  # all data are written as they should be
    if truth == {"none"}:
        return "ACCUSED" if names else "ok"
    if found["answer"] == "named" and not names <= truth:
        return "WRONG NAME"
    if found["answer"] == "alike" and not names & truth:
        return "WRONG NAME"
    if separable:
        return "ok" if names & truth else "MISSED"
    return "ok"


def main(program, folder, *only):
    program, seen = os.path.abspath(program), []
    unknown = set(only) - {case[0] for case in CASES} - set(MOTIONS)
    if unknown:
        sys.exit(f"no such case: {', '.join(sorted(unknown))}")
    chosen = [case for case in CASES if not only or case[0] in only or case[2].split("_")[0] in only]
    for name, code, scene, cells, change, truth, separable in chosen:
        began = time.perf_counter()
        try:
            found = judged(program, code, scene, cells, change, os.path.join(folder, name))
        except RuntimeError as failure:
            found = {"answer": "FAILED", "sentence": str(failure), "mistakes": [], "data": set()}
        how = "FAILED" if found["answer"] == "FAILED" else verdict(truth, separable, found)
        first = (named(found) or found["mistakes"] or [{}])[0]
        size = f"size {first['size']:.4g}, explained {first['explained']:.3f}" if first else "no size"
        print(f"{name} {how:10s} {code:6s} {scene:12s} truth {'/'.join(sorted(truth))}"
              f"{' (separable)' if separable else ''}: {found['answer']}: {found['sentence'] or '-'}; {size};"
              f"{' data: ' + ', '.join(sorted(found['data'])) + ';' if found['data'] else ''}"
              f" {time.perf_counter() - began:.1f} s", flush=True)
        seen.append((how, truth, separable))
    hows = [how for how, _, _ in seen]
    wanted = [how for how, _, separable in seen if separable]
    missed = len(wanted) - wanted.count("ok")
    allowed = math.floor((1 - LEAST_FOUND) * len(wanted) + 1e-9)
    accused, failed = hows.count("ACCUSED"), hows.count("FAILED")
    wrong = hows.count("WRONG NAME") + hows.count("WRONG DATA")
    print(f"{len(seen)} cases; right codes accused: {accused} of {sum(t == {'none'} for _, t, _ in seen)}; wrong names:"
          f" {wrong}; not run: {failed}; separable ones found: {wanted.count('ok')} of {len(wanted)}")
    return 1 if accused or wrong or failed or missed > allowed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
