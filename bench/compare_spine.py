#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is not called for costs nothing: the full program against one with the spine's effects only.

usage: compare_spine.py FULL SPINE        two programs `assay`, of ASSAY_EFFECTS=full and of spine

Both run the same small scene on one thread under callgrind. Passes where their instructions, of the steps alone and of
the whole process, differ by at most 1 %. Controls that must fail so: the same comparison with the full program running
the scene with one effect more. Besides: the spine program has no function of an effect that it leaves out, the full one
has them all, and the spine program refuses a scene that calls for one. Exit status 0, or 1.
"""
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCENE = ROOT / "configs/paper/vortex_cpdi.yaml"
PLAIN = ["expect={}", "output={errors: 1, particles: 0, pictures: false, report: false, accounts: false}",
         "grid.spacing=0.0625", "time.end=0.1", "force={response: closed_form, evaluation: point}"]
MOST = 0.01  # of the spine's instructions: what is allowed
MORE = ["output.accounts=true", "method.transfer=apic", "force.evaluation=domain_average", "method.update=musl"]
STEP = "assay::mpm::Simulation<2>::step(double, double)"
# of effects that the spine build leaves out; each is a function of the full one
LEFT_OUT = [r"::affine_pass<2>", r"::traction_pass\(", r"::virtual_stress_pass\(", r"::inertia_pass<2>",
            r"::fold_images_pass<2>", r"::mass_matrix_pass<2>", r"::kick_pass<2>", r"::accounts_pass<2>",
            r"::hold_nodes_pass<2>", r"::moving_frame_pass<2>", r"Cpdi2Basis<2>",
            r"StressOffload::StressOffload\(", r"Snapshots::write_vtu", r"drivers::report_html",
            r"drivers::traction_table"]


def settings(more=()):
    return [word for text in [*PLAIN, *more] for word in ("--set", text)]


def instructions(program, more):
    """Executed in a run of the scene: in all its steps, and in the whole process."""
    with tempfile.TemporaryDirectory() as folder:
        profile = Path(folder) / "profile"
        words = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", str(program), "run", str(SCENE), "-o",
                 f"{folder}/out", "--threads", "1", "--quiet", *settings(more)]
        run = subprocess.run(words, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            sys.exit(f"{program} exited {run.returncode}:\n{run.stderr}")
        text = profile.read_text()
    return {"the steps": inclusive(text, STEP),
            "the whole process": int(re.search(r"^(?:totals|summary): (\d+)", text, re.MULTILINE)[1])}


def inclusive(profile, function):
    """Instructions of a function and of what it calls, in a profile of callgrind: the cost of all calls of it."""
    number = re.search(r"\((\d+)\) " + re.escape(function), profile)
    calls = rf"^cfn=\({number[1]}\).*\n(?:c\w+=.*\n)*?calls=.*\n\S+ (\d+)" if number else "$^"
    return sum(int(cost) for cost in re.findall(calls, profile, re.MULTILINE))


def functions(program):
    return subprocess.run(["nm", "-C", str(program)], capture_output=True, text=True, check=True).stdout


def refusal(program, more):
    """Exit status, and what was said, of a scene with an effect."""
    run = subprocess.run([str(program), "explain", str(SCENE), *settings(more)], capture_output=True, text=True,
                         check=False)
    return run.returncode, run.stderr.strip()


def main():
    full, spine = (Path(word).resolve() for word in sys.argv[1:3])
    good = True

    def judge(what, holds):
        nonlocal good
        good = good and holds
        print(f"  {'ok' if holds else 'FAILED':7}{what}")

    jobs = [(spine, []), (full, []), *((full, [more]) for more in MORE)]
    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        least, found, *controls = pool.map(lambda job: instructions(*job), jobs)
    for part, count in least.items():
        judge(f"{part}: {count:,} instructions", count > 1e6)
        more = found[part] / count - 1
        judge(f"{part} of the full program: {100 * more:+.3f} %", abs(more) <= MOST)
        for name, control in list(zip(MORE, controls))[: len(MORE) if part == "the steps" else 1]:
            more = control[part] / count - 1
            judge(f"control, with {name}: {100 * more:+.2f} % is more than 1 %", more > MOST)
    full_names, spine_names = functions(full), functions(spine)
    for pattern in LEFT_OUT:
        judge(f"in the full program alone: {pattern}",
              bool(re.search(pattern, full_names)) and not re.search(pattern, spine_names))
    for more in MORE:
        status, said = refusal(spine, [more])
        key = more.split("=")[0]
        judge(f"refused: {said}", status == 2 and key in said and "ASSAY_EFFECTS=spine" in said and "\n" not in said)
        judge(f"explained by the full program: {more}", refusal(full, [more])[0] == 0)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main()
