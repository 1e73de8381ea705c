# SPDX-License-Identifier: BSD-3-Clause
"""Problems, and their points, cells and meshes."""
from __future__ import annotations

import json
import os
from ctypes import byref, c_char_p, c_void_p, sizeof
from functools import cached_property
from typing import Any, Callable, List, Mapping, Optional, Sequence, Union

from . import _arguments, _arrays, _program
from ._errors import InputError
from ._handle import Handle
from ._library import ELEMENTS, API_MAJOR, Facts, Field, MeshOptions, Options, View, call, library

Sets = Union[Sequence[str], Mapping[str, Any], None]
VECTORS = ("x", "v", "a", "b", "b_static")
TENSORS = {"F": (3, 3), "P": (3, 3), "sigma": (6,)}
OUTSIDE = 5


def _one_or_all(names: Sequence[str], out: Any) -> Sequence[Any]:
    """The arrays for these names: out itself for one name, a sequence for several, None where new ones are wanted."""
    if out is None:
        return [None] * len(names)
    if len(names) == 1 and not isinstance(out, (list, tuple)):
        return [out]
    if not isinstance(out, (list, tuple)) or len(out) != len(names):
        raise InputError(f"out: needs {len(names)} arrays, for {', '.join(names)}", key="out")
    return out


class _Request:
    """A view of the library over the arrays that a caller wants."""

    def __init__(self, n: int, dimension: int, names: Sequence[str], out: Any, current: bool = False) -> None:
        if not names:
            raise InputError("no field is named: give \"b\", for example", key="fields")
        self.view = View(sizeof(View))
        self.X: Optional[Field] = None
        self.names, self.n, self.held, self.results = names, n, [], []
        known = (*VECTORS, *TENSORS, "status")
        for k, name in enumerate(names):
            if not isinstance(name, str) or name not in known + (("X",) if current else ()):
                raise InputError(f"{name!r} is no field; known: {', '.join(known)}", key="fields")
            if name in names[:k]:
                raise InputError(f"{name!r} is asked for twice", key="fields")
        for name, array in zip(names, _one_or_all(names, out)):
            shape = (dimension,) if name in VECTORS or name == "X" else TENSORS.get(name, ())
            made = array if array is not None else _arrays.new(n, shape, "d" if shape else "i")
            if shape:
                held, field = _arrays.wanted(made, n, shape, name)
                if name == "X":
                    self.X = field
                else:
                    setattr(self.view, name, field)
            else:
                held, self.view.status = _arrays.integers(made, n, name)
            self.held.append(held)
            self.results.append(array if array is not None else (made, shape))

    def run(self, of: Handle, function: Callable[..., int], *arguments: Any) -> Any:
        of._call(function, *arguments, byref(self.view), quiet=OUTSIDE if "status" in self.names else 0)
        found = [_arrays.shaped(*result) if isinstance(result, tuple) else result for result in self.results]
        return found[0] if len(found) == 1 else tuple(found)


class Points(Handle):
    """Fixed reference points of a problem. Made by Problem.points."""

    def __init__(self, problem: Problem, X: Any) -> None:
        library_ = library()
        _, n, components, field = _arrays.given(X, problem.dimension, "points.X")
        handle = c_void_p()
        problem._call(library_.assay_points_open, n, components, byref(field), byref(handle))
        super().__init__(library_.assay_points_close, handle)
        self._n, self._dimension = n, problem.dimension
        self._eval, self._tractions = library_.assay_eval, library_.assay_tractions

    def __len__(self) -> int:
        return self._n

    def __call__(self, t: float, *fields: str, out: Any = None, first: int = 0, count: Optional[int] = None) -> Any:
        """The fields of the points at time t [s]: one array, or a tuple of arrays in the order asked.

        x, v, a       position [m], velocity [m/s], acceleration [m/s^2], shape (n, dimension)
        F, P          deformation gradient [1], first Piola-Kirchhoff stress [Pa], shape (n, 3, 3)
        sigma         Cauchy stress [Pa], shape (n, 6): 11, 22, 33, 12, 13, 23
        b, b_static   body force per mass [m/s^2], with and without inertia, shape (n, dimension)
        status        0, or 5 where a point lies outside the motion, shape (n,), int32

        out: a float64 array to fill in place, of any strides, with the shape above or flat; for several fields a tuple,
        with None where a new array is wanted. first, count: only these points, so that threads can share one set.
        Raises BeyondEnd after the end, OutsideError where points lie outside and "status" is not asked for. Points
        outside are nan then, and the others are filled.
        """
        first = _arguments.whole(first, "first")
        count = self._n - first if count is None else _arguments.whole(count, "count")
        if not 0 <= first <= self._n or not 0 <= count <= self._n - first:
            raise InputError(f"first, count: {first}, {count} are not within {self._n} points", key="first")
        request = _Request(count, self._dimension, fields, out)
        return request.run(self, self._eval, _arguments.number(t, "t"), first, count)

    def __repr__(self) -> str:
        return self._shown(f"{self._n} points in {self._dimension} dimensions")

    def tractions(self, t: float, N: Any, out: Any = None) -> Any:
        """P N per reference area [Pa] at time t [s], shape (n, dimension); N: outward reference normals of any length,
        (n, dimension)."""
        _, n, components, normals = _arrays.given(N, self._dimension, "tractions.N")
        if n != self._n or components < self._dimension:
            raise InputError(f"tractions.N: has {n} normals, needs {self._n}", key="tractions.N")
        return _vectors(self, n, out, self._tractions, _arguments.number(t, "t"), 0, n, byref(normals))


def _vectors(of: Any, n: int, out: Any, function: Callable[..., int], *arguments: Any,
             behind: Sequence[Any] = ()) -> Any:
    """n vectors that a function writes, behind its other arguments and before the last ones."""
    shape = (of._dimension,)
    made = _arrays.new(n, shape) if out is None else out
    _, field = _arrays.wanted(made, n, shape, "out")
    of._call(function, *arguments, byref(field), *behind)
    return _arrays.shaped(made, shape) if out is None else out


class Cells(Handle):
    """Cells over which b is averaged. Made by Problem.cells."""

    def __init__(self, problem: Problem, corners: Any) -> None:
        library_ = library()
        self._dimension = problem.dimension
        each = 2 ** self._dimension
        keeper, address, shape = _arrays.contiguous(corners, "d", "cells.corners")
        if shape[1:] != (each, self._dimension):
            raise InputError(f"cells.corners: has the shape {shape}, needs (n, {each}, {self._dimension})",
                             key="cells.corners")
        handle = c_void_p()
        problem._call(library_.assay_cells_open, shape[0], address, byref(handle))
        super().__init__(library_.assay_cells_close, handle)
        self._n, self._eval = shape[0], library_.assay_cells_eval

    def __len__(self) -> int:
        return self._n

    def __call__(self, t: float, out: Any = None) -> Any:
        """Means of b over the cells at time t [s], in m/s^2, shape (n, dimension)."""
        return _vectors(self, self._n, out, self._eval, _arguments.number(t, "t"), behind=(None,))

    @property
    def volumes(self) -> Any:
        """Reference volumes of the cells [m^3], in the plane per metre of thickness, shape (n,)."""
        made, none = _arrays.new(self._n, ()), Field()
        held, field = _arrays.wanted(made, self._n, (1,), "volumes")
        self._call(self._eval, 0.0, byref(none), field.data)
        return _arrays.shaped(made, ())

    def __repr__(self) -> str:
        return self._shown(f"{self._n} cells in {self._dimension} dimensions")


class Mesh(Handle):
    """A finite element mesh. Made by Problem.mesh."""

    def __init__(self, problem: Problem, X: Any, connectivity: Any, element: str, gauss: int,
                 quasi_static: bool) -> None:
        library_ = library()
        self._dimension = problem.dimension
        nodes, address, shape = _arrays.contiguous(X, "d", "mesh.X")
        elements, table, numbers = _arrays.contiguous(connectivity, "q", "mesh.connectivity")
        if len(shape) != 2 or shape[1] != self._dimension:
            raise InputError(f"mesh.X: has the shape {shape}, needs (nodes, {self._dimension})", key="mesh.X")
        if not isinstance(element, str) or element not in ELEMENTS:
            raise InputError(f"mesh.element: unknown: {element!r}; known: {', '.join(ELEMENTS)}", key="mesh.element")
        each = {"triangle": 3, "quadrilateral": 4, "tetrahedron": 4, "hexahedron": 8}[element]
        if len(numbers) != 2 or numbers[1] != each:
            raise InputError(f"mesh.connectivity: has the shape {numbers}, needs (elements, {each})",
                             key="mesh.connectivity")
        options = MeshOptions(sizeof(MeshOptions), ELEMENTS[element], shape[0], numbers[0], address, table,
                              _arguments.whole(gauss, "gauss"), int(bool(quasi_static)))
        handle = c_void_p()
        problem._call(library_.assay_mesh_open, byref(options), byref(handle))
        super().__init__(library_.assay_mesh_close, handle)
        self._n, self._loads = shape[0], library_.assay_nodal_loads

    def __len__(self) -> int:
        return self._n

    def loads(self, t: float, out: Any = None) -> Any:
        """Consistent nodal forces at time t [s] of the body force and of the tractions on all outer faces, in N (in the
        plane N/m), shape (nodes, dimension): rho0 a N + P Grad N, integrated; quasi-static without rho0 a."""
        return _vectors(self, self._n, out, self._loads, _arguments.number(t, "t"))

    def __repr__(self) -> str:
        return self._shown(f"{self._n} nodes in {self._dimension} dimensions")


def _end(value: Any) -> float:
    """A time after 0: to C, 0 means the scene's."""
    end = _arguments.number(value, "end")
    if not end > 0:
        raise _arguments.refused("end", "a time after 0", value)
    return end


class Problem(Handle):
    """A scene's motion, material and exact solution, made once.

    scene     path of a scene; or text: its text, whose relative paths count from the working folder
    sets      changes of it, ["grid.spacing=0.1"] or {"grid.spacing": 0.1}
    end       last time that will be asked for [s]; None: time.end of the scene
    threads   with which the response of the material is tabulated; 0: one

    Raises InputError with file, line and column for a scene that is wrong, MaterialFailure where the material fails on
    the motion, SystemFailure where the library or a compiler is missing.
    """

    def __init__(self, scene: Union[str, "os.PathLike[str]", None] = None, *, text: Optional[str] = None,
                 sets: Sets = (), end: Optional[float] = None, threads: int = 0) -> None:
        library_ = library()
        self._source = (scene, text, _arguments.sets(sets))
        changes = [change.encode() for change in self._source[2]]
        options = Options(sizeof(Options), API_MAJOR, None if scene is None else _arguments.path(scene, "scene"),
                          None if text is None else _arguments.text(text, "text"), len(changes),
                          (c_char_p * max(len(changes), 1))(*changes), 0.0 if end is None else _end(end),
                          _arguments.whole(threads, "threads"))
        handle = c_void_p()
        call(library_.assay_open, byref(options), byref(handle))
        super().__init__(library_.assay_close, handle)
        facts = Facts(sizeof(Facts))
        self._call(library_.assay_get_facts, byref(facts))
        self.dimension: int = facts.dimension              #: 2 (plane strain) or 3
        self.end: float = facts.end                        #: last time that may be asked for [s]
        self.period: float = facts.period                  #: T of the motion [s]
        self.density: float = facts.density                #: rho0 [kg/m^3]
        self.wave_speed: float = facts.wave_speed          #: fastest of the material on the motion's path [m/s]
        self.particle_speed: float = facts.particle_speed  #: fastest of the exact motion [m/s]

    def __repr__(self) -> str:
        return self._shown(f"{self.dimension} dimensions, end {self.end:g} s")

    @cached_property
    def description(self) -> dict:
        """The resolved scene, its hash, the version of the library, the estimated error of the response."""
        return json.loads(self._text(library().assay_describe))

    @cached_property
    def warnings(self) -> List[str]:
        """One sentence each."""
        return self._text(library().assay_warnings).splitlines()

    def points(self, X: Any) -> Points:
        """Reference points X [m], shape (n, dimension), which are copied: the result is called for their fields.
        In the plane a third component is ignored."""
        return Points(self, X)

    def cells(self, corners: Any) -> Cells:
        """Cells with reference corners [m]: (n, 4, 2) counterclockwise in the plane, (n, 8, 3) in VTK's order in space.
        The result is called with a time, and returns the means of b over them."""
        return Cells(self, corners)

    def mesh(self, X: Any, connectivity: Any, element: str, *, gauss: int = 0, quasi_static: bool = False) -> Mesh:
        """A mesh of linear elements: reference nodes X [m], (nodes, dimension), and their numbers from 0,
        (elements, nodes of one) in VTK's order. element: triangle, quadrilateral, tetrahedron or hexahedron.
        gauss: points along each direction, 0: as many as the element needs. quasi_static: loads without inertia."""
        return Mesh(self, X, connectivity, element, gauss, quasi_static)

    def at_current(self, x: Any, t: float, *fields: str, out: Any = None) -> Any:
        """Fields as those of Points, of the points that the exact motion has at x [m] at time t [s]; "X" is one more,
        their reference positions [m]. For codes that know current positions alone: say so beside their results."""
        _, n, components, field = _arrays.given(x, self.dimension, "at_current.x")
        request = _Request(n, self.dimension, fields, out, current=True)
        return request.run(self, library().assay_at_current, _arguments.number(t, "t"), n, components, byref(field),
                           byref(request.X) if request.X is not None else None)

    def run(self, **options: Any) -> _program.Result:
        """assay.run of this scene."""
        scene, text, sets = self._source
        return _program.run(scene, text=text, sets=sets, **options)

    def tabulate(self, **options: Any) -> _program.Result:
        """assay.tabulate of this scene."""
        scene, text, sets = self._source
        return _program.tabulate(scene, text=text, sets=sets, **options)
