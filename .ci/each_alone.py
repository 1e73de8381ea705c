#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whether each source compiles by itself: a missing #include shows, which a build of whole folders hides.

usage: each_alone.py COMPILE_COMMANDS JOBS < SOURCES

Sources, a line each, are read by the compiler with the commands of a build, and nothing is made. Exit status 0, or 1.
"""
import json
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def command_of(entry):
    words = shlex.split(entry["command"])
    at = words.index("-o")
    return [*words[:at], *words[at + 2:], "-fsyntax-only", "-O0"]


def main(database, jobs):
    wanted = {str(ROOT / line) for line in sys.stdin.read().split()}
    commands = {}
    for entry in json.loads(Path(database).read_text()):
        commands.setdefault(entry["file"], (entry["directory"], command_of(entry)))
    if not commands:
        sys.exit(f"{database} has no command")
    todo = sorted(wanted & set(commands))

    def read(source):
        folder, command = commands[source]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        return source, run.returncode, run.stderr

    failed = []
    with ThreadPoolExecutor(int(jobs)) as pool:
        for source, status, said in pool.map(read, todo):
            if status != 0:
                failed.append(source)
                print(said, end="")
    print(f"{len(todo)} sources by themselves, {len(failed)} do not compile" +
          "".join(f"\n  {Path(source).relative_to(ROOT)}" for source in failed))
    return 1 if failed else 0


sys.exit(main(*sys.argv[1:3]))
