#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a change touches, and which of the deep checks it calls for (docs/development.md, "Which check is where").

usage: changed.py BASE checks               names of deep checks, a line each: spine mutants long package bench
       changed.py BASE sources [PREFIX...]  sources that changed or that read a header that changed, below the prefixes
       changed.py BASE files                all that changed

BASE is a commit; `-` stands for none, and then everything has changed. What is not committed counts as changed.
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# deep check: paths whose change calls for it
CALLS = {
    "spine": r"mpm/|cmake/(effects|instructions)|bench/compare_spine|drivers/simulation/|harness/body_force",
    "mutants": r"drivers/(scene|simulation)/|drivers/run|tests/fuzz/",
    "long": r"harness/|adapters/|mpm/|drivers/(simulation|study)/|tests/(harness|adapters|mpm|drivers|downstream)/|"
            r"tests/scenes[.]cmake|configs/(hard|methods|models)/|docs/check[.]md",
    "bench": r"bench/",
    "package": r"cmake/|CMakeLists|tests/(package|downstream)/|completions/|configs/schema/|docs/assay[.]1|dev$",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def git(*words):
    return subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=True).stdout.split("\0")


def files():
    return [name for name in git("ls-files", "-z", "--cached", "--others", "--exclude-standard")
            if name and (ROOT / name).is_file()]


def changed(base):
    if base == "-":
        return files()
    names = git("diff", "-z", "--name-only", base) + git("ls-files", "-z", "--others", "--exclude-standard")
    return sorted({name for name in names if name})


def readers(names):
    """The sources and headers that read one of these files, and these."""
    includes = {}
    for name in files():
        if re.search(r"[.](cpp|hpp|c|h)$", name):
            text = (ROOT / name).read_text(encoding="utf-8", errors="replace")
            for read in INCLUDE.findall(text):
                includes.setdefault(read, []).append(name)
    found, new = set(names), list(names)
    while new:
        for reader in includes.get(new.pop(), []):
            if reader not in found:
                found.add(reader)
                new.append(reader)
    return found


def main(words):
    if len(words) < 2 or words[1] not in ("checks", "sources", "files"):
        sys.exit(__doc__)
    base, question, prefixes = words[0], words[1], words[2:]
    names = changed(base)
    if question == "checks":
        print("\n".join(check for check, paths in CALLS.items()
                        if base == "-" or any(re.match(paths, name) for name in names)))
    elif question == "files":
        print("\n".join(names))
    else:
        print("\n".join(sorted(name for name in readers(names) if name.endswith(".cpp") and (ROOT / name).is_file() and
                               (not prefixes or name.startswith(tuple(prefixes))))))


main(sys.argv[1:])
