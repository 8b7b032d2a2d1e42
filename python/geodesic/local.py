"""Answers in this process: the core, through the extension `_core`."""

from __future__ import annotations

import threading
from typing import Any, Dict, Iterator, List, Optional, Tuple

import numpy as np

from . import _core
from .approximate import Approximate
from .backend import IsolineAnswer, LineAnswer, Options, PathAnswer
from .digest import Reading, mesh_digest
from .places import Places, Sources, empty
from .results import Field

_ALL_TARGETS = 2**64 - 1


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

    def _method_of(self, options: Options) -> Optional[_core.Method]:
        if options.approximate is None:
            return None
        return self._method(options.approximate, options)

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
        _core.fill_matrix(self._query(sources, targets, options), radius,
                          self._method_of(options), options.threads,
                          options.progress, out)

    def sparse_matrix(self, sources: Sources, targets: Optional[Places],
                      radius: float, nearest: Optional[int], options: Options,
                      ) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        return _core.sparse_matrix(
            self._query(sources, targets, options), radius, nearest,
            self._method_of(options), options.threads, options.progress)

    def pairs(self, sources: Places, targets: Places,
              options: Options) -> np.ndarray:
        starts, ends = _core_places(sources), _core_places(targets)
        method = self._method_of(options)
        return _core.pairs(self._mesh, starts, ends, method, options.tolerance,
                           options.threads, options.progress)

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
