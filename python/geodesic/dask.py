"""Large batches on Dask: matrices of all pairs, one question to many meshes.

    from distributed import Client
    import geodesic.dask

    with Client("scheduler:8786"):
        D = geodesic.dask.matrix(mesh, "/shared/distances", progress=True)
        for first, rows in D.blocks():
            ...
        answers = geodesic.dask.each("/shared/meshes", "/shared/fields",
                                     source=0, radius=20)
        answers.failed                    # {file name: what was wrong}

Workers write their answers into a folder that they and you see, and send nothing
through the scheduler but whether they did. Whatever fails, ask again: what is
there and right is kept (geodesic.shards), the rest is made. One run at a time for
a folder.

Workers need this package, too. Each answers with as many threads as Dask gives
it, and holds the mesh once.
"""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Callable, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np

from . import batches
from .errors import InvalidArgument
from .mesh import Mesh
from .progress import ProgressOption, reporting
from .shards import Folder, ShardedMatrix, open_matrix

try:
    import distributed
except ImportError:
    raise ImportError(
        "geodesic.dask runs on Dask: install distributed (Debian: "
        "python3-distributed)") from None

__all__ = ["Answers", "each", "matrix", "open_matrix"]

# How often a part is tried again that raised. Parts of workers that died are
# tried again by Dask itself.
_RETRIES = 2


@dataclasses.dataclass(frozen=True)
class Answers:
    """What became of one question to many meshes.

    Attributes:
        made: how many were answered now.
        kept: how many had been answered before.
        failed: by the file's name, why there is no answer.
    """

    made: int
    kept: int
    failed: Dict[str, str]


def _client(client: Optional["distributed.Client"]) -> "distributed.Client":
    if client is not None:
        return client
    try:
        return distributed.get_client()
    except ValueError:
        raise InvalidArgument(
            "there is no Dask client: make one (distributed.Client(...)), or pass "
            "client=") from None


def _run(client: "distributed.Client", work: Callable[..., Any],
         parts: List[Tuple[Any, ...]],
         ) -> Iterator[Tuple[int, "distributed.Future"]]:
    """Does all parts; yields their numbers as they are done. Leaving it gives up
    what is not begun."""
    # Not pure: what Dask remembers of an earlier run may be gone from the disk.
    futures = [
        client.submit(work, *part, pure=False, retries=_RETRIES)
        for part in parts
    ]
    numbers = {future.key: number for number, future in enumerate(futures)}
    try:
        for future in distributed.as_completed(futures):
            yield numbers[future.key], future
    finally:
        client.cancel(futures)


def matrix(mesh: Any, folder: Folder, sources: Any = None, targets: Any = None, *,
           radius: Optional[float] = None, dtype: Any = np.float64,
           algorithm: Optional[str] = None, tolerance: float = 0,
           rows_per_block: Optional[int] = None,
           client: Optional["distributed.Client"] = None,
           connect: batches.Connect = None,
           progress: ProgressOption = None) -> ShardedMatrix:
    """The distance from every source to every target, as shards in a folder.

        D = geodesic.dask.matrix(mesh, "/shared/distances")      # all pairs

    To every vertex the bits are those of mesh.matrix(); to targets they are up to
    rounding.

    Args:
        mesh: a geodesic.Mesh, or what it takes: a file, another library's mesh.
        folder: as all workers see it, too. New, or of the same question, which is
            gone on with.
        sources, targets: vertex numbers or a mask of the vertices; None for all.
        radius: what lies beyond is +inf. Shards are dense nevertheless.
        dtype: float64 or float32.
        algorithm, tolerance: as in mesh.matrix().
        rows_per_block: of a shard, the part that is lost with a worker; None for
            32 MiB, or what the folder has.
        client: Dask's; None for the current one.
        connect: where workers ask: None for themselves, the address of a service,
            or a function that returns geodesic.connect(...), which runs in each.
        progress: as everywhere; counts rows.

    Raises:
        InvalidArgument: an argument is wrong, or the folder holds another matrix.
        GeodesicError, OSError: what a worker met three times at one block. What
            was made stays.
    """
    client = _client(client)
    if not isinstance(mesh, Mesh):
        mesh = Mesh(mesh)
    place = os.path.abspath(folder)
    layout = batches.plan_matrix(
        mesh, place, sources, targets, radius=radius, dtype=dtype,
        algorithm=algorithm, tolerance=tolerance,
        rows_per_block=rows_per_block)
    door = batches.Door.to(connect)
    parts: List[Tuple[Any, ...]] = [
        (place, block, door) for block in range(layout.blocks)
    ]
    done = 0
    with reporting(progress, "rows") as report:
        for block, future in _run(client, batches.make_block, parts):
            future.result()
            span = layout.span(block)
            done += span.stop - span.start
            if report is not None:
                report(done, layout.rows)
    # Each worker has compared or written its shards' checksums.
    return open_matrix(place, check=False)


def each(meshes: Union[Folder, List[Folder]], folder: Folder,
         question: str = "distances", *,
         client: Optional["distributed.Client"] = None,
         connect: batches.Connect = None, progress: ProgressOption = None,
         **options: Any) -> Answers:
    """One question to many mesh files; the answer for horse.ply is horse.ply.npy.

        geodesic.dask.each("/shared/meshes", "/shared/fields", source=0)
        np.load("/shared/fields/horse.ply.npy")

    A file that has changed is asked again.

    Args:
        meshes: a folder, whose mesh files are meant; or a list of files. As all
            workers see them, too.
        folder: where answers go; new, or of the same question.
        question: a method of geodesic.Mesh: distances, labels, gradients, matrix
            or pairs.
        options: its arguments by name; numbers, texts, lists and arrays.
        client, connect: as in matrix().
        progress: counts files.

    Returns:
        How many there are, and the files that are at fault: they keep nobody.

    Raises:
        InvalidArgument: an argument is wrong, or the folder holds other answers.
        Unavailable, OSError: what a worker met three times at one file that is
            not the file's fault, such as a full disk. What was made stays.
    """
    client = _client(client)
    place = os.path.abspath(folder)
    files = batches.mesh_files(meshes)
    batches.plan_answers(place, question, options)
    names = list(files)
    door = batches.Door.to(connect)
    parts: List[Tuple[Any, ...]] = [
        (place, file, door) for file in files.values()
    ]
    made = kept = 0
    failed: Dict[str, str] = {}
    with reporting(progress, "files") as report:
        for number, future in _run(client, batches.make_answer, parts):
            try:
                outcome = future.result()
            except distributed.scheduler.KilledWorker as error:
                # Memory, most likely, that this file wants.
                outcome = f"its workers died: {error}"
            if isinstance(outcome, str):
                failed[names[number]] = outcome
            elif outcome:
                made += 1
            else:
                kept += 1
            if report is not None:
                report(made + kept + len(failed), len(files))
    return Answers(made, kept, dict(sorted(failed.items())))
