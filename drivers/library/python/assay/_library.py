# SPDX-License-Identifier: BSD-3-Clause
"""libassay.so.1 by ctypes: its structs and functions as in assay.h."""
from __future__ import annotations

import ctypes
import os
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_ssize_t, c_uint32
from ctypes import c_void_p
from functools import lru_cache
from typing import Any, Callable, List

from ._errors import KINDS, Error, SystemFailure

__version__ = "0.2.0"

API_MAJOR = 1
NAME = "libassay.so.1"
HERE = os.path.dirname(os.path.abspath(__file__))


class ErrorStruct(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("code", c_int32), ("line", c_int32), ("column", c_int32),
                ("point", c_int64), ("file", c_char * 256), ("key", c_char * 128), ("message", c_char * 512)]


class Options(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("api_major", c_uint32), ("scene", c_char_p), ("text", c_char_p),
                ("set_count", c_size_t), ("sets", POINTER(c_char_p)), ("end", c_double), ("threads", c_int32)]


class Facts(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("dimension", c_int32), ("end", c_double), ("period", c_double),
                ("density", c_double), ("wave_speed", c_double), ("particle_speed", c_double)]


class Field(ctypes.Structure):
    """Both assay_field and assay_const_field."""

    _fields_ = [("data", c_void_p), ("point_stride", c_ssize_t), ("component_stride", c_ssize_t)]


class View(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("status", c_void_p), ("x", Field), ("v", Field),
                ("a", Field), ("F", Field), ("P", Field), ("sigma", Field), ("b", Field), ("b_static", Field)]


class MeshOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_uint32), ("element", c_int32), ("nodes", c_size_t), ("elements", c_size_t),
                ("X", c_void_p), ("connectivity", c_void_p), ("gauss", c_int32), ("quasi_static", c_int32)]


ELEMENTS = {"triangle": 5, "quadrilateral": 9, "tetrahedron": 10, "hexahedron": 12}

_FIELD, _ERROR, _VIEW = POINTER(Field), POINTER(ErrorStruct), POINTER(View)
_TEXT = [c_void_p, c_char_p, c_size_t, POINTER(c_size_t)]
_FUNCTIONS = {
    "open": [POINTER(Options), POINTER(c_void_p), _ERROR],
    "close": [c_void_p],
    "get_facts": [c_void_p, POINTER(Facts), _ERROR],
    "describe": _TEXT,
    "warnings": _TEXT,
    "points_open": [c_void_p, c_size_t, c_int, _FIELD, POINTER(c_void_p), _ERROR],
    "points_close": [c_void_p],
    "eval": [c_void_p, c_double, c_size_t, c_size_t, _VIEW, _ERROR],
    "tractions": [c_void_p, c_double, c_size_t, c_size_t, _FIELD, _FIELD, _ERROR],
    "cells_open": [c_void_p, c_size_t, c_void_p, POINTER(c_void_p), _ERROR],
    "cells_close": [c_void_p],
    "cells_eval": [c_void_p, c_double, _FIELD, c_void_p, _ERROR],
    "mesh_open": [c_void_p, POINTER(MeshOptions), POINTER(c_void_p), _ERROR],
    "mesh_close": [c_void_p],
    "nodal_loads": [c_void_p, c_double, _FIELD, _ERROR],
    "at_current": [c_void_p, c_double, c_size_t, c_int, _FIELD, _FIELD, _VIEW, _ERROR],
}


def _places() -> List[str]:
    """Where the library may be: named by the user, in a build folder or prefix, where the loader looks."""
    named = os.environ.get("ASSAY_LIBRARY")
    if named:
        return [named]
    beside = [os.path.join(HERE, *up, NAME) for up in ([".."] * 2, [".."] * 3)]
    return [path for path in beside if os.path.exists(path)] + [NAME]


def _numbers(version: str) -> List[int]:
    return [int(part) if part.isdigit() else 0 for part in version.split(".")[:3]]


@lru_cache(maxsize=None)
def library() -> ctypes.CDLL:
    """The library, loaded once. SystemFailure: it is not there, or older than this package."""
    place = _places()[0]
    try:
        loaded = ctypes.CDLL(place)
        version = loaded.assay_version
    except (OSError, AttributeError) as error:
        raise SystemFailure(f"{place}: cannot be used as assay's library: {error}; install the package `assay`, or let "
                            "the environment variable ASSAY_LIBRARY name the file") from None
    version.restype = c_char_p
    found = version().decode()
    if _numbers(found) < _numbers(__version__):
        raise SystemFailure(f"{place}: is of assay {found}, older than this Python package ({__version__}, in {HERE}): "
                            "install both from one assay, or let ASSAY_LIBRARY name a newer library")
    for name, arguments in _FUNCTIONS.items():
        function = getattr(loaded, "assay_" + name)
        function.argtypes = arguments
        function.restype = None if name.endswith("close") else c_int
    return loaded


def library_version() -> str:
    """The version of the library that is used."""
    return library().assay_version().decode()


def call(function: Callable[..., int], *arguments: Any, quiet: int = 0) -> int:
    """Calls function(*arguments, error) and raises what it says; quiet: a code that is returned instead."""
    error = ErrorStruct(ctypes.sizeof(ErrorStruct))
    code = function(*arguments, byref(error))
    if code and code != quiet:
        raise KINDS.get(code, Error)(
            _as_arguments(error.message), file=_as_arguments(error.file) or None, line=error.line or None,
            column=error.column or None, key=_as_arguments(error.key) or None,
            point=None if error.point < 0 else error.point)
    return code


def _as_arguments(words: bytes) -> str:
    """With the names that Python's arguments have."""
    found = words.decode(errors="replace")
    return "sets" + found[5:] if found.startswith("--set") else found.replace("options.", "")


def text_of(function: Callable[..., int], handle: c_void_p) -> str:
    """A text of the library, whatever its length."""
    needed = c_size_t()
    function(handle, None, 0, byref(needed))
    buffer = ctypes.create_string_buffer(max(needed.value, 1))
    function(handle, buffer, needed.value, None)
    return buffer.value.decode()
