"""Exact geodesic distances and shortest paths on triangle meshes.

    import geodesic

    mesh = geodesic.Mesh(V, F)          # numpy arrays, a file, a trimesh...
    d = mesh.distances(source=0)        # float64 (V,)
    path = mesh.path(0, 99)             # path.points, path.length

Everything a mesh can be asked is a method of geodesic.Mesh: help(geodesic.Mesh).
"""

from typing import Dict

from . import _core
from .errors import (Cancelled, DeadlineExceeded, GeodesicError, InternalError,
                     InvalidArgument, NotAllowed, NotFound, ResourceExhausted,
                     Unavailable)
from .mesh import Mesh
from .places import Curve, EdgePoint, FacePoint, Places
from .results import Field, Isoline, LogMap, Path

__version__: str = _core.VERSION

__all__ = [
    "Cancelled", "Curve", "DeadlineExceeded", "EdgePoint", "FacePoint", "Field",
    "GeodesicError", "InternalError", "InvalidArgument", "Isoline", "LogMap",
    "Mesh", "NotAllowed", "NotFound", "Path", "Places", "ResourceExhausted",
    "Unavailable", "algorithms"
]


def algorithms() -> Dict[str, str]:
    """The algorithms by name, with a summary of each; the first is the default.
    All give the same distances; they differ in time and memory."""
    return dict(_core.ALGORITHMS)
