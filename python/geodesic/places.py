"""Places on a mesh: vertices, points of edges, points in faces, curves.

A vertex is its number. Anything that takes places takes one or many of them,
mixed or as an array of vertex numbers.
"""

from __future__ import annotations

import dataclasses
import numbers
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np

from .arguments import to_array, to_real
from .errors import InvalidArgument


@dataclasses.dataclass(frozen=True)
class EdgePoint:
    """The point ``(1 - t) * start + t * end`` of the edge between two vertices.

    Attributes:
        start, end: numbers of vertices that share a face.
        t: in [0, 1].
    """

    start: int
    end: int
    t: float


@dataclasses.dataclass(frozen=True)
class FacePoint:
    """The point ``sum(weights[i] * corner i)`` of a face.

    Attributes:
        face: the face's number.
        weights: three barycentric weights >= 0, whose sum is 1.
    """

    face: int
    weights: Tuple[float, float, float]


SurfacePoint = Union[int, "np.integer[Any]", EdgePoint, FacePoint]


@dataclasses.dataclass(frozen=True)
class Curve:
    """A polyline on the surface, as a source: distances are measured from every
    one of its points.

    Attributes:
        points: places of which any two that follow each other share a face.
            ``mesh.curve(...)`` makes such points of places that do not.
        length: in the mesh's unit, where ``mesh.curve(...)`` made it.
        added: how many points, and so how many straight pieces, it put between
            those that were named.
    """

    points: Sequence[SurfacePoint]
    length: Optional[float] = dataclasses.field(default=None, compare=False)
    added: int = dataclasses.field(default=0, compare=False)

    def __repr__(self) -> str:
        if self.length is None:
            return f"Curve(points={self.points!r})"
        return (f"<geodesic.Curve: {len(self.points)} points, {self.added} of "
                f"them added, length {self.length:.9g}>")


Source = Union[SurfacePoint, Curve]

_VERTEX, _EDGE, _FACE = range(3)
_LARGEST = 2**32 - 1


class Places(Sequence):
    """Places of a mesh, as arrays; as a sequence, its items are vertex numbers,
    EdgePoints and FacePoints.

    Attributes:
        kinds: uint8 (N,): 0 a vertex, 1 a point of an edge, 2 a point in a face.
        numbers: uint32 (N, 2): the vertex; the edge's ends; the face.
        weights: float64 (N, 3): the edge's t; the three barycentric weights.
    """

    def __init__(self, kinds: np.ndarray, numbers: np.ndarray,
                 weights: np.ndarray) -> None:
        self.kinds = kinds
        self.numbers = numbers
        self.weights = weights

    def __len__(self) -> int:
        return len(self.kinds)

    def __getitem__(self, i):
        if isinstance(i, slice):
            return Places(self.kinds[i], self.numbers[i], self.weights[i])
        kind = self.kinds[i]
        first, second = (int(number) for number in self.numbers[i])
        if kind == _VERTEX:
            return first
        if kind == _EDGE:
            return EdgePoint(first, second, float(self.weights[i, 0]))
        return FacePoint(first, tuple(float(w) for w in self.weights[i]))

    def __repr__(self) -> str:
        shown = ", ".join(repr(place) for place in self[:3])
        return f"Places([{shown}{', ...' if len(self) > 3 else ''}])"


def empty(count: int) -> Places:
    """That many places, all vertex 0."""
    return Places(np.zeros(count, np.uint8), np.zeros((count, 2), np.uint32),
                  np.zeros((count, 3)))


def _out_of_range(name: str, number: int) -> InvalidArgument:
    """Of a number that no vertex or face of any mesh has."""
    return InvalidArgument(f"{name} is {number}, which is out of range: vertices "
                           "and faces are numbered from 0, below 2^32")


def _number(value: Any, name: str) -> int:
    """A vertex's or face's number, which may still be beyond the mesh."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(
            value, numbers.Integral):
        raise InvalidArgument(f"{name} is {value!r}, which is no number of a "
                              "vertex or face")
    number = int(value)
    if not 0 <= number <= _LARGEST:
        raise _out_of_range(name, number)
    return number


def to_numbers(values: np.ndarray, name: str, count: int) -> np.ndarray:
    """Numbers of vertices or faces, of which there are `count`, from numbers or
    a mask, (N,). Numbers may still be beyond the mesh."""
    if values.dtype == np.bool_:
        if values.shape != (count,):
            raise InvalidArgument(
                f"{name} is a mask of shape {values.shape}; one for this mesh "
                f"has shape ({count},)")
        return np.flatnonzero(values)
    if values.dtype.kind == "f":
        raise InvalidArgument(
            f"{name} is an array of floats of shape {values.shape}, but vertices "
            "are integers. For points in space use mesh.nearest_point(xyz)")
    if values.dtype.kind not in "iu":
        raise InvalidArgument(f"{name} is an array of {values.dtype}, which are "
                              "no numbers")
    values = np.atleast_1d(values)
    if values.ndim != 1:
        raise InvalidArgument(
            f"{name} has shape {values.shape}; numbers come as (N,)")
    wrong = np.flatnonzero((values < 0) | (values > _LARGEST))
    if wrong.size:
        raise _out_of_range(f"{name}[{wrong[0]}]", values[wrong[0]])
    return values


def _is_one(value: Any) -> bool:
    return isinstance(value, (numbers.Integral, EdgePoint, FacePoint, Curve))


def _as_list(value: Any, name: str, vertex_count: int,
             ) -> Union[np.ndarray, List[Any]]:
    """An array of vertex numbers, or a list of places."""
    if isinstance(value, np.ndarray):
        return to_numbers(value, name, vertex_count)
    if _is_one(value):
        return [value]
    if isinstance(value, (str, bytes)):
        raise InvalidArgument(f"{name} is {value!r}, which is no place")
    try:
        items = list(value)
    except TypeError:
        raise InvalidArgument(
            f"{name} is {value!r}; a place is a vertex number, an EdgePoint or a "
            "FacePoint") from None
    if items and all(isinstance(item, numbers.Integral) for item in items):
        return to_numbers(to_array(items, name), name, vertex_count)
    if any(isinstance(item, (float, np.ndarray)) for item in items):
        return to_numbers(to_array(items, name), name, vertex_count)
    return items


def _put(item: Any, name: str, places: Places, i: int) -> None:
    """Writes an item as place i, which empty() has made. `name`: the item's, in
    messages."""
    if isinstance(item, EdgePoint):
        places.kinds[i] = _EDGE
        places.numbers[i] = (_number(item.start, name + ".start"),
                             _number(item.end, name + ".end"))
        places.weights[i, 0] = to_real(item.t, name + ".t")
    elif isinstance(item, FacePoint):
        if to_array(item.weights, name + ".weights").shape != (3,):
            raise InvalidArgument(
                f"{name}.weights are not three numbers: {item.weights!r}")
        places.kinds[i] = _FACE
        places.numbers[i, 0] = _number(item.face, name + ".face")
        places.weights[i] = to_array(item.weights, name + ".weights",
                                     np.float64)
    elif isinstance(item, Curve):
        raise InvalidArgument(f"{name} is a curve; only sources may be")
    else:
        places.numbers[i, 0] = _number(item, name)


def to_places(value: Any, name: str, vertex_count: int) -> Places:
    """One place or many, as Places.

    Raises:
        InvalidArgument: naming the offender, such as ``targets[2]``.
    """
    if isinstance(value, Places):
        return value
    items = _as_list(value, name, vertex_count)
    places = empty(len(items))
    if isinstance(items, np.ndarray):
        places.numbers[:, 0] = items
        return places
    for i, item in enumerate(items):
        _put(item, f"{name}[{i}]", places, i)
    return places


@dataclasses.dataclass
class Sources:
    """Sources as arrays.

    Attributes:
        places: their points in order; a curve has several.
        counts: int64 (S,): how many are a curve's; -1 for a point.
        offsets: float64 (S,): added to the distances from each.
    """

    places: Places
    counts: np.ndarray
    offsets: np.ndarray

    def __len__(self) -> int:
        return len(self.counts)


def _listed(items: List[Any], name: str, vertex_count: int,
            ) -> Tuple[Places, np.ndarray]:
    """Places and counts of listed sources, as Sources has them."""
    points: List[Tuple[Any, str]] = []
    counts = np.full(len(items), -1, np.int64)
    for i, item in enumerate(items):
        here = f"{name}[{i}]"
        if isinstance(item, Curve):
            on_curve = _as_list(item.points, here + ".points", vertex_count)
            counts[i] = len(on_curve)
            points += [(point, f"{here}.points[{k}]")
                       for k, point in enumerate(on_curve)]
        else:
            points.append((item, here))
    places = empty(len(points))
    for at, (point, here) in enumerate(points):
        _put(point, here, places, at)
    return places, counts


def to_sources(value: Any, offsets: Any, vertex_count: int) -> Sources:
    """One source or many, as Sources.

    Raises:
        InvalidArgument: naming the offender, such as ``sources[2]``.
    """
    name = "sources"
    if isinstance(value, Places):
        items: Any = value
    else:
        items = _as_list(value, name, vertex_count)
    if len(items) == 0:
        raise InvalidArgument("there is no source")
    if isinstance(items, list):
        places, counts = _listed(items, name, vertex_count)
    else:
        places = to_places(items, name, vertex_count)
        counts = np.full(len(items), -1, np.int64)
    if offsets is None:
        offset_array = np.zeros(len(counts))
    else:
        offset_array = np.atleast_1d(
            to_array(offsets, "offsets", np.float64))
        if offset_array.shape != (len(counts),):
            raise InvalidArgument(
                f"offsets have shape {offset_array.shape}, but there are "
                f"{len(counts)} sources")
    return Sources(places, counts, offset_array)
