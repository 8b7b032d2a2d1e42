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
from .approximate import Approximate
from .backend import FieldAnswer, IsolineAnswer, Options, PathAnswer
from .calls import Caller, Patience
from .digest import PLAIN, Reading
from .errors import (InternalError, InvalidArgument, NotFound,
                     ResourceExhausted, Unavailable)
from .local import LocalBackend
from .places import Places, Sources
from .v1 import (capabilities_service_pb2, capabilities_service_pb2_grpc,
                 field_service_pb2, field_service_pb2_grpc, matrix_service_pb2,
                 matrix_service_pb2_grpc, mesh_pb2, mesh_service_pb2,
                 mesh_service_pb2_grpc, pair_service_pb2,
                 pair_service_pb2_grpc, path_service_pb2,
                 path_service_pb2_grpc, query_pb2)
from .wire import (Polyline, packed_sources, packed_vertices, row_fields,
                   source_messages, surface_points, target_fields)

# The most bytes of each on the wire, and of the rest of a request.
_PLACE_BYTES = 48
_SOURCE_BYTES = 64
_VERTEX_BYTES = 4
_REQUEST_BYTES = 256


class Stubs:
    """The service's stubs on one channel, and how its calls are made: `call` and
    `stream` are the Caller's."""

    def __init__(self, channel: grpc.Channel, address: str,
                 caller: Caller) -> None:
        self.address = address
        self.meshes = mesh_service_pb2_grpc.MeshServiceStub(channel)
        self.fields = field_service_pb2_grpc.FieldServiceStub(channel)
        self.paths = path_service_pb2_grpc.PathServiceStub(channel)
        self.matrices = matrix_service_pb2_grpc.MatrixServiceStub(channel)
        self.pairs = pair_service_pb2_grpc.PairServiceStub(channel)
        self._capabilities = (
            capabilities_service_pb2_grpc.CapabilitiesServiceStub(channel))
        self.caller = caller
        self.call = caller.call
        self.stream = caller.stream

    def capabilities(self,
                     ) -> capabilities_service_pb2.GetCapabilitiesResponse:
        return self.call(self._capabilities.GetCapabilities,
                         capabilities_service_pb2.GetCapabilitiesRequest())

    def parts(self, method: Callable, request: Any, **options: Any,
              ) -> Iterator[Tuple[str, Any]]:
        """The same as (name, part) of a stream that ends with a trailer; options
        as in Caller.stream()."""
        is_whole = False
        for response in self.stream(method, request, **options):
            name = response.WhichOneof("part")
            if name is None:
                continue  # from a newer server
            is_whole = name == "trailer"
            yield name, getattr(response, name)
        if not is_whole:
            raise InternalError("the stream ended without a trailer")


def _algorithm(options: Options) -> int:
    name = (options.exact if options.approximate is None else
            options.approximate.name)
    if name is None:
        return query_pb2.ALGORITHM_UNSPECIFIED
    return query_pb2.Algorithm.Value("ALGORITHM_" +
                                     name.upper().replace("-", "_"))


def _algorithm_name(number: int) -> str:
    return query_pb2.Algorithm.Name(number)[len("ALGORITHM_"):].lower().replace(
        "_", "-")


def _accuracy(options: Options) -> Dict[str, Any]:
    """The members of a request that say it, if it is to have some."""
    if options.approximate is not None:
        return {"approximation": query_pb2.Approximation(
            neighbours=options.approximate.neighbours,
            samples=options.approximate.samples,
            **{"lambda": options.approximate.lambda_})}
    return {"tolerance": options.tolerance} if options.tolerance != 0 else {}


def _approximation(header: Any) -> Optional[Approximate]:
    """What a header says of it; None where distances are not approximate."""
    if not header.HasField("approximation"):
        return None

    def used(name: str) -> Any:
        told = header.approximation
        return getattr(told, name) if told.HasField(name) else None

    return Approximate(_algorithm_name(header.algorithm), used("neighbours"),
                       used("lambda"), used("samples"))


def _statistics(message: query_pb2.SolveStatistics) -> Dict[str, Any]:
    return {
        field.name: getattr(message, field.name)
        for field in message.DESCRIPTOR.fields
    }


def _at_once(limits: capabilities_service_pb2.Limits, most: int, each: int,
             others: int = 0) -> int:
    """How many of a list one request takes: `most`, if they have `each` bytes and
    stand beside `others`."""
    room = limits.max_message_bytes - _REQUEST_BYTES - others
    return max(1, min(most, room // each))


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


class _FieldReader:
    """Puts a field together, over as many streams as it takes."""

    def __init__(self, options: Options) -> None:
        self._options = options
        self.vertex_count = 0
        self.algorithm = 0
        self.first_missing = 0
        self.field_id = ""
        self.has_targets = False
        self.distances = np.empty(0)
        self.labels: Optional[np.ndarray] = None
        self.gradients: Optional[np.ndarray] = None
        self.certified_errors: Optional[np.ndarray] = None
        self.target_distances = np.empty(0)
        self.approximation: Optional[Approximate] = None
        self.trailer: Any = None

    def begin_again(self) -> None:
        self.first_missing, self.field_id = 0, ""

    def add(self, name: str, part: Any) -> None:
        if name == "header":
            if self.vertex_count != part.vertex_count:
                self.vertex_count = part.vertex_count
                self.distances = np.full(part.vertex_count, np.inf)
            self.target_distances = np.full(part.target_count, np.inf)
            self.algorithm = part.algorithm
            self.approximation = _approximation(part)
        elif name == "progress" and self._options.progress is not None:
            self._options.progress(part.vertices_reached, self.vertex_count)
        elif name == "chunk":
            self._add_chunk(part)
        elif name == "targets":
            values = np.frombuffer(part.distances, "<f8")
            self.target_distances[part.offset:part.offset + len(values)] = values
        elif name == "trailer":
            self.trailer = part

    def _add_chunk(self, chunk: Any) -> None:
        if chunk.field_id:
            self.field_id = chunk.field_id
        if chunk.offset != self.first_missing:
            raise InternalError(f"the field goes on at vertex {chunk.offset}, "
                                f"not at {self.first_missing}")
        values = np.frombuffer(chunk.distances, "<f8")
        span = slice(chunk.offset, chunk.offset + len(values))
        self.distances[span] = values
        if chunk.nearest_sources:
            if self.labels is None:
                self.labels = np.full(self.vertex_count, -1, np.int32)
            self.labels[span] = np.frombuffer(chunk.nearest_sources, "<i4")
        if chunk.gradients:
            if self.gradients is None:
                self.gradients = np.zeros((self.vertex_count, 3))
            self.gradients[span] = np.frombuffer(chunk.gradients,
                                                 "<f8").reshape(-1, 3)
        if chunk.certified_errors:
            if self.certified_errors is None:
                self.certified_errors = np.zeros(self.vertex_count, np.float32)
            self.certified_errors[span] = np.frombuffer(chunk.certified_errors,
                                                        "<f4")
        self.first_missing = span.stop


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
            self._arrays = self._resident(self._download)
        return self._arrays

    def _download(self) -> Tuple[np.ndarray, np.ndarray, Reading]:
        numbers = (0, 0, 0)
        joined = np.empty((self._mesh.joined_vertex_count, 2), np.uint32)
        positions = np.empty((self.vertex_count, 3))
        faces = np.empty((self.face_count, 3), np.int32)
        request = mesh_service_pb2.ReadMeshRequest(digest=self.digest())
        for response in self._stubs.stream(self._stubs.meshes.ReadMesh,
                                           request):
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

    def _answer(self, method: Callable, request: Any, options: Options,
                ) -> List[Tuple[str, Any]]:
        """The parts of an answer; reports the solver's progress."""

        def ask():
            found = []
            for name, part in self._stubs.parts(method, request):
                if name != "progress":
                    found.append((name, part))
                elif options.progress is not None:
                    options.progress(part.vertices_reached, self.vertex_count)
            return found

        return self._resident(ask)

    def _field_request(self, sources: Sources, radius: float,
                       options: Options, **targets: Any) -> Any:
        request = field_service_pb2.ComputeFieldRequest(
            mesh_digest=self.digest(),
            sources=source_messages(sources),
            algorithm=_algorithm(options),
            **targets, **_accuracy(options))
        if radius < math.inf:
            request.radius = radius
        return request

    def field(self, sources: Sources, targets: Places, radius: float,
              stop_after_targets: Optional[int], labels: bool, gradients: bool,
              certified_errors: bool, options: Options) -> FieldAnswer:
        request = self._field_request(sources, radius, options,
                                      **target_fields(targets))
        if stop_after_targets is not None:
            request.stop_after_targets = stop_after_targets
        if labels:
            request.quantities.append(
                field_service_pb2.FIELD_QUANTITY_NEAREST_SOURCE)
        if gradients:
            request.quantities.append(
                field_service_pb2.FIELD_QUANTITY_GRADIENT)
        if certified_errors:
            request.quantities.append(
                field_service_pb2.FIELD_QUANTITY_CERTIFIED_ERROR)
        reader = _FieldReader(options)
        self._resident(lambda: self._read_field(request, reader))
        return FieldAnswer(
            distances=reader.distances,
            target_distances=reader.target_distances,
            settled_radius=reader.trailer.settled_radius,
            algorithm=_algorithm_name(reader.algorithm),
            statistics=_statistics(reader.trailer.statistics),
            labels=reader.labels,
            gradients=reader.gradients,
            certified_error=(reader.trailer.certified_error if
                             reader.trailer.HasField("certified_error") else
                             None),
            certified_errors=reader.certified_errors,
            approximation=reader.approximation)

    def _read_field(self, request: Any, reader: _FieldReader) -> None:
        """Reads on where a stream breaks."""
        deadline = self._stubs.caller.deadline()
        patience = Patience(deadline)
        while reader.trailer is None:
            before = reader.first_missing
            if reader.field_id:
                request.resumption.field_id = reader.field_id
                request.resumption.first_vertex = reader.first_missing
            else:
                request.ClearField("resumption")
            try:
                for name, part in self._stubs.parts(
                        self._stubs.fields.ComputeField, request,
                        repeat=False, deadline=deadline):
                    reader.add(name, part)
            except (Unavailable, ResourceExhausted) as error:
                if reader.first_missing > before:
                    patience.begin_again()
                patience.pause(error)
            except NotFound as error:
                if error.reason != "FIELD_NOT_KEPT":
                    raise
                reader.begin_again()

    def progressive(self, sources: Sources, radius: float, interval: float,
                    options: Options,
                    ) -> Iterator[Tuple[np.ndarray, np.ndarray]]:
        request = self._field_request(sources, radius, options)
        request.progressive = True

        def begin():
            parts = self._stubs.parts(self._stubs.fields.ComputeField, request)
            return next(parts), parts

        first, rest = self._resident(begin)
        for name, part in itertools.chain([first], rest):
            if name == "settled":
                yield (np.frombuffer(part.vertices, "<u4").astype(np.int64),
                       np.frombuffer(part.distances, "<f8"))

    def paths(self, sources: Sources, targets: Places, radius: float,
              options: Options) -> List[PathAnswer]:
        request = path_service_pb2.ComputePathsRequest(
            mesh_digest=self.digest(),
            sources=source_messages(sources),
            **target_fields(targets),
            algorithm=_algorithm(options))
        if radius < math.inf:
            request.radius = radius
        answers = []
        polyline = Polyline()
        for name, part in self._answer(self._stubs.paths.ComputePaths, request,
                                       options):
            if name == "path" and polyline.add(part.piece):
                answers.append(
                    PathAnswer(polyline.places(), polyline.positions(),
                               part.distance, part.length, part.source))
                polyline = Polyline()
        return answers

    def isolines(self, sources: Sources, levels: List[float],
                 chord_error: float, options: Options) -> List[IsolineAnswer]:
        request = path_service_pb2.ComputeIsolinesRequest(
            mesh_digest=self.digest(),
            sources=source_messages(sources),
            levels=levels,
            chord_error=chord_error,
            algorithm=_algorithm(options),
            **_accuracy(options))
        answers = []
        polyline = Polyline()
        for name, part in self._answer(self._stubs.paths.ComputeIsolines,
                                       request, options):
            if name == "isoline" and polyline.add(part.piece):
                answers.append(
                    IsolineAnswer(part.level, part.is_closed,
                                  polyline.places(), polyline.positions()))
                polyline = Polyline()
        return answers

    def _rows_at_once(self, sources: Sources,
                      targets: Optional[Places]) -> int:
        """How many rows of a matrix one request takes."""
        if len(sources) == 1 or np.any(sources.counts >= 0):
            return len(sources)  # curves have more points than rows
        limits = self._stubs.capabilities().limits
        columns = self.vertex_count if targets is None else len(targets)
        beside = 0
        if targets is not None:
            each = _VERTEX_BYTES if packed_vertices(targets) else _PLACE_BYTES
            beside = len(targets) * each
        return _at_once(
            limits,
            min(limits.max_matrix_rows, limits.max_matrix_values // columns),
            _VERTEX_BYTES if packed_sources(sources) else _SOURCE_BYTES, beside)

    def _rows(self, method: Callable, make: Callable, sources: Sources,
              targets: Optional[Places], options: Options,
              ) -> Iterator[Tuple[int, Any]]:
        """(row, chunk) of a matrix, by requests of some rows each."""
        total = len(sources)
        at_once = self._rows_at_once(sources, targets)
        for first in range(0, total, at_once):
            some = slice(first, first + at_once)
            block = sources if at_once == total else Sources(
                sources.places[some], sources.counts[some],
                sources.offsets[some])
            request = make(row_fields(block))
            with _numbered_from(first):
                for name, part in self._stubs.parts(method, request):
                    if name == "chunk":
                        yield first + part.row, part
                    elif name == "progress" and options.progress is not None:
                        options.progress(first + part.rows_finished, total)

    def _matrix_rows(self, sources, targets, radius, dtype, layout, options):
        columns = target_fields(targets)
        value_type = (query_pb2.VALUE_TYPE_FLOAT32 if dtype == np.float32 else
                      query_pb2.VALUE_TYPE_FLOAT64)

        def make(rows):
            request = matrix_service_pb2.ComputeMatrixRequest(
                mesh_digest=self.digest(), algorithm=_algorithm(options),
                value_type=value_type, layout=layout, **rows, **columns,
                **_accuracy(options))
            if radius < math.inf:
                request.radius = radius
            return request

        return self._rows(self._stubs.matrices.ComputeMatrix, make, sources,
                          targets, options)

    def fill_matrix(self, sources: Sources, targets: Optional[Places],
                    radius: float, out: np.ndarray, options: Options) -> None:
        kind = out.dtype.newbyteorder("<")

        def fill():
            for row, chunk in self._matrix_rows(
                    sources, targets, radius, out.dtype,
                    matrix_service_pb2.MATRIX_LAYOUT_DENSE, options):
                values = np.frombuffer(chunk.values, kind)
                out[row, chunk.offset:chunk.offset + len(values)] = values

        self._resident(fill)

    def sparse_matrix(self, sources: Sources, targets: Optional[Places],
                      radius: float, options: Options,
                      ) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:

        def read():
            counts = np.zeros(len(sources), np.int64)
            columns, values = [], []
            for row, chunk in self._matrix_rows(
                    sources, targets, radius, np.float64,
                    matrix_service_pb2.MATRIX_LAYOUT_SPARSE, options):
                counts[row] = chunk.value_count
                columns.append(chunk.columns)
                values.append(chunk.values)
            return (counts,
                    np.frombuffer(bytearray(b"".join(columns)), "<i4"),
                    np.frombuffer(bytearray(b"".join(values)), "<f8"))

        return self._resident(read)

    def nearest(self, sources: Sources, targets: Places, count: int,
                radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        members = target_fields(targets)

        def make(rows):
            request = matrix_service_pb2.FindNearestRequest(
                mesh_digest=self.digest(), count=count,
                algorithm=_algorithm(options), **rows, **members,
                **_accuracy(options))
            if radius < math.inf:
                request.radius = radius
            return request

        def read():
            numbers = np.full((len(sources), count), -1, np.int64)
            distances = np.full((len(sources), count), np.inf)
            for row, chunk in self._rows(self._stubs.matrices.FindNearest, make,
                                         sources, targets, options):
                found = np.frombuffer(chunk.targets, "<u4")
                span = slice(chunk.offset, chunk.offset + len(found))
                numbers[row, span] = found
                distances[row, span] = np.frombuffer(chunk.distances, "<f8")
            return numbers, distances

        return self._resident(read)

    def pairs(self, sources: Places, targets: Places,
              options: Options) -> np.ndarray:
        are_vertices = packed_vertices(sources) and packed_vertices(targets)
        at_once = 1
        if len(sources) > 1:
            limits = self._stubs.capabilities().limits
            at_once = _at_once(
                limits, limits.max_pairs,
                2 * _VERTEX_BYTES if are_vertices else 2 * _PLACE_BYTES)
        distances = np.full(len(sources), np.inf)

        def read(first, request):
            for name, part in self._stubs.parts(self._stubs.pairs.ComputePairs,
                                                request):
                if name == "chunk":
                    values = np.frombuffer(part.distances, "<f8")
                    at = first + part.offset
                    distances[at:at + len(values)] = values
                elif name == "progress" and options.progress is not None:
                    options.progress(first + part.pairs_finished, len(sources))

        for first in range(0, len(sources), at_once):
            some = slice(first, first + at_once)
            request = pair_service_pb2.ComputePairsRequest(
                mesh_digest=self.digest(), algorithm=_algorithm(options),
                **_accuracy(options))
            if are_vertices:
                request.vertex_pairs.extend(
                    np.column_stack([sources.numbers[some, 0],
                                     targets.numbers[some, 0]]).ravel().tolist())
            else:
                request.pairs.extend(
                    pair_service_pb2.PointPair(source=a, target=b)
                    for a, b in zip(surface_points(sources[some]),
                                    surface_points(targets[some])))
            with _numbered_from(first):
                self._resident(functools.partial(read, first, request))
        return distances

    def samples(self, sources: Sources, count: int, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        request = field_service_pb2.SampleFarthestPointsRequest(
            mesh_digest=self.digest(),
            sources=source_messages(sources),
            count=count,
            algorithm=_algorithm(options),
            **_accuracy(options))
        found = [
            (sample.vertex, sample.distance)
            for name, part in self._answer(
                self._stubs.fields.SampleFarthestPoints, request, options)
            if name == "samples" for sample in part.samples
        ]
        return (np.array([vertex for vertex, _ in found], np.int64),
                np.array([distance for _, distance in found], np.float64))

    def log_map(self, sources: Sources, radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]:
        if len(sources) != 1 or sources.counts[0] >= 0:
            raise InvalidArgument("a log map has one source, which is a point")
        request = field_service_pb2.ComputeLogMapRequest(
            mesh_digest=self.digest(),
            source=next(iter(surface_points(sources.places))),
            algorithm=_algorithm(options))
        if radius < math.inf:
            request.radius = radius
        coordinates = np.full((self.vertex_count, 2), np.nan)
        zero_direction = np.zeros(3)
        for name, part in self._answer(self._stubs.fields.ComputeLogMap,
                                       request, options):
            if name == "frame":
                zero = part.zero_direction
                zero_direction[:] = zero.x, zero.y, zero.z
            elif name == "chunk":
                rows = np.frombuffer(part.coordinates, "<f8").reshape(-1, 2)
                coordinates[part.offset:part.offset + len(rows)] = rows
        return coordinates, zero_direction
