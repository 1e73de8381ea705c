# SPDX-License-Identifier: BSD-3-Clause
"""What a handle of the library is to Python."""
from __future__ import annotations

import threading
import weakref
from ctypes import c_void_p
from typing import Any, Callable, List

from ._errors import InputError
from ._library import call, text_of


class Handle:
    """A handle of the library, closed once: by close(), at the end of a `with`, or with its last reference. One that a
    thread is in a call of is freed when the call ends."""

    def __init__(self, close: Callable[[c_void_p], None], handle: c_void_p) -> None:
        self._opened, self._calls, self._closed = handle, 0, False
        self._guard = threading.RLock()  # a handler of signals may close it
        self._finalizer = weakref.finalize(self, close, handle)
        self._finalizer.atexit = False  # a daemon thread may still be in a call of it

    def _call(self, function: Callable[..., int], *arguments: Any, quiet: int = 0) -> None:
        """Calls function(handle, *arguments, error)."""
        with self._guard:
            if self._closed:
                raise InputError(f"{type(self).__name__}: is closed", key=type(self).__name__)
            self._calls += 1
        try:
            call(function, self._opened, *arguments, quiet=quiet)
        finally:
            with self._guard:
                self._calls -= 1
                last = self._closed and self._calls == 0
            if last:
                self._finalizer()

    def close(self) -> None:
        """Frees it; nothing may be asked of it afterwards. Points, cells and meshes of a problem outlive it."""
        with self._guard:
            self._closed = True
            unused = self._calls == 0
        if unused:
            self._finalizer()

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __reduce_ex__(self, protocol: Any) -> Any:
        raise InputError(f"{type(self).__name__}: is a handle of this process, and has no copy: make another one",
                         key=type(self).__name__)

    def _shown(self, what: str) -> str:
        return f"<assay.{type(self).__name__}: {what}{', closed' if self._closed else ''}>"

    def _text(self, function: Callable[..., int]) -> str:
        """A text of the library, whatever its length."""
        found: List[str] = []

        def read(handle: c_void_p, _: Any) -> int:
            found.append(text_of(function, handle))
            return 0
        self._call(read)
        return found[0]
