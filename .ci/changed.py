#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a change touches, and which of the deep checks it calls for (docs/development.md, "Which check is where").

usage: changed.py BASE checks                   names of deep checks, a line each: spine races mutants long foreign ...
       changed.py BASE sources:K/N [PREFIX...]  sources that changed, and every N-th, from the K-th on, of those that
                                                read a header that changed, below the prefixes
       changed.py BASE files                    all that changed

BASE is a commit; `-` stands for none, and then everything has changed. What is not committed counts as changed.
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# What builds and checks everything calls for every deep check.
HOW = r"CMakeLists|CMakePresets|cmake/|tests/CMakeLists|tests/[a-z]+[.]cmake|dev$|[.]ci/|"
# deep check: paths whose change calls for it
CALLS = {
    "spine": HOW + r"mpm/|harness/|drivers/(simulation/|composition|effects|run|verbs/run)|"
                   r"bench/(compare_spine|minimal_step|effect_scenes)|configs/paper/",
    "races": HOW + r"mpm/|harness/|drivers/|tests/(races|mpm/test_races|drivers/library)",
    "mutants": HOW + r"drivers/|mpm/|adapters/|harness/|tests/fuzz/",
    "long": HOW + r"drivers/|mpm/|adapters/|harness/|tests/|configs/|docs/check[.]md",
    "foreign": r"drivers/(library|export|judge|templates/export)/|tests/foreign",
    "bench": HOW + r"bench/",
    "package": HOW + r"tests/(package|downstream)/|harness/assay_material|drivers/library/|adapters/(models|abaqus)/|completions/|configs/|"
                     r"docs/assay[.]1|README|LICENSE|THIRD_PARTY|CHANGELOG",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def git(*words):
    try:
        run = subprocess.run(["git", "-C", str(ROOT), *words], capture_output=True, text=True, check=False)
    except OSError as error:
        sys.exit(f"changed.py: git: {error.strerror}")
    if run.returncode != 0:
        sys.exit("changed.py: " + (run.stderr.strip().splitlines() or ["git failed"])[0])
    return run.stdout.split("\0")


def files():
    if not (ROOT / ".git").exists():  # an archive of the sources
        tops = [top for top in ROOT.iterdir() if top.name not in ("build", "results")]
        found = [path for top in tops for path in ([top] if top.is_file() else top.rglob("*"))]
        return sorted(str(path.relative_to(ROOT)) for path in found if path.is_file())
    return [name for name in git("ls-files", "-z", "--cached", "--others", "--exclude-standard")
            if name and (ROOT / name).is_file()]


def changed(base):
    if base == "-":
        return files()
    names = git("diff", "-z", "--name-only", "--no-renames", base, "--") + git("ls-files", "-z", "--others", "--exclude-standard")
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
    hand = re.fullmatch(r"sources:(\d+)/([1-9]\d*)", words[1]) if len(words) > 1 else None
    if not hand and (len(words) != 2 or words[1] not in ("checks", "files")):
        sys.exit(__doc__)
    base, question, prefixes = words[0], words[1], words[2:]
    names = changed(base)
    if question == "checks":
        answer = [check for check, paths in CALLS.items()
                  if base == "-" or any(re.match(paths, name) for name in names)]
    elif question == "files":
        answer = names
    else:
        sources = sorted(name for name in readers(names)
                         if name.endswith((".cpp", ".c")) and (ROOT / name).is_file() and
                         (not prefixes or name.startswith(tuple(prefixes))))
        only_read = [name for name in sources if name not in set(names)]
        dealt = set(only_read[int(hand[1])::int(hand[2])])
        answer = [name for name in sources if name in set(names) or name in dealt]
    for line in answer:
        print(line)


main(sys.argv[1:])
