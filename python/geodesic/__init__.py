"""Exact geodesic distances and shortest paths on triangle meshes.

    import geodesic

    mesh = geodesic.Mesh(V, F)          # numpy arrays, a file, a trimesh...
    d = mesh.distances(source=0)        # float64 (V,)
    path = mesh.path(0, 99)             # path.points, path.length

Everything a mesh can be asked is a method of geodesic.Mesh: help(geodesic.Mesh).
"""

from typing import TYPE_CHECKING, Any, Dict

from . import _core
from .approximate import Approximate
from .errors import (Cancelled, DeadlineExceeded, GeodesicError, GeodesicWarning,
                     InternalError, InvalidArgument, NotAllowed, NotFound,
                     ResourceExhausted, Unavailable)
from .mesh import Mesh
from .places import Curve, EdgePoint, FacePoint, Places
from .results import Field, Isoline, Line, LogMap, Path

if TYPE_CHECKING:
    from .service import Service

__version__: str = _core.VERSION

__all__ = [
    "Approximate", "Cancelled", "Curve", "DeadlineExceeded", "EdgePoint", "FacePoint", "Field",
    "GeodesicError", "GeodesicWarning", "InternalError", "InvalidArgument", "Isoline", "Line", "LogMap",
    "Mesh", "NotAllowed", "NotFound", "Path", "Places", "ResourceExhausted",
    "Unavailable", "algorithms", "connect"
]


def algorithms() -> Dict[str, str]:
    """The exact algorithms by name, with a summary of each; the first is the
    default. All give the same distances; they differ in time and memory.
    geodesic.Approximate has the approximate ones."""
    return dict(_core.ALGORITHMS)


def connect(address: str, **options: Any) -> "Service":
    """Connects to a geodesic service; needs grpcio and protobuf.

        with geodesic.connect("host:50051") as service:
            d = service.mesh(V, F).distances(0)

    Options: token, insecure_token, timeout (seconds a call may take), tls,
    authorities, certificate, key, server_name; see help(geodesic.service.connect).
    """
    try:
        from . import service
    except ModuleNotFoundError as error:
        if error.name is None or error.name.split(".")[0] not in (
                "grpc", "google"):
            raise
        raise ImportError(
            "geodesic.connect speaks gRPC: install grpcio and protobuf "
            "(Debian: python3-grpcio python3-protobuf)") from None
    return service.connect(address, **options)
