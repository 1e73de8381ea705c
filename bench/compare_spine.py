#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is not called for costs nothing: the composed step against one that calls the scene's kernels by hand.

usage: compare_spine.py MINIMAL_STEP        the program of bench/minimal_step.cpp

Both take the same steps of the same small scene on one thread under callgrind. Passes where their particles end at the
same bits, and where their instructions a step differ by at most 1 %. Controls that must fail so: the composed step of
the scene with one effect more. Exit status 0, or 1.
"""
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FEW, MORE = 2, 10  # steps: the set-up and the first step are what both have in common
MOST = 0.01  # of the instructions of the step by hand: what is allowed
EFFECTS = ["output.accounts=true", "method.transfer=apic", "force.evaluation=domain_average", "method.update=musl"]


def steps_of(program, *words):
    """Instructions a step, and what the program says of its particles."""
    counts, said = [], ""
    for steps in (FEW, MORE):
        with tempfile.TemporaryDirectory() as folder:
            profile = Path(folder) / "profile"
            run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, words[0],
                                  str(steps), *words[1:]], capture_output=True, text=True, check=False)
            if run.returncode != 0:
                sys.exit(f"{program} exited {run.returncode}:\n{run.stderr}")
            said = run.stdout
            counts.append(int(re.search(r"^(?:totals|summary): (\d+)", profile.read_text(), re.MULTILINE)[1]))
    return (counts[1] - counts[0]) / (MORE - FEW), said


def main():
    good = True

    def judge(what, holds):
        nonlocal good
        good = good and holds
        print(f"  {'ok' if holds else 'FAILED':7}{what}")

    jobs = [["by_hand"], ["composed"], *(["composed", effect] for effect in EFFECTS)]
    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        (least, by_hand), (found, composed), *controls = pool.map(lambda job: steps_of(sys.argv[1], *job), jobs)
    judge(f"by hand: {least:,.0f} instructions a step", least > 1e6)
    judge(f"composed: {100 * (found / least - 1):+.3f} %", abs(found / least - 1) <= MOST)
    judge(f"the same particles: {composed.strip()}", composed == by_hand)
    for effect, (count, _) in zip(EFFECTS, controls):
        judge(f"control, with {effect}: {100 * (count / least - 1):+.2f} % is more than 1 %", count / least - 1 > MOST)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main()
