"""What the questions answer."""

from __future__ import annotations

import dataclasses
import functools
from typing import TYPE_CHECKING, Any, Callable, Dict, Optional, Tuple

import numpy as np

from .approximate import Approximate
from .places import Places

if TYPE_CHECKING:
    from .mesh import Mesh


@dataclasses.dataclass(frozen=True, repr=False)
class Field:
    """Distances from sources to every vertex. Lengths have the mesh's unit.

    Attributes:
        distances: float64 (V,); +inf where no path leads, and beyond the limits
            that were asked for.
        target_distances: float64 (T,), one per target; None without targets.
        labels: int32 (V,): the number of the nearest source of each vertex, -1
            where no path leads; None unless asked for.
        gradients: float64 (V, 3): the unit vector in which the distance grows,
            along the shortest path that arrives; 0 at sources and where no path
            leads; None unless asked for.
        settled_radius: every distance up to here is there, exact or within the
            tolerance E (then every true distance up to this / (1 + E)); +inf if
            nothing was left out; 0 if it is approximate.
        algorithm: the name of the one that ran.
        statistics: figures of the computation, such as solve_seconds.
        certified_error: no distance is farther from the truth than this part of
            it, which is at most the tolerance; None if distances are exact.
        certified_errors: float32 (V,), the same for each vertex; 0 where the
            distance is exact or infinite; None unless asked for.
        approximation: the approximate algorithm, with the parameters that were
            used; None if distances are exact or within a tolerance.
    """

    distances: np.ndarray
    target_distances: Optional[np.ndarray]
    labels: Optional[np.ndarray]
    gradients: Optional[np.ndarray]
    settled_radius: float
    algorithm: str
    statistics: Dict[str, Any]
    certified_error: Optional[float] = None
    certified_errors: Optional[np.ndarray] = None
    approximation: Optional[Approximate] = None

    def __array__(self, dtype=None) -> np.ndarray:
        return np.asarray(self.distances, dtype)

    def __repr__(self) -> str:
        finite = self.distances[np.isfinite(self.distances)]
        largest = f"{finite.max():.6g}" if finite.size else "none"
        within = ("" if self.certified_error is None else
                  f", within {self.certified_error:.2g}")
        if self.approximation is not None:
            within = ", approximate"
        return (f"<geodesic.Field: {finite.size} of {self.distances.size} "
                f"vertices reached, largest distance {largest}, "
                f"{self.algorithm}{within}>")


class _Polyline:
    """Points on the surface in order."""

    def __init__(self, mesh: "Mesh", places: Places, points: np.ndarray) -> None:
        self._mesh = mesh
        self.places = places
        self.points = points

    def __len__(self) -> int:
        return len(self.points)

    @functools.cached_property
    def _along(self) -> Tuple[np.ndarray, np.ndarray]:
        return self._mesh._face_finder.along(self.places)

    @property
    def faces(self) -> np.ndarray:
        """int64 (P,): the face through which, or along whose edge, the piece
        from each point to the next runs; for the last point, the piece before."""
        return self._along[0]

    @property
    def barycentric(self) -> np.ndarray:
        """float64 (P, 3): weights of the corners of `faces` that give
        `points`."""
        return self._along[1]


class Path(_Polyline):
    """A shortest path, from the source to the target.

    It runs straight from each point to the next, in one face or along one edge.
    Without points if the target cannot be reached.

    Attributes:
        points: float64 (P, 3), in space.
        places: the same as places: vertices, EdgePoints and FacePoints.
        faces: int64 (P,), the face of the piece after each point.
        barycentric: float64 (P, 3), the points' weights in those faces.
        distance: of the target; +inf if it cannot be reached.
        length: the distance less the source's offset.
        source: the number of the source where the path starts; None if the
            target cannot be reached.
        unreached: why not, in words; None if it is reached.
    """

    def __init__(self, mesh: "Mesh", places: Places, points: np.ndarray,
                 distance: float, length: float, source: int,
                 why: Callable[[], str]) -> None:
        super().__init__(mesh, places, points)
        self._why = why
        self.distance = distance
        self.length = length
        self.source: Optional[int] = source if len(points) else None

    @functools.cached_property
    def unreached(self) -> Optional[str]:
        """Why no path leads there; None if one does."""
        return None if len(self) else self._why()

    def __repr__(self) -> str:
        return f"<geodesic.Path: {len(self)} points, length {self.length:.9g}>"


class Isoline(_Polyline):
    """A line of equal distance, as a polyline on the surface.

    Attributes:
        level: the distance.
        closed: whether the last point leads back to the first.
        points: float64 (P, 3), in space: where the line crosses edges, and
            between these inside faces, as ``chord_error`` asks for.
        places, faces, barycentric: the same as places, and in faces.
    """

    def __init__(self, mesh: "Mesh", places: Places, points: np.ndarray,
                 level: float, closed: bool) -> None:
        super().__init__(mesh, places, points)
        self.level = level
        self.closed = closed

    def __repr__(self) -> str:
        kind = "closed" if self.closed else "open"
        return (f"<geodesic.Isoline: level {self.level:.6g}, {len(self)} points, "
                f"{kind}>")


class Line(_Polyline):
    """A line that runs straight on, across edges and past vertices.

    Attributes:
        points: float64 (P, 3), in space: where it starts, crosses edges and
            vertices, and ends.
        places, faces, barycentric: the same as places, and in faces.
        length: in the unit of the mesh.
        end: why it ends: "length" (it is as long as was asked for), "boundary",
            or "singular" (at an edge of three faces or more, a vertex where
            surfaces touch, or a face without area).
    """

    def __init__(self, mesh: "Mesh", places: Places, points: np.ndarray,
                 length: float, end: str) -> None:
        super().__init__(mesh, places, points)
        self.length = length
        self.end = end

    def __repr__(self) -> str:
        return (f"<geodesic.Line: length {self.length:.6g}, {len(self)} points, "
                f"ends at {self.end}>")


@dataclasses.dataclass(frozen=True, repr=False)
class LogMap:
    """The surface around a source, laid into the plane.

    Attributes:
        coordinates: float64 (V, 2): the distance times (cos, sin) of the angle
            at which the shortest path leaves the source, counterclockwise seen
            from outside; NaN where no path leads, or beyond the radius.
        zero_direction: float64 (3,): the unit vector in space of angle 0.
    """

    coordinates: np.ndarray
    zero_direction: np.ndarray

    def __array__(self, dtype=None) -> np.ndarray:
        return np.asarray(self.coordinates, dtype)

    def __repr__(self) -> str:
        mapped = int(np.sum(~np.isnan(self.coordinates[:, 0])))
        return f"<geodesic.LogMap: {mapped} of {len(self.coordinates)} vertices>"
