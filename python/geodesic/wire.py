"""Requests as the service's messages (docs/protocol.md)."""

from __future__ import annotations

from typing import Any, Dict, Iterable, List, Optional

import numpy as np

from .backend import Options
from .places import Places, Sources
from .v1 import (capabilities_service_pb2, query_pb2, question_service_pb2,
                 surface_pb2)

# The most bytes of each in a request, and of the rest of it.
_PLACE_BYTES = 48
_SOURCE_BYTES = 64
_VERTEX_BYTES = 4
_REQUEST_BYTES = 256


def surface_points(places: Places) -> Iterable[surface_pb2.SurfacePoint]:
    """A message for each place."""
    for kind, numbers, weights in zip(places.kinds.tolist(),
                                      places.numbers.tolist(),
                                      places.weights.tolist()):
        if kind == 0:
            yield surface_pb2.SurfacePoint(vertex=numbers[0])
        elif kind == 1:
            edge = surface_pb2.EdgePoint(to=numbers[1], t=weights[0])
            setattr(edge, "from", numbers[0])  # a word of Python's own
            yield surface_pb2.SurfacePoint(edge=edge)
        else:
            yield surface_pb2.SurfacePoint(
                face=surface_pb2.FacePoint(face=numbers[0], weights=weights))


def packed_vertices(places: Places) -> List[int]:
    """The numbers of places, if all are vertices that 32 bits hold; else none."""
    numbers = places.numbers[:, 0]
    if np.any(places.kinds) or np.any((numbers < 0) | (numbers > 0xffffffff)):
        return []
    return numbers.tolist()


def packed_sources(sources: Sources) -> List[int]:
    """The same for sources, which then have no offset."""
    if np.any(sources.counts >= 0) or np.any(sources.offsets):
        return []
    return packed_vertices(sources.places)


def target_fields(targets: Optional[Places]) -> Dict[str, Any]:
    """The fields of a request for its targets; vertices in the short form."""
    if targets is None:
        return {}
    packed = packed_vertices(targets)
    if packed:
        return {"vertex_targets": packed}
    return {"targets": list(surface_points(targets))}


def row_fields(sources: Sources) -> Dict[str, Any]:
    """The fields of a request for the rows of a matrix, in the same way."""
    packed = packed_sources(sources)
    if packed:
        return {"vertex_sources": packed}
    return {"sources": source_messages(sources)}


def pair_fields(sources: Places, targets: Places) -> Dict[str, Any]:
    """The fields of a request for its pairs, in the same way."""
    starts, ends = packed_vertices(sources), packed_vertices(targets)
    if starts and ends:
        return {"vertex_pairs": np.column_stack([starts, ends]).ravel().tolist()}
    return {"pairs": [
        question_service_pb2.PointPair(source=source, target=target)
        for source, target in zip(surface_points(sources),
                                  surface_points(targets))]}


def place_bytes(places: Places) -> int:
    """The most that one of them takes in a request."""
    return _VERTEX_BYTES if packed_vertices(places) else _PLACE_BYTES


def source_bytes(sources: Sources) -> int:
    """The most that one of them takes as a row of a request."""
    return _VERTEX_BYTES if packed_sources(sources) else _SOURCE_BYTES


def at_once(limits: capabilities_service_pb2.Limits, most: int, each: int,
            others: int = 0) -> int:
    """How many of a list one request takes: `most`, if they have `each` bytes and
    stand beside `others`."""
    room = limits.max_message_bytes - _REQUEST_BYTES - others
    return max(1, min(most, room // each))


def source_messages(sources: Sources) -> List[surface_pb2.Source]:
    """A message for each source."""
    points = iter(surface_points(sources.places))
    messages = []
    for count, offset in zip(sources.counts.tolist(),
                             sources.offsets.tolist()):
        message = surface_pb2.Source(offset=offset)
        if count >= 0:
            message.curve.points.extend(next(points) for _ in range(count))
            message.curve.SetInParent()
        else:
            point = next(points)
            kind = point.WhichOneof("place")
            if kind == "vertex":
                message.vertex = point.vertex
            else:
                getattr(message, kind).CopyFrom(getattr(point, kind))
        messages.append(message)
    return messages


def accuracy(options: Options) -> Dict[str, Any]:
    """The fields of a request for how it is to be answered."""
    fields: Dict[str, Any] = {}
    approximate = options.approximate
    name = options.exact if approximate is None else approximate.name
    if name is not None:
        fields["algorithm"] = "ALGORITHM_" + name.upper().replace("-", "_")
    if approximate is not None:
        fields["approximation"] = query_pb2.Approximation(
            neighbours=approximate.neighbours, samples=approximate.samples,
            **{"lambda": approximate.lambda_})
    elif options.tolerance != 0:
        fields["tolerance"] = options.tolerance
    return fields
