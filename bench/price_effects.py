#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what each optional effect costs and writes the table of docs/effects.md.

usage: price_effects.py EFFECT_PRICES PAGE.md [EFFECT...]
    the program of bench/effect_prices.cpp, and the page; of these effects the rows alone

Of each effect the same scene with it and without: time by turns, instructions by callgrind (of the best set that it
knows, AVX2), bytes from the composition. What lies between the page's marks is replaced.
"""
import datetime
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FEW, MORE = 2, 6  # steps: the set-up and the first step are what both have in common
MARKS = ("<!-- measured: ./dev bench -->", "<!-- end of what is measured -->")


def instructions(program, name, side):
    """A particle-step."""
    counts, particles = [], 1
    for steps in (FEW, MORE):
        with tempfile.TemporaryDirectory() as folder:
            profile = Path(folder) / "profile"
            words = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, name, side, str(steps)]
            run = subprocess.run(words, capture_output=True, text=True, check=True)
            particles = int(run.stdout)
            counts.append(int(re.search(r"^(?:totals|summary): (\d+)", profile.read_text(), re.MULTILINE)[1]))
    return (counts[1] - counts[0]) / ((MORE - FEW) * particles)


def machine():
    cpu = re.search(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return f"{cpu[1].strip() if cpu else 'unknown processor'}, {os.cpu_count()} threads of which one is used"


def number(value):
    return f"{value:,.0f}" if abs(value) >= 9.5 else f"{value:.1f}"


def row_of(program, price):
    time = f"{number(price['ns_without'])} | {price['ns']:+.1f} ± {price['ns_spread']:.1f}"
    if price["around"]:
        return f"| {price['name']} | `{price['key']}` | {time} | {price['steps']} | {price['observed']} |"
    least, most = (instructions(program, price["name"], side) for side in ("without", "with"))
    return (f"| {price['name']} | `{price['key']}` | {time} | {number(least)} | {most - least:+,.0f} | "
            f"{price['bytes_stored']:+,.0f} | {price['bytes_moved']:+,.0f} |")


def with_rows(page, rows):
    """The page with these rows, each in place of the effect's own, or at the end of its table."""
    begin, end = (page.index(mark) for mark in MARKS)
    lines = page[begin:end].splitlines(keepends=True)
    for row in rows:
        name, cells = row.split(" | ")[0] + " | ", row.count(" | ")
        table = [k for k, line in enumerate(lines) if line.startswith("| ") and line.count(" | ") == cells]
        own = [k for k in table if lines[k].startswith(name)]
        if own:
            lines[own[0]] = row + "\n"
        else:
            lines.insert(table[-1] + 1, row + "\n")
    return page[:begin] + "".join(lines) + page[end:]


def main():
    program, page, names = sys.argv[1], Path(sys.argv[2]), sys.argv[3:]
    of_steps, of_runs = [], []
    command = [program, *names]
    for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
        price = json.loads(line)
        (of_runs if price["around"] else of_steps).append(row_of(program, price))
        print((of_runs if price["around"] else of_steps)[-1], flush=True)
    if names:
        page.write_text(with_rows(page.read_text(), of_steps + of_runs))
        return
    begin = "| effect | key | ns a particle-step without | price |"
    steps = f"{begin} instructions without | price | bytes stored | bytes moved |\n|{' --- |' * 8}\n"
    runs = f"{begin} steps | of the run with it |\n|{' --- |' * 6}\n"
    text = (f"{machine()}, {datetime.date.today().strftime('%B %Y')}. Of a step, all but the key a "
            f"particle-step:\n\n{steps}" + "\n".join(of_steps) +
            f"\n\nAround the steps, processor time of a whole short run over its particle-steps:\n\n{runs}" +
            "\n".join(of_runs))
    before, rest = page.read_text().split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    page.write_text(f"{before}{MARKS[0]}\n\n{text}\n\n{MARKS[1]}{after}")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
