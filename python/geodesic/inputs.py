"""Meshes as other libraries have them, as arrays."""

from __future__ import annotations

import math
from typing import Any, Optional, Tuple, Union

import numpy as np

from . import _core
from .arguments import to_array, to_real
from .errors import InvalidArgument
from .reach import warn


# How the edges are joined at which a mesh keeps faces apart: None for the usual
# of its kind, False for none, True for those that lie on each other within
# rounding, or a distance.
Weld = Union[None, bool, float]


def to_welding(weld: Weld, usual: bool) -> Tuple[bool, Optional[float]]:
    """Whether edges are joined, and within which distance."""
    if weld is None:
        return usual, None
    if isinstance(weld, (bool, np.bool_)):
        return bool(weld), None
    distance = to_real(weld, "weld")
    if not 0 <= distance < math.inf:
        raise InvalidArgument(f"weld is {distance}, which is no distance")
    return True, distance


def to_vertices(vertices: Any) -> np.ndarray:
    """float64 (V, 3) in C order; the array itself where it is that already."""
    array = to_array(vertices, "vertices")
    if array.dtype.kind not in "fiu":
        raise InvalidArgument(
            f"vertices are of type {array.dtype}, which are no coordinates")
    if array.ndim != 2 or array.shape[1] != 3:
        hint = ""
        if array.ndim == 2 and array.shape[0] == 3:
            hint = ": transpose them with .T"
        elif array.ndim == 2 and array.shape[1] == 2:
            hint = ": give flat meshes a third coordinate of 0"
        raise InvalidArgument(
            f"vertices have shape {array.shape}, not (V, 3){hint}")
    return np.ascontiguousarray(array, np.float64)


def _integers(values: Any, name: str) -> np.ndarray:
    array = to_array(values, name)
    if array.dtype.kind not in "iu":
        raise InvalidArgument(
            f"{name} are of type {array.dtype}, but vertex numbers are integers: "
            "convert them with .astype(int)")
    return array


def to_faces(faces: Any) -> np.ndarray:
    """(F, 3) of 32- or 64-bit integers."""
    array = _integers(faces, "faces")
    if array.ndim != 2 or array.shape[1] != 3:
        hint = ""
        if array.ndim == 2 and array.shape[1] == 4:
            hint = (": a mesh is a surface of triangles; cut quadrilaterals in "
                    "two, and take the boundary of tetrahedra")
        elif array.ndim == 2 and array.shape[0] == 3:
            hint = ": transpose them with .T"
        raise InvalidArgument(f"faces have shape {array.shape}, not (F, 3){hint}")
    if array.dtype.itemsize < 4:
        array = array.astype(np.int32)
    # Also for arrays whose bytes are in the other order.
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def _triangles_of(vertices: np.ndarray, corners: np.ndarray,
                  sizes: np.ndarray) -> np.ndarray:
    """Polygons as triangles, by the rule of files. `corners` are those of all
    polygons, one behind the other, `sizes` how many each has."""
    if np.all(sizes == 3):
        return corners.reshape(-1, 3)
    triangles, crossing, first = _core.triangulate(
        vertices, corners.astype(np.int64), sizes.astype(np.int64))
    if crossing:
        warn(f"{crossing} of the polygons cross themselves, the first of them "
             f"face {first}: their triangles cover other places or lie over "
             "each other")
    return triangles


def _of_flat(flat: np.ndarray, name: str,
             thing: str) -> Tuple[np.ndarray, np.ndarray]:
    """Corners and sizes of cells in VTK's form: the number of corners, then the
    corners."""
    if flat.size and flat[0] >= 3 and flat.size % (flat[0] + 1) == 0:
        rows = flat.reshape(-1, flat[0] + 1)
        if np.all(rows[:, 0] == flat[0]):
            return rows[:, 1:].reshape(-1), rows[:, 0]
    is_corner = np.ones(flat.size, bool)
    at = 0
    while at < flat.size:
        corners = int(flat[at])
        if corners < 3 or corners >= flat.size - at:
            raise InvalidArgument(
                f"{name}[{at}] says that a {thing} has {corners} corners, and "
                f"{flat.size - at - 1} numbers follow")
        is_corner[at] = False
        at += corners + 1
    return flat[is_corner], flat[~is_corner]


def _of_strips(flat: np.ndarray) -> np.ndarray:
    """The triangles of strips in VTK's form: every other one of a strip is
    turned, so that all look to the same side."""
    corners, sizes = _of_flat(flat, "strips", "strip")
    triangles = [np.empty((0, 3), np.int64)]
    for strip in np.split(corners, np.cumsum(sizes)[:-1]):
        own = np.stack([strip[:-2], strip[1:-1], strip[2:]], axis=1)
        own[1::2, :2] = own[1::2, 1::-1]
        triangles.append(own)
    return np.concatenate(triangles)


def _of_poly_data(mesh: Any) -> Tuple[np.ndarray, np.ndarray]:
    """PyVista's: faces, then strips. Vertices and lines are no surface."""
    vertices = to_vertices(mesh.points)
    faces = np.asarray(mesh.faces)
    if faces.ndim == 1:
        faces = _triangles_of(
            vertices,
            *_of_flat(_integers(faces, "faces"), "faces", "face"))
    strips = np.asarray(getattr(mesh, "strips", ()))
    if strips.size:
        faces = np.concatenate(
            [to_faces(faces), _of_strips(_integers(strips, "strips"))])
    elif not faces.size:
        others = [name for name in ("lines", "verts")
                  if np.size(getattr(mesh, name, ()))]
        if others:
            raise InvalidArgument(
                f"the mesh has {' and '.join(others)}, but no faces: a surface "
                "has triangles")
    return vertices, to_faces(faces)


def _of_cells(vertices: np.ndarray, cells: Any) -> np.ndarray:
    """Faces of meshio's cell blocks, which may be tuples (type, data)."""
    corners, sizes, others = [], [], []
    for i, block in enumerate(cells):
        try:
            kind, data = (block if isinstance(block, tuple) else
                          (block.type, block.data))
        except (AttributeError, ValueError):
            raise InvalidArgument(
                f"cells[{i}] is of type {type(block).__name__}, and no block of "
                "cells: it has no type and data") from None
        if kind in ("triangle", "quad", "polygon"):
            for polygons in ([data] if _is_table(data) else data):
                table = np.atleast_2d(_integers(polygons, f"cells[{i}]"))
                corners.append(table.reshape(-1))
                sizes.append(np.full(table.shape[0], table.shape[1]))
        elif kind in ("vertex", "line"):
            if kind not in others:
                others.append(kind)
        else:
            raise InvalidArgument(
                f"the mesh has cells of type {kind!r}; a surface has triangles")
    if not corners:
        only = f", only cells of type {' and '.join(others)}" if others else ""
        raise InvalidArgument(f"the mesh has no triangles{only}")
    if others:
        warn(f"cells of type {' and '.join(others)} are left out: a surface "
             "has triangles and polygons")
    return _triangles_of(vertices, np.concatenate(corners),
                         np.concatenate(sizes))


def _is_table(polygons: Any) -> bool:
    """Whether all have as many corners."""
    return isinstance(polygons, np.ndarray) or len(set(map(len, polygons))) < 2


def arrays_of(mesh: Any) -> Tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of another library's mesh, told by what it has."""
    if hasattr(mesh, "points") and hasattr(mesh, "cells") and isinstance(
            mesh.cells, (list, tuple)):  # meshio
        points = np.asarray(mesh.points)
        if points.ndim == 2 and points.shape[1] == 2:
            points = np.pad(points, ((0, 0), (0, 1)))
        vertices = to_vertices(points)
        return vertices, to_faces(_of_cells(vertices, mesh.cells))
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # PyVista
        return _of_poly_data(mesh)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh
        return to_vertices(mesh.vertices), to_faces(mesh.faces)
    hint = ""
    if hasattr(mesh, "extract_surface"):  # PyVista's grids
        hint = ": give its surface, .extract_surface()"
    elif hasattr(mesh, "GetPoints"):  # VTK
        hint = ": give pyvista.wrap of it"
    raise InvalidArgument(
        f"{type(mesh).__name__} is no mesh{hint}; a mesh is Mesh(vertices, "
        "faces), a file, or a mesh of trimesh, meshio or PyVista")
