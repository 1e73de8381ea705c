# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of a caller before they become C's. What C would change without a word is refused: InputError."""
from __future__ import annotations

import json
import os
from numbers import Integral, Real
from typing import Any, List, Mapping, Union

from ._errors import InputError

Path = Union[str, "os.PathLike[str]"]

LEAST = {"threads": 0, "gauss": 0, "first": 0, "count": 0}
MOST = {"threads": 2**31 - 1, "gauss": 2**31 - 1, "first": 2**63 - 1, "count": 2**63 - 1}


def refused(key: str, needs: str, value: Any) -> InputError:
    """The exception to raise, which shows at most the beginning of the value."""
    shown = repr(value)
    return InputError(f"{key}: needs {needs}, is {shown if len(shown) <= 60 else shown[:57] + '...'}", key=key)


def _plain(value: Any) -> Any:
    """The number of an array that has no dimension, for it is meant as one."""
    is_array = getattr(value, "shape", None) == () and hasattr(value, "dtype") and not isinstance(value, (str, bytes))
    return value[()] if is_array else value


def number(value: Any, key: str) -> float:
    """A real number; no truth value, and no text that looks like one."""
    found = _plain(value)
    if isinstance(found, bool) or not isinstance(found, Real):
        raise refused(key, "a number", value)
    try:
        return float(found)
    except (OverflowError, ValueError):
        raise refused(key, "a number that float64 has", value) from None


def whole(value: Any, key: str) -> int:
    """A whole number within the bounds of its C type."""
    found = _plain(value)
    if isinstance(found, bool) or not isinstance(found, Integral):
        raise refused(key, "a whole number", value)
    if not LEAST[key] <= int(found) <= MOST[key]:
        raise refused(key, f"a whole number of {LEAST[key]} to {MOST[key]}", value)
    return int(found)


def text(value: Any, key: str) -> bytes:
    """A text in UTF-8, which C reads to its end."""
    if not isinstance(value, str):
        raise refused(key, "a text", value)
    try:
        found = value.encode()
    except UnicodeEncodeError:
        raise refused(key, "a text that UTF-8 has", value) from None
    if b"\0" in found:
        raise refused(key, "a text without NUL", value)
    return found


def path(value: Any, key: str) -> bytes:
    """A path of a file, as the system has it."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise refused(key, "a path", value)
    try:
        found = os.fsencode(value)
    except (TypeError, UnicodeEncodeError):
        raise refused(key, "a path", value) from None
    if not found or b"\0" in found:
        raise refused(key, "a path", value)
    return found


def operand(value: Any, key: str) -> str:
    """A path as a word of a command, where one that begins with - is no option."""
    found = os.fsdecode(path(value, key))
    return "./" + found if found.startswith("-") else found


def sets(changes: Any) -> List[str]:
    """Changes of a scene as the program takes them: "key.path=value"."""
    if changes is None:
        return []
    if isinstance(changes, Mapping):
        return [text(key, f"sets[{k}]").decode() + "=" + _json(value, f"sets[{key!r}]")
                for k, (key, value) in enumerate(changes.items())]
    if isinstance(changes, (str, bytes)) or not hasattr(changes, "__iter__"):
        raise refused("sets", "a list of texts, or a dict,", changes)
    return [text(change, f"sets[{k}]").decode() for k, change in enumerate(changes)]


def _json(value: Any, key: str) -> str:
    def of_numpy(part: Any) -> Any:
        if isinstance(part, Real):
            return float(part)
        if hasattr(part, "tolist"):
            return part.tolist()
        raise TypeError
    try:
        return json.dumps(value, default=of_numpy)
    except (TypeError, ValueError):
        raise refused(key, "a number, text, list or dict", value) from None
