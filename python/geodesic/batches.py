"""A matrix in blocks of rows, each an .npy file in a folder.

    D = geodesic.batches.matrix(mesh, "/shared/distances", progress=True)
    for first, rows in D.blocks():             # memory-mapped, (B, T) each
        ...

Whatever fails, ask again: blocks that are there are kept. Processes on all machines
that see the folder may share the work, each with a part of it:

    geodesic.batches.matrix(mesh, folder, part=(0, 4))     # blocks 0, 4, 8, ...
    python3 -m geodesic.batches horse.ply folder --part 0/4

One process may have several services work, with a mesh at each:

    geodesic.batches.matrix([geodesic.connect(host).mesh("horse.ply")
                             for host in ("a:50051", "b:50051")], folder)
"""

from __future__ import annotations

import argparse
import concurrent.futures
import contextlib
import hashlib
import itertools
import json
import math
import os
import pathlib
import queue
import secrets
from typing import (IO, Any, Callable, Dict, Iterable, Iterator, List, Optional,
                    Tuple, Union)

import numpy as np

from .arguments import to_array, to_count
from .errors import GeodesicError, InvalidArgument
from .mesh import Mesh
from .places import to_numbers
from .progress import ProgressOption, reporting

Folder = Union[str, os.PathLike]

_FORMAT = "geodesic.matrix.v1"
_MANIFEST = "manifest.json"
# Of a block, unless the number of rows is given.
_BLOCK_BYTES = 32 * 2**20


def _write(path: pathlib.Path, temporary: str,
           write: Callable[[IO[bytes]], Any]) -> None:
    """Makes a file that is there whole or not at all, also after a loss of
    power."""
    unfinished = path.with_name(temporary)
    try:
        with open(unfinished, "wb") as file:
            write(file)
            file.flush()
            os.fsync(file.fileno())
        os.replace(unfinished, path)
    except BaseException:
        unfinished.unlink(missing_ok=True)
        raise
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)


def _read_manifest(folder: pathlib.Path) -> Dict[str, Any]:
    try:
        manifest = json.loads((folder / _MANIFEST).read_text())
    except (OSError, ValueError) as error:
        raise InvalidArgument(f"{folder} has no matrix: {error}") from None
    if not isinstance(manifest, dict) or manifest.get("format") != _FORMAT:
        raise InvalidArgument(f"{folder} has no matrix of format {_FORMAT}")
    return manifest


class BlockMatrix:
    """A matrix in a folder; matrix() and open_matrix() make it. Nothing is read
    before it is asked for. Thread-safe.

    Attributes:
        folder: where it is.
        shape: (S, T).
        dtype: float64 or float32.
        rows_per_block: of each block; the last may have fewer.
    """

    def __init__(self, folder: pathlib.Path) -> None:
        manifest = _read_manifest(folder)
        self.folder = folder
        try:
            self.shape: Tuple[int, int] = (manifest["rows"], manifest["columns"])
            self.dtype: np.dtype = np.dtype(manifest["dtype"])
            self.rows_per_block: int = manifest["rows_per_block"]
        except (KeyError, TypeError) as error:
            raise InvalidArgument(f"{folder / _MANIFEST} is damaged: {error}"
                                  ) from None

    def __repr__(self) -> str:
        return (f"<geodesic.BlockMatrix {self.shape}, {len(self)} blocks in "
                f"{self.folder}>")

    def __len__(self) -> int:
        """How many blocks there are."""
        return -(-self.shape[0] // self.rows_per_block)

    def span(self, block: int) -> slice:
        """The rows of a block, which are numbered from 0."""
        first = block * self.rows_per_block
        return slice(first, min(first + self.rows_per_block, self.shape[0]))

    def path(self, block: int) -> pathlib.Path:
        """The file of a block, whether or not it is there."""
        return self.folder / f"rows-{self.span(block).start:09d}.npy"

    def block(self, number: int) -> np.ndarray:
        """The rows of a block, (B, T), memory-mapped and read only.

        Raises:
            GeodesicError: the file is not there, is cut off or no such block.
        """
        span, path = self.span(number), self.path(number)
        try:
            rows = np.load(path, mmap_mode="r", allow_pickle=False)
        except (OSError, ValueError) as error:
            raise GeodesicError(f"{path} cannot be read: {error}") from None
        if (rows.shape != (span.stop - span.start, self.shape[1]) or
                rows.dtype != self.dtype):
            raise GeodesicError(f"{path} has shape {rows.shape} and type "
                                f"{rows.dtype}: it is another matrix's")
        return rows

    def missing(self) -> List[int]:
        """The blocks that block() does not give."""
        return [block for block in range(len(self)) if not self._has(block)]

    def blocks(self) -> Iterator[Tuple[int, np.ndarray]]:
        """(first row, rows) of all blocks in order; see block()."""
        for number in range(len(self)):
            yield self.span(number).start, self.block(number)

    def array(self, out: Optional[np.ndarray] = None) -> np.ndarray:
        """The whole matrix, (S, T), in `out` if that is given."""
        if out is None:
            out = np.empty(self.shape, self.dtype)
        if out.shape != self.shape:
            raise InvalidArgument(f"out has shape {out.shape}; the matrix has "
                                  f"{self.shape}")
        for first, rows in self.blocks():
            out[first:first + len(rows)] = rows
        return out

    def _has(self, block: int) -> bool:
        try:
            self.block(block)
        except GeodesicError:
            return False
        return True


def open_matrix(folder: Folder) -> BlockMatrix:
    """The matrix in a folder.

    Raises:
        InvalidArgument: there is none.
        GeodesicError: blocks are missing; it names the first.
    """
    answer = BlockMatrix(pathlib.Path(folder))
    missing = answer.missing()
    if missing:
        raise GeodesicError(
            f"{len(missing)} of {len(answer)} blocks are missing, first "
            f"{answer.path(missing[0])}: ask again for what makes them")
    return answer


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


def _digest(numbers: Optional[np.ndarray]) -> Optional[str]:
    return None if numbers is None else hashlib.sha256(
        numbers.astype("<i8").tobytes()).hexdigest()


def _begin(folder: pathlib.Path, question: Dict[str, Any]) -> BlockMatrix:
    """Writes the question into a new folder, or compares it with what is
    there."""
    path = folder / _MANIFEST
    folder.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        if question["rows_per_block"] is None:
            row_bytes = question["columns"] * np.dtype(question["dtype"]).itemsize
            question["rows_per_block"] = max(1, _BLOCK_BYTES // row_bytes)
        text = json.dumps(question, indent=1) + "\n"
        # Several processes may begin at the same time.
        _write(path, f".{_MANIFEST}-{secrets.token_hex(8)}",
               lambda file: file.write(text.encode()))
    there = _read_manifest(folder)
    if question["rows_per_block"] is None:
        question["rows_per_block"] = there.get("rows_per_block")
    for key in question:
        if question[key] != there.get(key):
            raise InvalidArgument(
                f"{folder} has the answer to another question: its {key} is "
                f"{there.get(key)!r}, not {question[key]!r}")
    return BlockMatrix(folder)


def _to_part(part: Tuple[int, int]) -> Tuple[int, int]:
    try:
        number, of = part
        if 0 <= number < of:
            return number, of
    except (TypeError, ValueError):
        pass
    raise InvalidArgument(f"part is {part!r}, not a number from 0 on and how many "
                          "parts there are")


def matrix(mesh: Any, folder: Folder, sources: Any = None, targets: Any = None, *,
           radius: Optional[float] = None, dtype: Any = np.float64,
           algorithm: Optional[str] = None, tolerance: float = 0,
           rows_per_block: Optional[int] = None, part: Tuple[int, int] = (0, 1),
           threads: Optional[int] = None,
           progress: ProgressOption = None) -> BlockMatrix:
    """The distance from every source to every target, in a folder.

    To every vertex the bits are those of mesh.matrix(); to targets they are up to
    rounding.

    Args:
        mesh: a geodesic.Mesh, or what it takes; or a list of the same mesh at
            several services, each of which makes a block at a time.
        folder: new, or of the same question, which is gone on with.
        sources, targets: vertex numbers or a mask of the vertices; None for all.
        radius: what lies beyond is +inf. Blocks are dense nevertheless.
        dtype: float64 or float32.
        algorithm, tolerance, threads: as in mesh.matrix().
        rows_per_block: what a failure loses at most; None for 32 MiB, or what
            the folder has.
        part: (n, of): the blocks n, n + of, n + 2 of... alone, for processes
            that share the work. No two at a time make the same part.
        progress: as everywhere; counts this part's rows.

    Raises:
        InvalidArgument: an argument is wrong, or the folder holds another matrix.
        GeodesicError, OSError: what was made stays.
    """
    meshes = [one if isinstance(one, Mesh) else Mesh(one)
              for one in (mesh if isinstance(mesh, list) else [mesh])]
    if len({one.digest for one in meshes}) != 1:
        raise InvalidArgument("mesh has to be one, perhaps at several services")
    number, of = _to_part(part)
    first = meshes[0]
    # Refuses what is wrong as the matrix itself would, before anything is written.
    first.matrix([0], [0], radius=radius, dtype=dtype, out=np.empty((1, 1)),
                 algorithm=algorithm, tolerance=tolerance, threads=threads)
    if rows_per_block is not None:
        rows_per_block = to_count(rows_per_block, "rows_per_block")
    rows = _vertices(sources, "sources", first.n_vertices)
    columns = _vertices(targets, "targets", first.n_vertices)
    answer = _begin(pathlib.Path(folder), {
        "format": _FORMAT,
        "mesh_digest": first.digest,
        "rows": first.n_vertices if rows is None else len(rows),
        "columns": first.n_vertices if columns is None else len(columns),
        "dtype": np.dtype(dtype).name,
        "rows_per_block": rows_per_block,
        "sources": _digest(rows),
        "targets": _digest(columns),
        "radius": None if radius is None or radius == math.inf else float(radius),
        "algorithm": algorithm,
        "tolerance": float(tolerance),
    })
    idle: "queue.SimpleQueue[Mesh]" = queue.SimpleQueue()
    for one in meshes:
        idle.put(one)

    def make(block: int) -> None:
        if answer._has(block):
            return
        span, path = answer.span(block), answer.path(block)
        places = np.arange(span.start, span.stop) if rows is None else rows[span]
        out = np.empty((len(places), answer.shape[1]), answer.dtype)
        at = idle.get()
        try:
            at.matrix(places, columns, radius=radius, out=out,
                      algorithm=algorithm, tolerance=tolerance, threads=threads)
        finally:
            idle.put(at)
        _write(path, f".{path.name}", lambda file: np.save(file, out))

    blocks = range(number, len(answer), of)
    sizes = [answer.span(block).stop - answer.span(block).start
             for block in blocks]
    rows_in_all = sum(sizes)
    with contextlib.ExitStack() as stack:
        report = stack.enter_context(reporting(progress, "rows"))
        made: Iterable[None] = map(make, blocks)
        if len(meshes) > 1:
            pool = concurrent.futures.ThreadPoolExecutor(len(meshes))
            stack.callback(pool.shutdown, cancel_futures=True)
            made = pool.map(make, blocks)
        for done, _ in zip(itertools.accumulate(sizes), made):
            if report is not None:
                report(done, rows_in_all)
    return answer


def _main() -> None:
    parser = argparse.ArgumentParser(
        prog="python3 -m geodesic.batches",
        description="Distances between all vertices of a mesh, in blocks of rows.")
    parser.add_argument("mesh", help="a mesh file")
    parser.add_argument("folder", help="where the blocks go, and what is there is "
                                       "kept")
    parser.add_argument("--part", metavar="N/OF", default="0/1",
                        help="make each OF-th block alone, from number N on")
    parser.add_argument("--server", metavar="HOST:PORT", action="append",
                        help="ask a service; several share the work")
    parser.add_argument("--rows-per-block", type=int, metavar="ROWS")
    parser.add_argument("--threads", type=int, help="rows at a time")
    options = parser.parse_args()
    try:
        number, of = map(int, options.part.split("/"))
    except ValueError:
        parser.error("--part takes two numbers, as in 0/4")
    try:
        if options.server:
            from .service import connect
            mesh: Any = [connect(server).mesh(options.mesh)
                         for server in options.server]
        else:
            mesh = Mesh(options.mesh)
        matrix(mesh, options.folder, rows_per_block=options.rows_per_block,
               part=(number, of), threads=options.threads)
    except (GeodesicError, OSError) as error:
        parser.exit(1, f"geodesic.batches: {error}\n")


if __name__ == "__main__":
    _main()
