"""Meshes as other libraries have them, as arrays."""

from __future__ import annotations

import math
from typing import Any, Optional, Tuple, Union

import numpy as np

from .arguments import to_array, to_real
from .errors import InvalidArgument


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


def to_faces(faces: Any) -> np.ndarray:
    """(F, 3) of 32- or 64-bit integers."""
    array = to_array(faces, "faces")
    if array.dtype.kind not in "iu":
        raise InvalidArgument(
            f"faces are of type {array.dtype}, but vertex numbers are integers: "
            "convert them with .astype(int)")
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


def _fan(polygons: np.ndarray) -> np.ndarray:
    """Polygons of k corners (N, k) as triangles (N * (k - 2), 3), fanned from
    the first corner, those of a polygon beside each other."""
    corners = polygons.shape[1]
    triangles = np.stack(
        [polygons[:, [0, i, i + 1]] for i in range(1, corners - 1)], axis=1)
    return triangles.reshape(-1, 3)


def _of_flat(flat: np.ndarray) -> np.ndarray:
    """Faces in VTK's form: the number of corners, then the corners."""
    if flat.size and flat.size % 4 == 0 and np.all(flat[::4] == 3):
        return flat.reshape(-1, 4)[:, 1:]
    triangles = []
    at = 0
    while at < flat.size:
        corners = int(flat[at])
        if corners < 3 or corners >= flat.size - at:
            raise InvalidArgument(
                f"faces[{at}] says that a face has {corners} corners, and "
                f"{flat.size - at - 1} numbers follow")
        triangles.append(_fan(flat[None, at + 1:at + 1 + corners]))
        at += corners + 1
    return np.concatenate(triangles) if triangles else np.empty((0, 3), int)


def _of_cells(cells: Any) -> np.ndarray:
    """Faces of meshio's cell blocks, which may be tuples (type, data)."""
    triangles = []
    for i, block in enumerate(cells):
        try:
            kind, data = (block if isinstance(block, tuple) else
                          (block.type, block.data))
        except (AttributeError, ValueError):
            raise InvalidArgument(
                f"cells[{i}] is of type {type(block).__name__}, and no block of "
                "cells: it has no type and data") from None
        if kind in ("triangle", "quad", "polygon"):
            triangles.append(_fan(np.asarray(data)))
        elif kind not in ("vertex", "line"):
            raise InvalidArgument(
                f"the mesh has cells of type {kind!r}; a surface has triangles")
    if not triangles:
        raise InvalidArgument("the mesh has no triangles")
    return np.concatenate(triangles)


def arrays_of(mesh: Any) -> Tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of another library's mesh, told by what it has."""
    if hasattr(mesh, "points") and hasattr(mesh, "cells") and isinstance(
            mesh.cells, (list, tuple)):  # meshio
        points = np.asarray(mesh.points)
        if points.ndim == 2 and points.shape[1] == 2:
            points = np.pad(points, ((0, 0), (0, 1)))
        return to_vertices(points), to_faces(_of_cells(mesh.cells))
    if hasattr(mesh, "points") and hasattr(mesh, "faces"):  # PyVista
        faces = np.asarray(mesh.faces)
        return (to_vertices(mesh.points),
                to_faces(_of_flat(faces) if faces.ndim == 1 else faces))
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):  # trimesh
        return to_vertices(mesh.vertices), to_faces(mesh.faces)
    raise InvalidArgument(
        f"{type(mesh).__name__} is no mesh: a mesh is Mesh(vertices, faces), a "
        "file, or a mesh of trimesh, meshio or PyVista")
