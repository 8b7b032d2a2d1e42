"""Answers of a service, by its streams (docs/protocol.md)."""

from __future__ import annotations

import contextlib
import functools
import itertools
import math
import re
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple

import grpc
import numpy as np

from . import _core
from .answers import Answer, read
from .backend import (LINE_ENDS, IsolineAnswer, LineAnswer, Options,
                      PathAnswer)
from .calls import Caller, Patience
from .digest import PLAIN, Reading
from .errors import InvalidArgument, NotFound
from .local import LocalBackend, labels_of
from .places import Places, Sources
from .results import Field
from .v1 import (capabilities_service_pb2, capabilities_service_pb2_grpc,
                 mesh_pb2, mesh_service_pb2, mesh_service_pb2_grpc,
                 question_service_pb2, question_service_pb2_grpc)
from .wire import (accuracy, at_once, packed_vertices, pair_fields,
                   place_bytes, row_fields,
                   source_bytes, source_messages, surface_points,
                   target_fields)


class Stubs:
    """The service's stubs on one channel, and how its calls are made: `call` is
    the Caller's."""

    def __init__(self, channel: grpc.Channel, address: str,
                 caller: Caller) -> None:
        self.address = address
        self.meshes = mesh_service_pb2_grpc.MeshServiceStub(channel)
        self.questions = question_service_pb2_grpc.QuestionServiceStub(channel)
        self._capabilities = (
            capabilities_service_pb2_grpc.CapabilitiesServiceStub(channel))
        self.caller = caller
        self.call = caller.call

    def capabilities(self,
                     ) -> capabilities_service_pb2.GetCapabilitiesResponse:
        return self.call(self._capabilities.GetCapabilities,
                         capabilities_service_pb2.GetCapabilitiesRequest())


@contextlib.contextmanager
def _numbered_from(first: int) -> Iterator[None]:
    """Errors name a source or pair of one request by its number among all, of
    which `first` came before."""
    try:
        yield
    except InvalidArgument as error:
        error.args = (re.sub(
            r"\b(sources|pairs)\[(\d+)\]",
            lambda found: f"{found[1]}[{first + int(found[2])}]", str(error)),)
        raise


class RemoteBackend:
    """A mesh of a service. Thread-safe.

    A mesh that the service has dropped meanwhile is sent again, where this
    process knows it.
    """

    def __init__(self, stubs: Stubs, mesh: mesh_pb2.Mesh,
                 arrays: Optional[Tuple[np.ndarray, np.ndarray]],
                 upload: Optional[Callable[[str], mesh_pb2.Mesh]],
                 of_arrays: Callable[[np.ndarray, np.ndarray],
                                     "RemoteBackend"]) -> None:
        self._stubs = stubs
        self._mesh = mesh
        self._arrays = None if arrays is None else (*arrays, PLAIN)
        self._upload = upload
        self._of_arrays = of_arrays
        self.vertex_count: int = mesh.vertex_count
        self.face_count: int = mesh.face_count

    def digest(self) -> str:
        return self._mesh.digest

    def where(self) -> str:
        return "at " + self._stubs.address

    def notes(self) -> List[str]:
        return list(self._mesh.notes)

    def reading(self) -> Reading:
        return self._read()[2] if self._mesh.joined_vertex_count else PLAIN

    def with_faces(self, faces: np.ndarray) -> "RemoteBackend":
        if len(self.reading()[0]):
            raise InvalidArgument(
                "the service takes no arrays with joined vertices: leave faces "
                "out of a mesh of this process")
        return self._of_arrays(self.vertices(), faces)

    def _described(self) -> Any:
        return self._stubs.call(
            self._stubs.meshes.GetMesh,
            mesh_service_pb2.GetMeshRequest(digest=self.digest())).mesh

    def facts(self) -> Dict[str, Any]:
        mesh = self._resident(self._described)

        def point(p):
            return [p.x, p.y, p.z]

        return {
            "vertices": mesh.vertex_count,
            "faces": mesh.face_count,
            "edges": mesh.edge_count,
            "boundary_edges": mesh.boundary_edge_count,
            "boundary_loops": mesh.boundary_loop_count,
            "components": mesh.component_count,
            "isolated_vertices": mesh.isolated_vertex_count,
            "non_manifold_edges": mesh.non_manifold_edge_count,
            "non_manifold_vertices": mesh.non_manifold_vertex_count,
            "inconsistent_edges": mesh.inconsistent_edge_count,
            "is_orientable": mesh.orientable,
            "genus": mesh.genus if mesh.HasField("genus") else None,
            "saddle_vertices": mesh.saddle_vertex_count,
            "degenerate_faces": mesh.degenerate_face_count,
            "left_out_faces": mesh.left_out_face_count,
            "seam_edges": mesh.seam_edge_count,
            "joined_vertices": mesh.joined_vertex_count,
            "close_edges": mesh.close_edge_count,
            "touching_edges": mesh.touching_edge_count,
            "close_edge_distance": mesh.close_edge_distance,
            "bounding_box_min": point(mesh.bounding_box_min),
            "bounding_box_max": point(mesh.bounding_box_max),
            "mean_edge_length": mesh.mean_edge_length,
            "anisotropy": mesh.anisotropy,
            "notes": list(mesh.notes),
        }

    def vertices(self) -> np.ndarray:
        return self._read()[0]

    def faces(self) -> np.ndarray:
        return self._read()[1]

    def isolated(self, vertices: np.ndarray) -> np.ndarray:
        if self._mesh.isolated_vertex_count == 0:
            return np.zeros(len(vertices), bool)
        return self._here.isolated(vertices)

    def positions(self, places: Places) -> np.ndarray:
        return self._here.positions(places)

    @functools.cached_property
    def _here(self) -> LocalBackend:
        """The mesh in this process, which knows where places lie."""
        return LocalBackend(_core.Mesh.restore(*self._read()[:2],
                                               *self._read()[2]))

    def _read(self) -> Tuple[np.ndarray, np.ndarray, Reading]:
        """The arrays and what was joined, from the service where they came as a
        file."""
        if self._arrays is None:
            self._arrays = self._resident(
                lambda: self._stubs.caller.repeat(self._download))
        return self._arrays

    def _download(self, patience: Patience,
                  ) -> Tuple[np.ndarray, np.ndarray, Reading]:
        numbers = (0, 0, 0)
        joined = np.empty((self._mesh.joined_vertex_count, 2), np.uint32)
        positions = np.empty((self.vertex_count, 3))
        faces = np.empty((self.face_count, 3), np.int32)
        request = mesh_service_pb2.ReadMeshRequest(digest=self.digest())
        for response in self._stubs.caller.stream(
                self._stubs.meshes.ReadMesh, request, patience.deadline):
            kind = response.WhichOneof("part")
            if kind == "vertices":
                rows = np.frombuffer(response.vertices.positions,
                                     "<f8").reshape(-1, 3)
                first = response.vertices.first_vertex
                positions[first:first + len(rows)] = rows
            elif kind == "faces":
                rows = np.frombuffer(response.faces.indices,
                                     "<i4").reshape(-1, 3)
                first = response.faces.first_face
                faces[first:first + len(rows)] = rows
            elif kind == "joined":
                rows = np.frombuffer(response.joined.pairs, "<u4").reshape(-1, 2)
                first = response.joined.first_pair
                joined[first:first + len(rows)] = rows
            elif kind == "header":
                header = response.header
                numbers = (header.seam_edge_count,
                           header.crossing_polygon_count,
                           header.first_crossing_polygon)
        positions.setflags(write=False)
        return positions, faces, (joined, numbers)

    def _resident(self, ask: Callable[[], Any]) -> Any:
        """What `ask` returns, which is asked again when the service had dropped
        the mesh."""
        try:
            return ask()
        except NotFound as error:
            if error.reason != "MESH_NOT_RESIDENT" or self._upload is None:
                raise
        self._upload(self.digest())
        return ask()

    def _question(self, name: str, options: Options, radius: float,
                  fields: Dict[str, Any]) -> Tuple[Callable, Any]:
        """The method of that name and its request."""
        request = getattr(question_service_pb2, name + "Request")(
            mesh_digest=self.digest(), **accuracy(options), **fields)
        if radius < math.inf:
            request.radius = radius
        return getattr(self._stubs.questions, name), request

    def _ask(self, name: str, options: Options, fields: Dict[str, Any],
             radius: float = math.inf, first: int = 0, total: int = 0,
             out: Optional[Dict[str, np.ndarray]] = None) -> Answer:
        """The answer to the question of that name, whose arrays go into `out`.
        `total`: the number of rows or pairs, of which `first` are in other
        requests; 0 if the question has none."""

        def report(progress: Any) -> None:
            if options.progress is None:
                return
            if total:
                options.progress(first + progress.items_finished, total)
            else:
                options.progress(progress.vertices_reached, self.vertex_count)

        answer = Answer(report, out)
        question = self._question(name, options, radius, fields)
        with _numbered_from(first):
            self._resident(lambda: read(self._stubs.caller, *question, answer))
        return answer

    def field(self, sources: Sources, targets: Places, radius: float,
              stop_after_targets: Optional[int], labels: bool, gradients: bool,
              certified_errors: bool, options: Options) -> Field:
        quantities = [
            "FIELD_QUANTITY_" + name
            for name, is_asked in (("NEAREST_SOURCE", labels),
                                   ("GRADIENT", gradients),
                                   ("CERTIFIED_ERROR", certified_errors))
            if is_asked]
        answer = self._ask("ComputeField", options, {
            "sources": source_messages(sources), **target_fields(targets),
            "stop_after_targets": stop_after_targets, "quantities": quantities,
        }, radius)
        trailer = answer.trailer
        return Field(
            distances=answer["distance"],
            target_distances=(answer["target_distance"] if len(targets) else
                              np.empty(0)),
            settled_radius=trailer.settled_radius,
            algorithm=answer.algorithm(),
            statistics={
                field.name: getattr(trailer.statistics, field.name)
                for field in trailer.statistics.DESCRIPTOR.fields},
            labels=labels_of(answer["nearest_source"]) if labels else None,
            gradients=answer["gradient"] if gradients else None,
            certified_error=(trailer.certified_error if
                             trailer.HasField("certified_error") else None),
            certified_errors=(answer["certified_error"] if certified_errors
                              else None),
            approximation=answer.approximation())

    def progressive(self, sources: Sources, radius: float, interval: float,
                    options: Options,
                    ) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
        method, request = self._question(
            "ComputeField", options, radius,
            {"sources": source_messages(sources), "progressive": True})
        caller = self._stubs.caller

        def begin(patience: Patience) -> Tuple[Any, Iterator[Any]]:
            messages = caller.stream(method, request, patience.deadline)
            return next(messages), messages

        first, rest = self._resident(lambda: caller.repeat(begin))
        answer = Answer()
        given = 0
        for message in itertools.chain([first], rest):
            answer.add(message)
            vertices = answer["settled_vertex"]
            distances = answer["settled_distance"]
            come = min(len(vertices), len(distances))
            if come > given:
                yield (vertices[given:come].astype(np.int64),
                       distances[given:come])
                given = come
        answer.check()

    def paths(self, sources: Sources, targets: Places, radius: float,
              options: Options) -> List[PathAnswer]:
        answer = self._ask("ComputePaths", options, {
            "sources": source_messages(sources), **target_fields(targets)}, radius)
        return [
            PathAnswer(*line, distance, length, source)
            for line, distance, length, source in zip(
                answer.lines(), answer["distance"].tolist(),
                answer["length"].tolist(), answer["source"].tolist())
        ]

    def trace(self, sources: Places, directions: np.ndarray,
              lengths: np.ndarray, options: Options) -> List[LineAnswer]:
        count = max(len(sources), len(directions), len(lengths))
        packed = packed_vertices(sources)
        answer = self._ask("TraceLines", options, {
            **({"vertex_sources": packed} if packed else
               {"sources": list(surface_points(sources))}),
            ("angles" if directions.ndim == 1 else
             "vectors"): directions.ravel().tolist(),
            "lengths": lengths.tolist()}, total=count)
        return [
            LineAnswer(*line, length, LINE_ENDS[end])
            for line, length, end in zip(answer.lines(),
                                         answer["length"].tolist(),
                                         answer["end"].tolist())
        ]

    def isolines(self, sources: Sources, levels: List[float],
                 chord_error: float, options: Options) -> List[IsolineAnswer]:
        answer = self._ask("ComputeIsolines", options, {
            "sources": source_messages(sources), "levels": levels,
            "chord_error": chord_error})
        return [
            IsolineAnswer(level, closed != 0, *line)
            for line, level, closed in zip(
                answer.lines(), answer["level"].tolist(),
                answer["is_closed"].tolist())
        ]

    def _rows_at_once(self, sources: Sources,
                      targets: Optional[Places]) -> int:
        """How many rows of a matrix one request takes."""
        if len(sources) == 1 or np.any(sources.counts >= 0):
            return len(sources)  # curves have more points than rows
        limits = self._stubs.capabilities().limits
        columns = self.vertex_count if targets is None else len(targets)
        beside = 0 if targets is None else columns * place_bytes(targets)
        return at_once(
            limits,
            min(limits.max_matrix_rows, limits.max_matrix_values // columns),
            source_bytes(sources), beside)

    def _rows(self, name: str, sources: Sources, targets: Optional[Places],
              radius: float, options: Options, fields: Dict[str, Any],
              out: Optional[np.ndarray] = None) -> Iterator[Answer]:
        """The answers to requests of some rows each. The distances of rows that
        are dense go into `out`."""
        total = len(sources)
        step = self._rows_at_once(sources, targets)
        fields = {**target_fields(targets), **fields}
        for first in range(0, total, step):
            some = slice(first, first + step)
            block = sources if step == total else Sources(
                sources.places[some], sources.counts[some],
                sources.offsets[some])
            yield self._ask(name, options, {**row_fields(block), **fields},
                            radius, first, total,
                            None if out is None else {"distance": out[some]})

    def fill_matrix(self, sources: Sources, targets: Optional[Places],
                    radius: float, out: np.ndarray, options: Options) -> None:
        for _ in self._rows(
                "ComputeMatrix", sources, targets, radius, options,
                {"value_type": "VALUE_TYPE_" + out.dtype.name.upper()}, out):
            pass

    def sparse_matrix(self, sources: Sources, targets: Optional[Places],
                      radius: float, nearest: Optional[int], options: Options,
                      ) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        if nearest is None:
            rows = self._rows("ComputeMatrix", sources, targets, radius, options,
                              {"layout": "MATRIX_LAYOUT_SPARSE"})
        else:
            rows = self._rows("FindNearest", sources, targets, radius, options,
                              {"count": nearest})
        columns = "column" if nearest is None else "target"
        parts = [
            (np.diff(answer["row_end"].astype(np.int64), prepend=0),
             answer[columns].view(np.int32), answer["distance"])
            for answer in rows]
        counts, found, distances = map(np.concatenate, zip(*parts))
        return counts, found, distances

    def pairs(self, sources: Places, targets: Places,
              options: Options) -> np.ndarray:
        total = step = len(sources)
        if total > 1:
            limits = self._stubs.capabilities().limits
            step = at_once(limits, limits.max_pairs,
                           2 * max(place_bytes(sources), place_bytes(targets)))
        distances = np.empty(total)
        for first in range(0, total, step):
            some = slice(first, first + step)
            self._ask("ComputePairs", options,
                      pair_fields(sources[some], targets[some]), first=first,
                      total=total, out={"distance": distances[some]})
        return distances

    def samples(self, sources: Sources, count: int, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        answer = self._ask("SampleFarthestPoints", options, {
            "sources": source_messages(sources), "count": count})
        return answer["vertex"].astype(np.int64), answer["distance"]

    def log_map(self, sources: Sources, radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        if len(sources) != 1 or sources.counts[0] >= 0:
            raise InvalidArgument("a log map has one source, which is a point")
        answer = self._ask("ComputeLogMap", options, {
            "source": next(iter(surface_points(sources.places)))}, radius)
        return answer["coordinates"], answer["zero_direction"]
