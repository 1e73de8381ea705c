# SPDX-License-Identifier: BSD-3-Clause
"""Verbs of the program `assay`, and what they find as plain objects."""
from __future__ import annotations

import csv
import json
import os
import re
import shutil
import subprocess
import tempfile
from contextlib import ExitStack
from typing import Any, Dict, List, Mapping, Optional, Sequence

from . import _arguments, _arrays
from ._arguments import Path
from ._errors import KINDS, Error, InputError, SystemFailure
from ._library import HERE

class Result(Dict[str, Any]):
    """A dict whose keys are attributes, too: result.error.l2_max is result["error"]["l2_max"].

    Results of run and tabulate have the keys of result.json, and
      status   the exit status: 0 as expected, 1 not
      tables   the CSV files by name, each a dict of columns: result.tables.errors["t"]
    """

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"no {name!r} here; there are: {', '.join(self)}") from None


def _program() -> str:
    """Named by the user, in the build folder or prefix of this package, or on PATH."""
    named = os.environ.get("ASSAY_PROGRAM")
    beside = [os.path.join(HERE, "..", "..", "assay"), os.path.join(HERE, *[".."] * 4, "bin", "assay")]
    found = named or next((path for path in beside if os.path.isfile(path)), None) or shutil.which("assay")
    if not found:
        raise SystemFailure("the program assay is not on PATH, and ASSAY_PROGRAM does not name it")
    return found


def _call(arguments: Sequence[str], text: Optional[str] = None) -> "subprocess.CompletedProcess[str]":
    """Runs the program, which reads the text where an argument is "-"; statuses 0 and 1 are results."""
    try:
        done = subprocess.run([_program(), *arguments], capture_output=True, input=text or "", encoding="utf-8",
                              errors="replace", check=False)
    except OSError as error:
        raise SystemFailure(f"{_program()}: {error.strerror}") from None
    except ValueError as error:  # as a NUL in an argument
        raise InputError(f"assay {arguments[0]}: {error}") from None
    if done.returncode not in (0, 1):
        lines = done.stderr.strip().splitlines() or [f"assay {arguments[0]}: ended with status {done.returncode}"]
        place = re.match(r"(.*?):(\d+)(?::(\d+))?: (?:([\w.\[\]]+): )?", lines[-1])
        file, line, column, key = place.groups() if place else (None, None, None, None)
        raise KINDS.get(done.returncode, SystemFailure)(lines[-1], file=file, line=int(line) if line else None,
                                                       column=int(column) if column else None, key=key)
    return done


def _column(texts: Sequence[str]) -> Any:
    """Numbers as an array, nan for an empty cell; texts as they are."""
    try:
        numbers = [float(text or "nan") for text in texts]
    except ValueError:
        return list(texts)
    return numbers if _arrays.numpy is None else _arrays.numpy.array(numbers)


def _table(path: str) -> Result:
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(line for line in file if not line.startswith("#"))
    return Result({name: _column([row[k] for row in rows]) for k, name in enumerate(names)})


def _parsed(text: str) -> Any:
    try:
        return json.loads(text, object_hook=Result)
    except ValueError as error:
        raise Error(f"assay: its JSON cannot be read: {error}: {text[:200]}") from None


def _in_folder(verb: str, scene: Optional[Path], text: Optional[str], sets: Sequence[str], folder: Optional[Path],
               options: Sequence[str]) -> Result:
    if (scene is None) == (text is None):
        raise InputError("scene, text: one of them is needed, and not both", key="scene")
    with ExitStack() as stack:
        if folder is None:
            folder = os.path.join(stack.enter_context(tempfile.TemporaryDirectory(prefix="assay_")), "result")
        changes = [word for change in sets for word in ("--set", change)]
        file = "-" if scene is None else _arguments.operand(scene, "scene")
        if text is not None:
            _arguments.text(text, "text")
        folder = _arguments.operand(folder, "folder")
        done = _call([verb, file, *changes, "-o", folder, "--json", "--quiet", *options], text)
        result = _parsed(done.stdout)
        result["status"] = done.returncode
        result["tables"] = Result({name[:-4]: _table(os.path.join(folder, name))
                                   for name in sorted(os.listdir(folder)) if name.endswith(".csv")})
    return result


def run(scene: Optional[Path] = None, *, text: Optional[str] = None, sets: Any = (), folder: Optional[Path] = None,
        threads: int = 1) -> Result:
    """Runs a scene, as `assay run` does, and returns its result.json and tables.

    folder: where its files are kept; None: nowhere. A run that becomes unstable or does not do what its scene expects
    is a result with status 1. Raises InputError, with file, line and column, and SystemFailure.
    """
    words = ["--threads", str(_arguments.whole(threads, "threads"))]
    return _in_folder("run", scene, text, _arguments.sets(sets), folder, words)


def tabulate(scene: Optional[Path] = None, *, text: Optional[str] = None, sets: Any = (),
             folder: Optional[Path] = None, points: Any = None) -> Result:
    """Tabulates the response of the scene's material along its motion, as `assay tabulate` does.

    result.tables.sheet has the columns xi, t [s], gamma, tau11 [Pa] ...; points: rows of (xi, t [s]) at which
    result.tables.points has the same. folder, exceptions: as with run.
    """
    changes = _arguments.sets(sets)
    if points is None:
        return _in_folder("tabulate", scene, text, changes, folder, [])
    try:
        rows = [(_arguments.number(xi, "points"), _arguments.number(t, "points")) for xi, t in points]
    except (TypeError, ValueError) as error:
        raise error if isinstance(error, InputError) else _arguments.refused("points", "rows of xi and t", points)
    with tempfile.TemporaryDirectory(prefix="assay_") as own:
        file = os.path.join(own, "points.csv")
        with open(file, "w", encoding="utf-8") as out:
            out.write("xi,t\n" + "".join(f"{xi!r},{t!r}\n" for xi, t in rows))
        return _in_folder("tabulate", scene, text, changes, folder, ["--points", file])


def _option(name: str, value: Any) -> List[str]:
    """An option of the program: quick=True, parameters={"E": 1e3}, props=[210e3, .3], statev=7."""
    word = "--" + name.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [word]
    if isinstance(value, Mapping):
        return [word, ",".join(f"{key}={number}" for key, number in value.items())]
    return [word, str(value) if isinstance(value, str) or not hasattr(value, "__iter__") else ",".join(map(str, value))]


def check(material: Path, *, folder: Optional[Path] = None, **options: Any) -> Result:
    """Tests a material model, as `assay check` does: result.verdict, result.diagnosis, result.tests.

    material: a name, library, description or source. options: those of the program, with _ for -:
    quick=True, parameters={"E": 1e3, "nu": .3}, props=[210e3, .3], statev=7, strain=.1, symbol="umat".
    folder: for replay files; None: none are kept. A model that fails is a result with status 1.
    """
    with ExitStack() as stack:
        if folder is None:
            folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="assay_"))
        words = [word for name, value in options.items() for word in _option(name, value)]
        words += ["-o", _arguments.operand(folder, "folder")]
        done = _call(["check", _arguments.operand(material, "material"), "--json", "-", "--quiet", *words])
    result = _parsed(done.stdout)
    result["status"] = done.returncode
    return result
