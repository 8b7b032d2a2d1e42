"""Answers in this process: the core, through the extension `_core`."""

from __future__ import annotations

import dataclasses
import math
import threading
from concurrent import futures
from typing import Any, Dict, Iterator, List, Optional, Tuple

import numpy as np

from . import _core
from .approximate import Approximate
from .backend import IsolineAnswer, LineAnswer, Options, PathAnswer
from .digest import Reading, mesh_digest
from .errors import InvalidArgument
from .places import Places, Sources, empty
from .results import Field

_ALL_TARGETS = 2**64 - 1
_NO_SOURCE = 2**32 - 1


def _core_places(places: Places) -> _core.Places:
    return _core.Places(places.kinds, places.numbers, places.weights)


def _places(places: _core.Places) -> Places:
    return Places(places.kinds, places.numbers, places.weights)


def labels_of(numbers: np.ndarray) -> np.ndarray:
    """Numbers of sources as int32, -1 where there is none; no copy."""
    return numbers.view(np.int32)


# What approximate algorithms have prepared of a mesh: so many of them are kept.
_METHODS_OF_A_MESH = 4


class LocalBackend:
    """A mesh in this process. Thread-safe: nothing of it changes but for what
    approximate algorithms have prepared."""

    def __init__(self, mesh: _core.Mesh) -> None:
        self._mesh = mesh
        self._lock = threading.Lock()
        self._methods: Dict[Approximate, _core.Method] = {}  # latest last
        self.vertex_count: int = mesh.vertex_count
        self.face_count: int = mesh.face_count

    def vertices(self) -> np.ndarray:
        return self._mesh.positions

    def faces(self) -> np.ndarray:
        return self._mesh.triangles()

    def facts(self) -> Dict[str, Any]:
        return self._mesh.facts()

    def isolated(self, vertices: np.ndarray) -> np.ndarray:
        return self._mesh.isolated(vertices.astype(np.int64))

    def digest(self) -> str:
        return mesh_digest(self.vertices(), self.faces(), self.reading())

    def reading(self) -> Reading:
        return self._mesh.reading()

    def notes(self) -> List[str]:
        return self._mesh.notes()

    def where(self) -> str:
        return "in this process"

    def with_faces(self, faces: np.ndarray) -> "LocalBackend":
        return LocalBackend(
            _core.Mesh.restore(self.vertices(), faces, *self.reading()))

    def positions(self, places: Places) -> np.ndarray:
        return self._mesh.positions_of(_core_places(places))

    def _query(self, sources: Sources, targets: Optional[Places],
               options: Options, trace: bool = False) -> _core.Query:
        return _core.Query(
            self._mesh,
            _core.Sources(_core_places(sources.places), sources.counts,
                          sources.offsets),
            _core_places(empty(0) if targets is None else targets),
            options.exact or _core.ALGORITHMS[0][0], trace,
            options.tolerance)

    def _method(self, wanted: Approximate, options: Options) -> _core.Method:
        """Prepares it if need be. Several threads may do so at once; the last
        one's is kept."""
        key = wanted.complete()
        with self._lock:
            method = self._methods.pop(key, None)
            if method is not None:
                self._methods[key] = method
                return method
        method = _core.Method(self._mesh, key.name, key.neighbours or 0,
                              key.samples or 0, options.threads,
                              options.progress)
        with self._lock:
            self._methods[key] = method
            while len(self._methods) > _METHODS_OF_A_MESH:
                del self._methods[next(iter(self._methods))]
        return method

    def _approximate_field(self, wanted: Approximate, sources: Sources,
                           targets: Places, radius: float,
                           options: Options) -> Field:
        distances, seconds = self._method(wanted, options).distances(
            self._query(sources, None, options), options.progress)
        distances[distances > radius] = np.inf
        return Field(
            distances=distances,
            target_distances=distances[targets.numbers[:, 0]],
            labels=None,
            gradients=None,
            settled_radius=0,
            algorithm=wanted.name,
            statistics={"solve_seconds": seconds},
            approximation=wanted.complete())

    def _approximate_rows(self, wanted: Approximate, sources: Sources,
                          targets: Optional[Places], radius: float,
                          options: Options) -> Iterator[np.ndarray]:
        """The values of each row."""
        if np.any(sources.counts >= 0):
            raise InvalidArgument(
                f"sources: {wanted.name} is approximate and takes no curves")
        self._method(wanted, options)
        report = options.progress
        quiet = dataclasses.replace(options, progress=None)

        def row(i: int) -> np.ndarray:
            source = Sources(sources.places[i:i + 1], sources.counts[i:i + 1],
                             sources.offsets[i:i + 1])
            distances = self._approximate_field(wanted, source, empty(0),
                                                radius, quiet).distances
            return (distances if targets is None else
                    distances[targets.numbers[:, 0]])

        count = len(sources)
        # No more at once than there are threads: a row may be long.
        with futures.ThreadPoolExecutor(options.threads) as pool:
            for first in range(0, count, options.threads):
                last = min(first + options.threads, count)
                yield from pool.map(row, range(first, last))
                if report is not None:
                    report(last, count)

    def field(self, sources: Sources, targets: Places, radius: float,
              stop_after_targets: Optional[int], labels: bool, gradients: bool,
              certified_errors: bool, options: Options) -> Field:
        if options.approximate is not None:
            return self._approximate_field(options.approximate, sources,
                                           targets, radius, options)
        query = self._query(sources, targets, options, labels or gradients)
        stop = _ALL_TARGETS if stop_after_targets is None else stop_after_targets
        field = _core.solve(query, radius, stop, options.threads,
                            options.progress)
        return Field(
            settled_radius=field.settled_radius,
            algorithm=field.algorithm,
            statistics=field.statistics(),
            labels=labels_of(field.nearest_sources()) if labels else None,
            gradients=field.gradients() if gradients else None,
            # 0: exact.
            certified_error=field.certified_error or None,
            certified_errors=(field.certified_errors() if certified_errors
                              else None),
            # Last: then the field has them no more.
            distances=field.take_distances(),
            target_distances=field.take_target_distances())

    def progressive(self, sources: Sources, radius: float, interval: float,
                    options: Options,
                    ) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
        progression = _core.Progression(self._query(sources, None, options),
                                        radius, options.threads)
        while (settled := progression.next(interval)) is not None:
            yield settled

    def paths(self, sources: Sources, targets: Places, radius: float,
              options: Options) -> List[PathAnswer]:
        query = self._query(sources, targets, options, trace=True)
        found = _core.paths(query, radius, options.threads, options.progress)
        return [
            PathAnswer(_places(places), points, distance, length, source)
            for places, points, distance, length, source in found
        ]

    def isolines(self, sources: Sources, levels: List[float],
                 chord_error: float, options: Options) -> List[IsolineAnswer]:
        found = _core.isolines(self._query(sources, None, options), levels,
                               chord_error, options.threads, options.progress)
        return [
            IsolineAnswer(level, closed, _places(places), points)
            for level, closed, places, points in found
        ]

    def trace(self, sources: Places, directions: np.ndarray,
              lengths: np.ndarray, options: Options) -> List[LineAnswer]:
        found = _core.trace(self._mesh, _core_places(sources), directions,
                            lengths.tolist(), options.threads, options.progress)
        return [
            LineAnswer(_places(places), points, length, end)
            for places, points, length, end in found
        ]

    def fill_matrix(self, sources: Sources, targets: Optional[Places],
                    radius: float, out: np.ndarray, options: Options) -> None:
        if options.approximate is not None:
            for i, row in enumerate(self._approximate_rows(
                    options.approximate, sources, targets, radius, options)):
                out[i] = row
            return
        _core.fill_matrix(self._query(sources, targets, options), radius,
                          options.threads, options.progress, out)

    def sparse_matrix(self, sources: Sources, targets: Optional[Places],
                      radius: float, options: Options,
                      ) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        if options.approximate is not None:
            counts, columns, values = [], [], []
            for row in self._approximate_rows(
                    options.approximate, sources, targets, radius, options):
                finite = np.flatnonzero(np.isfinite(row))
                counts.append(len(finite))
                columns.append(finite.astype(np.int32))
                values.append(row[finite])
            return (np.array(counts, np.int64), np.concatenate(columns),
                    np.concatenate(values))
        return _core.sparse_matrix(self._query(sources, targets, options),
                                   radius, options.threads, options.progress)

    def nearest(self, sources: Sources, targets: Places, count: int,
                radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        if options.approximate is not None:
            numbers = np.full((len(sources), count), -1, np.int64)
            distances = np.full((len(sources), count), np.inf)
            for i, row in enumerate(self._approximate_rows(
                    options.approximate, sources, targets, radius, options)):
                order = np.argsort(row, kind="stable")[:count]
                order = order[np.isfinite(row[order])]
                numbers[i, :len(order)] = order
                distances[i, :len(order)] = row[order]
            return numbers, distances
        return _core.nearest(self._query(sources, targets, options), count,
                             radius, options.threads, options.progress)

    def pairs(self, sources: Places, targets: Places,
              options: Options) -> np.ndarray:
        if options.approximate is not None:
            return self._approximate_pairs(options.approximate, sources,
                                           targets, options)
        order, ends = _groups(sources)
        backward, backward_ends = _groups(targets)
        # Distances are the same both ways, so the end that is shared by more
        # pairs is the one to start from.
        if len(backward_ends) < len(ends):
            sources, targets = targets, sources
            order, ends = backward, backward_ends
        count = len(sources)
        points = Sources(sources, np.full(count, -1), np.zeros(count))
        return _core.pairs(self._query(points, targets, options), order, ends,
                           options.tolerance, options.threads, options.progress)

    def _approximate_pairs(self, wanted: Approximate, sources: Places,
                           targets: Places, options: Options) -> np.ndarray:
        ends = targets.numbers[:, 0]
        found = self._method(wanted, options).pairs(
            sources.numbers[:, 0], ends, options.progress)
        if found is not None:
            return found
        # A field from each source answers all its pairs.
        order, groups = _groups(sources)
        pairs_of_source = np.split(order, groups[:-1])
        count = len(pairs_of_source)
        points = empty(count)
        points.numbers[:, 0] = [sources.numbers[pairs[0], 0]
                                for pairs in pairs_of_source]
        rows = self._approximate_rows(
            wanted, Sources(points, np.full(count, -1), np.zeros(count)), None,
            math.inf, options)
        distances = np.empty(len(sources))
        for pairs, row in zip(pairs_of_source, rows):
            distances[pairs] = row[ends[pairs]]
        return distances

    def samples(self, sources: Sources, count: int, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        return _core.samples(self._query(sources, None, options), count,
                             options.threads, options.progress)

    def log_map(self, sources: Sources, radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        field = _core.solve(self._query(sources, None, options, trace=True),
                            radius, _ALL_TARGETS, options.threads,
                            options.progress)
        coordinates, zero_direction = field.log_map(radius)
        return coordinates, np.array(zero_direction)


def _groups(places: Places) -> Tuple[np.ndarray, np.ndarray]:
    """An order in which equal places stand together, and where each group
    ends."""
    columns = [places.kinds, *places.numbers.T, *places.weights.T]
    # Where all are vertices, one column tells.
    columns = [column for column in columns if np.any(column != column[0])]
    if not columns:
        return np.arange(len(places)), np.array([len(places)])
    order = np.lexsort(columns)
    changes = np.zeros(len(places) - 1, bool)
    for column in columns:
        changes |= np.diff(column[order].astype(np.float64)) != 0
    return order, np.append(np.flatnonzero(changes) + 1, len(places))
