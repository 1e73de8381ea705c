#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a change touches (docs/development.md, "Which check is where").

usage: changed.py BASE files                    all that changed
       changed.py BASE sources:MOST [PREFIX...] sources that changed, and at most MOST of those that read a header that
                                                changed, the nearest first, below the prefixes
       changed.py BASE tree                     one number for all files as they are now, whatever BASE is

BASE is a commit; `-` stands for none, and then everything has changed. What is not committed counts as changed.
"""
import hashlib
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
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
    """The sources and headers that read one of these files: a list of names for each distance, itself first."""
    includes = {}
    for name in files():
        if re.search(r"[.](cpp|hpp|c|h)$", name):
            text = (ROOT / name).read_text(encoding="utf-8", errors="replace")
            for read in INCLUDE.findall(text):
                includes.setdefault(read, []).append(name)
    found, rings = set(names), [sorted(names)]
    while rings[-1]:
        ring = {reader for name in rings[-1] for reader in includes.get(name, [])} - found
        found |= ring
        rings.append(sorted(ring))
    return rings


def sources(names, most, prefixes):
    def wanted(ring):
        return [name for name in ring if name.endswith((".cpp", ".c")) and (ROOT / name).is_file() and
                (not prefixes or name.startswith(tuple(prefixes)))]
    rings = readers(names)
    only_read = [name for ring in rings[1:] for name in wanted(ring)]
    if len(only_read) > most:
        print(f"changed.py: {len(only_read) - most} of {len(only_read)} sources that read a changed header are left to "
              "--deep", file=sys.stderr)
    return wanted(rings[0]) + only_read[:most]


def tree():
    total = hashlib.sha256()
    for name in sorted(files()):
        total.update(name.encode() + b"\0" + hashlib.sha256((ROOT / name).read_bytes()).digest())
    return total.hexdigest()


def main(words):
    most = re.fullmatch(r"sources:(\d+)", words[1]) if len(words) > 1 else None
    if not most and (len(words) != 2 or words[1] not in ("files", "tree")):
        sys.exit(__doc__)
    if most:
        answer = sources(changed(words[0]), int(most[1]), words[2:])
    else:
        answer = [tree()] if words[1] == "tree" else changed(words[0])
    for line in answer:
        print(line)


main(sys.argv[1:])
