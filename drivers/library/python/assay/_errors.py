# SPDX-License-Identifier: BSD-3-Clause
"""What may go wrong: one class for each code of the library, which are the exit codes of the program."""
from __future__ import annotations

from typing import Optional


class Error(Exception):
    """What the library or the program refuses. str(error) is its line.

    code    of the library, or the exit code of the program
    file    of the scene, with line and column from 1; None: not about a place in a file
    key     of the scene ("motion.peak") or the argument ("points.X"); None: unknown
    point   number of the point, from 0; None: not about a point
    """

    code = 0

    def __init__(self, message: str, *, file: Optional[str] = None, line: Optional[int] = None,
                 column: Optional[int] = None, key: Optional[str] = None, point: Optional[int] = None) -> None:
        super().__init__(message)
        self.file, self.line, self.column, self.key, self.point = file, line, column, key, point

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class MaterialFailure(Error):
    """The material failed."""

    code = 1


class InputError(Error, ValueError):
    """A scene or an argument is wrong."""

    code = 2


class SystemFailure(Error, OSError):
    """Memory, files, processes, or a library that is missing or of another version."""

    code = 3


class BeyondEnd(Error, ValueError):
    """A time after the end to which the response is tabulated: give Problem(..., end=)."""

    code = 4


class OutsideError(Error, ValueError):
    """Some points lie where the motion is not defined. Ask for "status" to learn which: then nothing is raised."""

    code = 5


KINDS = {kind.code: kind for kind in (MaterialFailure, InputError, SystemFailure, BeyondEnd, OutsideError)}
