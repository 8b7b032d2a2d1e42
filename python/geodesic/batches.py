"""The parts of a large question, each of which a process can answer alone.

A folder that all processes see holds the question (manifest.json and the input
files here) and takes the answers (geodesic.shards). What runs the parts is
another's affair: geodesic.dask is one.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import json
import math
import os
import pathlib
import secrets
import threading
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _core, shards
from .arguments import to_array, to_count
from .digest import PLAIN, mesh_digest
from .errors import GeodesicError, InvalidArgument, Unavailable
from .mesh import Mesh, restored
from .places import to_numbers

if TYPE_CHECKING:
    from .service import Service

# Where answers come from: the address of a service, or a function that connects
# to one; None for the process itself.
Connect = Union[None, str, Callable[[], "Service"]]


@dataclasses.dataclass(frozen=True)
class Door:
    """A way to a service, on which a process connects once: two unpickled copies
    of a function are never equal, but their keys are."""

    key: str
    connect: Union[str, Callable[[], "Service"]] = dataclasses.field(
        compare=False)

    @classmethod
    def to(cls, connect: Connect) -> Optional["Door"]:
        """A new one; None for the process itself."""
        return None if connect is None else cls(secrets.token_hex(8), connect)


_ANSWERS_FORMAT = "geodesic.answers.v1"
# Questions of Mesh that one array answers.
_QUESTIONS = ("distances", "labels", "gradients", "matrix", "pairs")
_INPUTS = ("vertices", "faces", "joined", "reading", "sources", "targets")


def _input(folder: pathlib.Path, name: str) -> pathlib.Path:
    return folder / f"input-{name}.npy"


def _vertices(values: Any, name: str, count: int) -> Optional[np.ndarray]:
    """Vertex numbers, int64 (N,), from numbers or a mask."""
    if values is None:
        return None
    numbers = to_numbers(to_array(values, name), name, count).astype(np.int64)
    if not len(numbers):
        raise InvalidArgument(f"{name} has no vertex")
    if numbers.max() >= count:
        raise InvalidArgument(f"{name} names vertex {numbers.max()}, but the mesh "
                              f"has {count}, numbered from 0")
    return numbers


def plan_matrix(mesh: Mesh, folder: shards.Folder, sources: Any, targets: Any, *,
                radius: Optional[float], dtype: Any,
                algorithm: Optional[str], tolerance: float,
                rows_per_block: Optional[int]) -> shards.MatrixLayout:
    """Writes the question into the folder, if it is not there; arguments as in
    geodesic.dask.matrix()."""
    # Refuses what is wrong as the matrix itself would, before anything is written.
    mesh.matrix([0], [0], radius=radius, dtype=dtype, out=np.empty((1, 1)),
                algorithm=algorithm, tolerance=tolerance, threads=1)
    if rows_per_block is not None:
        rows_per_block = to_count(rows_per_block, "rows_per_block")
    path = pathlib.Path(folder)
    rows = _vertices(sources, "sources", mesh.n_vertices)
    columns = _vertices(targets, "targets", mesh.n_vertices)
    layout = shards.MatrixLayout(
        mesh_digest=mesh.digest,
        rows=mesh.n_vertices if rows is None else len(rows),
        columns=mesh.n_vertices if columns is None else len(columns),
        dtype=np.dtype(dtype).name,
        rows_per_block=1,
        sources=shards.vertices_digest(rows),
        targets=shards.vertices_digest(columns),
        radius=None if radius is None or radius == math.inf else float(radius),
        algorithm=algorithm,
        tolerance=float(tolerance) or None)
    if rows_per_block is None and shards.has_manifest(path):
        rows_per_block = shards.MatrixLayout.of(
            shards.read_manifest(path)).rows_per_block
    if rows_per_block is None:
        rows_per_block = shards.default_rows_per_block(layout.columns,
                                                       layout.dtype)
    layout = dataclasses.replace(layout, rows_per_block=rows_per_block)
    shards.ensure_manifest(path, layout.manifest())
    shards.remove_abandoned(path)
    joined, numbers = mesh._backend.reading()
    is_plain = not any(numbers) and not len(joined)
    inputs: Tuple[Optional[np.ndarray], ...] = (
        mesh.vertices, mesh.faces, None if is_plain else joined,
        None if is_plain else np.array(numbers, np.uint64), rows, columns)
    for name, array in zip(_INPUTS, inputs):
        if array is not None:
            shards.write_array(_input(path, name), array)
    return layout


@dataclasses.dataclass(frozen=True)
class _Question:
    """A folder's question as it was when this process first saw it."""

    folder: pathlib.Path
    manifest: str
    door: Optional[Door]


@dataclasses.dataclass(frozen=True)
class _Opened:
    layout: shards.MatrixLayout
    mesh: Mesh
    sources: Optional[np.ndarray]
    targets: Optional[np.ndarray]


# Held while a process opens a mesh or a connection, which its threads share.
_opening = threading.Lock()


@functools.lru_cache(maxsize=1)
def _service(door: Door) -> "Service":
    if callable(door.connect):
        return door.connect()
    from .service import connect
    return connect(door.connect)


@functools.lru_cache(maxsize=1)
def _open(question: _Question) -> _Opened:
    """The mesh and the vertices of a matrix, once a process."""
    folder = question.folder
    layout = shards.MatrixLayout.of(json.loads(question.manifest))
    inputs = {
        name: np.load(_input(folder, name)) if _input(folder, name).exists() else
        None for name in _INPUTS
    }
    vertices, faces = inputs["vertices"], inputs["faces"]
    reading = PLAIN
    if inputs["joined"] is not None and inputs["reading"] is not None:
        reading = inputs["joined"], [int(n) for n in inputs["reading"]]
    if (vertices is None or faces is None or
            mesh_digest(vertices, faces, reading) != layout.mesh_digest or
            any(layout.__dict__[name] is not None and
                shards.vertices_digest(inputs[name]) != layout.__dict__[name]
                for name in ("sources", "targets"))):
        raise GeodesicError(f"the input files in {folder} are damaged: begin "
                            "again, which writes them anew")
    if question.door is None:
        mesh = restored(vertices, faces, reading)
    elif reading is not PLAIN:
        # It may have it; arrays do not say what was joined.
        mesh = _service(question.door).open(layout.mesh_digest)
    else:
        mesh = _service(question.door).mesh(vertices, faces)
    return _Opened(
        layout, mesh,
        None if layout.sources is None else inputs["sources"],
        None if layout.targets is None else inputs["targets"])


def make_block(folder: shards.Folder, block: int,
               door: Optional[Door] = None) -> bool:
    """Makes one shard of a matrix, unless it is there and right. One thread.
    Returns whether it was made.

    Raises:
        GeodesicError: what the mesh's matrix() raises, or damaged input files.
        OSError: the shard could not be written.
    """
    path = pathlib.Path(folder)
    manifest = shards.read_manifest(path)
    layout = shards.MatrixLayout.of(manifest)
    shard = layout.shard(path, block)
    if shards.is_right(shard):
        return False
    with _opening:
        opened = _open(_Question(path, json.dumps(manifest), door))
    span = layout.span(block)
    rows = (np.arange(span.start, span.stop) if opened.sources is None else
            opened.sources[span])
    answer = np.empty((len(rows), layout.columns), layout.dtype)
    opened.mesh.matrix(rows, opened.targets, radius=layout.radius, out=answer,
                       algorithm=layout.algorithm,
                       tolerance=layout.tolerance or 0, threads=1)
    shards.write_shard(shard, answer)
    return True


def _jsonable(value: Any) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise InvalidArgument(f"{value!r} cannot be written down: options of a "
                          "question to many meshes are numbers, texts and lists "
                          "of them")


def plan_answers(folder: shards.Folder, question: str,
                 options: Dict[str, Any]) -> None:
    """Writes one question to many meshes into the folder, if it is not there."""
    if question not in _QUESTIONS:
        raise InvalidArgument(f"there is no question {question!r} for many "
                              f"meshes; there are {', '.join(_QUESTIONS)}")
    try:
        inspect.signature(getattr(Mesh, question)).bind(None, **options)
    except TypeError as error:
        raise InvalidArgument(f"{question}: {error}") from None
    path = pathlib.Path(folder)
    shards.ensure_manifest(path, {
        "format": _ANSWERS_FORMAT,
        "question": question,
        "options": json.loads(json.dumps(options, default=_jsonable)),
    })
    shards.remove_abandoned(path)


def _is_mesh_file(path: pathlib.Path) -> bool:
    try:
        _core.mesh_format(os.fsencode(path))
    except InvalidArgument:
        return False
    return True


def mesh_files(meshes: Union[shards.Folder, List[shards.Folder]],
               ) -> Dict[str, str]:
    """The absolute paths of mesh files, by name, in order.

    Args:
        meshes: a folder, whose files with a mesh's ending are meant; or files.

    Raises:
        InvalidArgument: there is none, or two have one name.
    """
    if isinstance(meshes, (str, os.PathLike)):
        paths = [
            path for path in sorted(pathlib.Path(meshes).iterdir())
            if _is_mesh_file(path)
        ]
        if not paths:
            raise InvalidArgument(f"{meshes} has no mesh file")
    else:
        paths = [pathlib.Path(path) for path in meshes]
    files: Dict[str, str] = {}
    for path in paths:
        if path.name in files:
            raise InvalidArgument(
                f"{path} and {files[path.name]} have one name, and their answers "
                "would have, too")
        files[path.name] = os.path.abspath(path)
    return files


def make_answer(folder: shards.Folder, file: str,
                door: Optional[Door] = None) -> Union[bool, str]:
    """Answers the folder's question for one mesh file, unless the answer is
    there, right, and made of this file. One thread.

    Returns:
        Whether it was made; or, if the file or its answer is at fault, why.

    Raises:
        Unavailable: the service is.
        OSError: the shard could not be written.
    """
    path = pathlib.Path(folder)
    manifest = shards.read_manifest(path)
    name = pathlib.Path(file).name
    shard = path / (name + ".npy")
    try:
        digest = shards.file_digest(file)
        if shards.is_right(shard, digest):
            return False
        if door is None:
            mesh = Mesh(file)
        else:
            with _opening:
                service = _service(door)
            mesh = service.mesh(file)
        answer = getattr(mesh, manifest["question"])(
            **{"threads": 1, **manifest["options"]})
        if not isinstance(answer, np.ndarray):
            raise InvalidArgument("the answer is no array")
    except Unavailable:
        raise
    except (GeodesicError, OSError, TypeError) as error:
        return f"{type(error).__name__}: {error}"
    shards.write_shard(shard, answer,
                       (digest, os.path.relpath(file, path)))
    return True
