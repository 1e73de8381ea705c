# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of any kind as the library's fields: the buffer protocol, read by ctypes, so that nothing is copied."""
from __future__ import annotations

import ctypes
from array import array
from ctypes import c_char_p, c_int, c_ssize_t, c_void_p
from typing import Any, Sequence, Tuple

from ._errors import InputError
from ._library import Field

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

STRIDES, WRITABLE, FORMAT = 0x18, 0x1, 0x4  # PyBUF_STRIDES ... of Python's C interface


class Buffer(ctypes.Structure):
    """Py_buffer: holds the memory of an object as long as this lives."""

    _fields_ = [("address", c_void_p), ("obj", c_void_p), ("len", c_ssize_t), ("itemsize", c_ssize_t),
                ("readonly", c_int), ("ndim", c_int), ("format", c_char_p), ("shape", ctypes.POINTER(c_ssize_t)),
                ("strides", ctypes.POINTER(c_ssize_t)), ("suboffsets", c_void_p), ("internal", c_void_p)]

    def __init__(self, owner: Any, flags: int) -> None:
        super().__init__()
        _get(owner, ctypes.byref(self), flags)

    def __del__(self) -> None:
        if self.obj:
            _release(ctypes.byref(self))


_get = ctypes.pythonapi.PyObject_GetBuffer
_get.argtypes = [ctypes.py_object, ctypes.POINTER(Buffer), c_int]
_release = ctypes.pythonapi.PyBuffer_Release
_release.argtypes = [ctypes.POINTER(Buffer)]
_release.restype = None

Place = Tuple[Buffer, Tuple[int, ...], Tuple[int, ...]]  # shape, and strides in bytes


def _place(owner: Any, flags: int) -> Place:
    held = Buffer(owner, flags)
    return held, tuple(held.shape[:held.ndim]), tuple(held.strides[:held.ndim])


def _are_doubles(held: Buffer, strides: Sequence[int]) -> bool:
    aligned = not held.len or not (held.address % 8 or any(stride % 8 for stride in strides))
    return aligned and held.format in (b"d", b"=d", b"@d", b"<d")


def _flat(values: Any, shape: Tuple[int, ...], into: array) -> Tuple[int, ...]:
    """Appends nested sequences, and returns their shape."""
    if isinstance(values, (str, bytes, bool)):
        raise ValueError(f"{values!r} is no number")
    if not hasattr(values, "__len__"):
        into.append(values)
        return shape
    inner = None
    for value in values:
        found = _flat(value, (), into)
        if inner is not None and found != inner:
            raise ValueError("rows of different lengths")
        inner = found
    return shape + (len(values),) + (inner or ())


def contiguous(values: Any, kind: str, key: str) -> Tuple[Any, int, Tuple[int, ...]]:
    """Values as C-ordered doubles ("d") or 64-bit integers ("q"): (what keeps them, address, shape)."""
    try:
        if numpy is not None:
            found = numpy.asarray(_unmasked(values, key))
            if found.size and found.dtype.kind not in ("iuf" if kind == "d" else "iu"):
                raise ValueError(f"its elements are of the type {found.dtype}")
            made = numpy.ascontiguousarray(found, dtype=numpy.float64 if kind == "d" else numpy.int64)
            return made, made.ctypes.data, made.shape
        made = array(kind)
        shape = _flat(memoryview(values).tolist() if not isinstance(values, (list, tuple)) else values, (), made)
        return made, made.buffer_info()[0], shape
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{key}: is no array of {'numbers' if kind == 'd' else 'whole numbers'}: {error}",
                         key=key) from None


def _unmasked(values: Any, key: str) -> Any:
    """The same; InputError for a masked array, whose memory has numbers where it has none."""
    if numpy is not None and isinstance(values, numpy.ma.MaskedArray):
        raise InputError(f"{key}: is a masked array: give its filled() values, or compressed() ones", key=key)
    return values


def given(values: Any, dimension: int, key: str) -> Tuple[Any, int, int, Field]:
    """Rows of 2 or 3 numbers, shape (n, components), or flat (n * dimension,): (keeper, n, components, field)."""
    keeper: Any = None
    if not isinstance(values, (list, tuple)):
        try:
            held, shape, strides = _place(_unmasked(values, key), STRIDES | FORMAT)
            if _are_doubles(held, strides):
                keeper, address = held, held.address
        except InputError:
            raise
        except (TypeError, BufferError, ValueError):
            pass
    if keeper is None:
        keeper, address, shape = contiguous(values, "d", key)
        strides = (8,) if len(shape) == 1 else (8 * shape[-1], 8)
    if len(shape) == 1 and shape[0] % dimension == 0:
        return keeper, shape[0] // dimension, dimension, Field(address, dimension * strides[0] // 8, strides[0] // 8)
    if len(shape) != 2 or shape[1] not in (dimension, 3):
        raise InputError(f"{key}: has the shape {shape}, needs (n, {dimension})", key=key)
    return keeper, shape[0], shape[1], Field(address, strides[0] // 8, strides[1] // 8)


def wanted(out: Any, n: int, shape: Tuple[int, ...], key: str) -> Tuple[Any, Field]:
    """An array that is filled in place: shape (n, ...), (n, components) or flat."""
    try:
        held, found, strides = _place(_unmasked(out, key), STRIDES | FORMAT | WRITABLE)
    except (TypeError, BufferError, ValueError) as error:
        raise InputError(f"{key}: cannot be written: {error}", key=key) from None
    if not _are_doubles(held, strides):
        raise InputError(f"{key}: needs numbers of the type float64, and strides of whole numbers", key=key)
    size = 1
    for extent in shape:
        size *= extent
    if found == (n,) + shape and len(shape) == 2 and (strides[1] == shape[1] * strides[2] or n == 0):
        return held, Field(held.address, strides[0] // 8, strides[2] // 8)
    if found == (n, size):
        return held, Field(held.address, strides[0] // 8, strides[1] // 8)
    if found == (n * size,):
        return held, Field(held.address, size * strides[0] // 8, strides[0] // 8)
    raise InputError(f"{key}: has the shape {found}, needs {(n,) + shape}"
                     + (" with equal strides between its components" if found == (n,) + shape else ""), key=key)


def integers(out: Any, n: int, key: str) -> Tuple[Any, int]:
    """An array of n 32-bit integers that is filled in place."""
    try:
        held, found, strides = _place(_unmasked(out, key), STRIDES | FORMAT | WRITABLE)
    except (TypeError, BufferError, ValueError) as error:
        raise InputError(f"{key}: cannot be written: {error}", key=key) from None
    if held.format not in (b"i", b"=i", b"@i", b"<i") or found != (n,) or (n and strides != (4,)):
        raise InputError(f"{key}: needs {n} numbers of the type int32, one after the other", key=key)
    return held, held.address


def new(n: int, shape: Tuple[int, ...], kind: str = "d") -> Any:
    """An array for results: of numpy, or flat."""
    if numpy is not None:
        return numpy.empty((n,) + shape, dtype=numpy.float64 if kind == "d" else numpy.int32)
    size = n
    for extent in shape:
        size *= extent
    return array(kind, bytes(size * (8 if kind == "d" else 4)))


def shaped(made: Any, shape: Tuple[int, ...]) -> Any:
    """What the caller gets of a new array: with numpy the array, else nested lists."""
    if numpy is not None:
        return made
    rows = made.tolist()
    for extent in reversed(shape):
        rows = [rows[k:k + extent] for k in range(0, len(rows), extent)]
    return rows
