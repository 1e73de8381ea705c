#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Adds to a table of bench_passes what its lines are of the machine's bounds.

usage: count_flops.py RUN_STEPS TABLE.csv

Floating point operations are counted, not estimated: callgrind says how often each instruction of run_steps was
executed, and objdump which they are. Each lane counts, padding too; a fused operation would be two. The count is that of
the best instructions that callgrind knows (AVX2). New columns:
  flops            a particle-step
  share_of_memory  bytes_per_second over that of machine/memory of as many threads
  share_of_flops   flops times items_per_second over that of machine/arithmetic, a thread
"""
import csv
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ACROSS, FEW, MORE = 10, 2, 6  # the set-up is what a few steps have in common with more
LANES = {"sd": lambda _: 1, "pd": lambda operands: 8 if "zmm" in operands else 4 if "ymm" in operands else 2}
ARITHMETIC = re.compile(r"^v?(f(?:n)?m(?:add|sub)\d+|add|sub|mul|div|sqrt|max|min|hadd|addsub)(sd|pd)$")


def flops_of_instructions(program):
    """Address of each instruction that works on doubles -> operations."""
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], capture_output=True, text=True, check=True)
    found = {}
    for line in listing.stdout.splitlines():
        parts = line.split("\t", 1)
        if len(parts) < 2 or not parts[0].strip().endswith(":"):
            continue
        mnemonic, _, operands = parts[1].strip().partition(" ")
        match = ARITHMETIC.match(mnemonic)
        if match:
            fused = 2 if match[1].startswith("f") else 1
            found[int(parts[0].strip()[:-1], 16)] = fused * LANES[match[2]](operands)
    return found


def executions(profile):
    """Address -> how often, from callgrind's file (its positions are relative to the last, and calls have two lines)."""
    times, address, is_call, here = {}, 0, False, False
    program = re.search(r"ob=(\(\d+\)) \S*run_steps$", profile, re.MULTILINE)[1]
    for line in profile.splitlines():
        if line.startswith("ob="):
            here = line[3:].split(" ")[0] == program
        elif line.startswith("calls="):
            is_call = True
        elif line and line[0] in "0+-*":
            position, _, cost = line.split(" ")[:3]
            if position != "*":
                address = int(position, 0) + (0 if position[0] == "0" else address)
            if here and not is_call:
                times[address] = times.get(address, 0) + int(cost)
            is_call = False
    return times


def count(program, case, steps, flops):
    """Operations of so many steps, and the number of particles."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "profile"
        ran = subprocess.run(
            ["valgrind", "--tool=callgrind", "--dump-instr=yes", f"--callgrind-out-file={out}", program, case, str(ACROSS),
             str(steps)], capture_output=True, text=True, check=True)
        times = executions(out.read_text())
    return sum(flops.get(address, 0) * n for address, n in times.items()), int(ran.stdout)


def flops_of_cases(program):
    flops = flops_of_instructions(program)
    found = {}
    for case in subprocess.run([program], capture_output=True, text=True, check=True).stdout.split():
        few, _ = count(program, case, FEW, flops)
        more, particles = count(program, case, MORE, flops)
        found[case] = (more - few) / ((MORE - FEW) * particles)
    return found


def main():
    program, table = sys.argv[1:]
    found = flops_of_cases(program)
    lines = Path(table).read_text().splitlines()
    begin = next(k for k, line in enumerate(lines) if line.startswith("name,"))  # after what it says of the machine
    rows = list(csv.DictReader(lines[begin:]))
    names = list(rows[0]) + ["flops", "share_of_memory", "share_of_flops"]
    rate = {row["name"].removesuffix("/real_time"): row for row in rows}
    arithmetic = float(rate["machine/arithmetic/1"]["items_per_second"])
    for row in rows:
        case, *rest = row["name"].split("/")
        if case not in found:
            continue
        threads = int(rest[1])
        memory = float(rate[f"machine/memory/{threads}"]["bytes_per_second"])
        row["flops"] = f"{found[case]:.0f}"
        row["share_of_memory"] = f"{float(row['bytes_per_second']) / memory:.3f}"
        row["share_of_flops"] = f"{found[case] * float(row['items_per_second']) / (arithmetic * threads):.3f}"
    with open(table, "w", newline="") as file:
        writer = csv.DictWriter(file, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


main()
