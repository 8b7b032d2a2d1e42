"""Answers in a folder of files, each of which is whole and right, or made again.

A matrix, as geodesic.dask and deploy/slurm/matrix write it:

    manifest.json               which mesh and which question, how rows are cut
    rows-000000000.npy          a shard: a block of rows, named by the first
    rows-000000000.npy.sha256   its checksum, written when the shard is there
    ...

A checksum is a file of its own, so that whoever makes a shard needs nobody else
to say that it is done. `sha256sum --check --quiet *.sha256` checks all.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import io
import json
import os
import pathlib
import secrets
import time
from typing import Any, Dict, Iterable, Iterator, List, Optional, Tuple, Union

import numpy as np

from .errors import GeodesicError, InvalidArgument

Folder = Union[str, os.PathLike]

_FORMAT = "geodesic.matrix.v1"
_MANIFEST = "manifest.json"
# Begins the names of files that are being written. Who wrote to one is gone when
# this long nothing was added: a shard takes seconds, and clocks may differ.
_UNFINISHED = ".unfinished-"
_ABANDONED_SECONDS = 3600
# What a shard of a matrix takes unless the number of rows is given.
_SHARD_BYTES = 32 * 2**20
_HASHED_AT_ONCE = 2**20


def write_file(path: pathlib.Path, parts: Iterable[Any]) -> str:
    """Writes bytes to a file that is there whole or not at all, also after a
    loss of power. Returns their sha-256.

    Raises:
        OSError: nothing was written.
    """
    name = hashlib.sha256()
    temporary = path.with_name(f"{_UNFINISHED}{path.name}-{secrets.token_hex(8)}")
    try:
        with open(temporary, "wb") as file:
            for part in parts:
                name.update(part)
                file.write(part)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    folder = os.open(path.parent, os.O_RDONLY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)
    return name.hexdigest()


def _npy_parts(array: np.ndarray) -> Iterator[Any]:
    """The bytes of an .npy file."""
    array = np.ascontiguousarray(array)
    header = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        header, np.lib.format.header_data_from_array_1_0(array))
    yield header.getvalue()
    yield array.reshape(-1).view(np.uint8).data


def write_array(path: pathlib.Path, array: np.ndarray) -> str:
    """Writes an .npy file as write_file() does. Returns its sha-256."""
    return write_file(path, _npy_parts(array))


def file_digest(path: Folder) -> str:
    """The sha-256 of a file's bytes."""
    name = hashlib.sha256()
    with open(path, "rb") as file:
        while part := file.read(_HASHED_AT_ONCE):
            name.update(part)
    return name.hexdigest()


def _checksum_path(shard: pathlib.Path) -> pathlib.Path:
    return shard.with_name(shard.name + ".sha256")


def _checksum_line(digest: str, path: str) -> str:
    """As sha256sum writes it."""
    if "\\" in path or "\n" in path:
        escaped = path.replace("\\", "\\\\").replace("\n", "\\n")
        return f"\\{digest}  {escaped}\n"
    return f"{digest}  {path}\n"


def write_shard(path: pathlib.Path, array: np.ndarray,
                made_of: Optional[Tuple[str, str]] = None) -> None:
    """Writes a shard and then its checksum.

    Args:
        made_of: the sha-256 and the path, from the shard's folder, of a file of
            which the shard is made; a line of its own beside the shard's.
    """
    lines = [_checksum_line(write_array(path, array), path.name)]
    if made_of is not None:
        lines.append(_checksum_line(*made_of))
    write_file(_checksum_path(path), ["".join(lines).encode()])


def is_right(path: pathlib.Path, made_of: Optional[str] = None) -> bool:
    """Whether a shard is there and has its checksum, and was made of a file with
    this sha-256. Reads all of it."""
    try:
        lines = _checksum_path(path).read_text().splitlines()
        digests = [line.lstrip("\\")[:64] for line in lines]
        wanted = [] if made_of is None else [made_of]
        return digests[1:] == wanted and digests[:1] == [file_digest(path)]
    except (OSError, UnicodeDecodeError):
        return False


def remove_abandoned(folder: pathlib.Path) -> None:
    """Removes what those who were killed have left half written: the workers of
    an earlier run may still write the rest."""
    for path in folder.glob(_UNFINISHED + "*"):
        with contextlib.suppress(FileNotFoundError):  # finished meanwhile
            if time.time() - path.stat().st_mtime > _ABANDONED_SECONDS:
                path.unlink()


def has_manifest(folder: pathlib.Path) -> bool:
    return (folder / _MANIFEST).exists()


def read_manifest(folder: pathlib.Path) -> Dict[str, Any]:
    """Raises InvalidArgument where there is none that can be read."""
    path = folder / _MANIFEST
    try:
        manifest = json.loads(path.read_bytes())
    except FileNotFoundError:
        raise InvalidArgument(f"{folder} has no {_MANIFEST}") from None
    except ValueError as error:
        raise InvalidArgument(f"{path} is damaged: {error}") from None
    if not isinstance(manifest, dict):
        raise InvalidArgument(f"{path} is no manifest")
    return manifest


def ensure_manifest(folder: pathlib.Path, manifest: Dict[str, Any]) -> None:
    """Writes the manifest of a new folder, or compares it with what is there.

    Raises:
        InvalidArgument: the folder has the answers to another question.
    """
    folder.mkdir(parents=True, exist_ok=True)
    if not has_manifest(folder):
        text = json.dumps(manifest, indent=1) + "\n"
        write_file(folder / _MANIFEST, [text.encode()])
        return
    there = read_manifest(folder)
    for key in manifest.keys() | there.keys():
        if manifest.get(key) != there.get(key):
            raise InvalidArgument(
                f"{folder} has the answer to another question: its {key} is "
                f"{there.get(key)!r}, not {manifest.get(key)!r}")


def vertices_digest(numbers: Optional[np.ndarray]) -> Optional[str]:
    """The sha-256 of vertex numbers as text, one a line; None for every
    vertex."""
    if numbers is None:
        return None
    text = "".join(f"{number}\n" for number in numbers.tolist())
    return hashlib.sha256(text.encode()).hexdigest()


@dataclasses.dataclass(frozen=True)
class MatrixLayout:
    """What a folder's manifest says of its matrix.

    Attributes:
        mesh_digest: the mesh's name, as Mesh.digest.
        rows, columns: S and T.
        dtype: "float64" or "float32".
        rows_per_block: of each shard; the last may have fewer.
        sources, targets: vertices_digest() of rows and columns.
        radius: what lies beyond is +inf; None for no bound.
        algorithm: its name; None for the default.
        tolerance: the relative error that distances may have; None for 0.
    """

    mesh_digest: str
    rows: int
    columns: int
    dtype: str
    rows_per_block: int
    sources: Optional[str] = None
    targets: Optional[str] = None
    radius: Optional[float] = None
    algorithm: Optional[str] = None
    tolerance: Optional[float] = None

    @classmethod
    def of(cls, manifest: Dict[str, Any]) -> "MatrixLayout":
        """Raises InvalidArgument if this is no matrix's manifest."""
        fields = dict(manifest)
        if fields.pop("format", None) != _FORMAT:
            raise InvalidArgument(f"no manifest of format {_FORMAT}")
        try:
            layout = cls(**fields)
            good = (layout.dtype in ("float64", "float32") and layout.rows >= 1
                    and layout.columns >= 1 and layout.rows_per_block >= 1)
        except TypeError:
            good = False
        if not good:
            raise InvalidArgument("the manifest of the matrix is damaged")
        return layout

    def manifest(self) -> Dict[str, Any]:
        return {"format": _FORMAT, **dataclasses.asdict(self)}

    @property
    def blocks(self) -> int:
        """How many shards there are."""
        return -(-self.rows // self.rows_per_block)

    def span(self, block: int) -> slice:
        """The rows of a block, which are numbered from 0."""
        first = block * self.rows_per_block
        return slice(first, min(first + self.rows_per_block, self.rows))

    def shard(self, folder: pathlib.Path, block: int) -> pathlib.Path:
        return folder / f"rows-{self.span(block).start:09d}.npy"


def default_rows_per_block(columns: int, dtype: str) -> int:
    """As many as make a shard of 32 MiB; depends on nothing that may be another
    when the matrix is gone on with."""
    return max(1, _SHARD_BYTES // (columns * np.dtype(dtype).itemsize))


class ShardedMatrix:
    """A matrix in a folder of shards; open_matrix() makes it.

        D = geodesic.shards.open_matrix("distances/")
        for first, rows in D.blocks():     # memory-mapped, (B, T) each
            ...
        D.array()                          # all of it, (S, T)

    Nothing is read before it is asked for. Thread-safe.
    """

    def __init__(self, folder: pathlib.Path, layout: MatrixLayout) -> None:
        self.folder = folder
        self.layout = layout

    def __repr__(self) -> str:
        return (f"<geodesic.ShardedMatrix {self.shape}, "
                f"{self.layout.blocks} shards in {self.folder}>")

    @property
    def shape(self) -> Tuple[int, int]:
        """(S, T)."""
        return self.layout.rows, self.layout.columns

    @property
    def dtype(self) -> np.dtype:
        """float64 or float32."""
        return np.dtype(self.layout.dtype)

    def wrong(self) -> List[int]:
        """The blocks that are missing, short or damaged. Reads all of them."""
        return [
            block for block in range(self.layout.blocks)
            if not is_right(self.layout.shard(self.folder, block))
        ]

    def block(self, number: int) -> np.ndarray:
        """The rows of a block, (B, T), memory-mapped and read only.

        Raises:
            GeodesicError: the shard is not there or is no such block.
        """
        span = self.layout.span(number)
        path = self.layout.shard(self.folder, number)
        try:
            rows = np.load(path, mmap_mode="r", allow_pickle=False)
        except (OSError, ValueError) as error:
            raise GeodesicError(f"{path} cannot be read: {error}") from None
        if (rows.shape != (span.stop - span.start, self.layout.columns) or
                rows.dtype != self.dtype):
            raise GeodesicError(f"{path} has shape {rows.shape} and type "
                                f"{rows.dtype}: it is another matrix's")
        return rows

    def blocks(self) -> Iterator[Tuple[int, np.ndarray]]:
        """(first row, rows) of all blocks in order; see block()."""
        for number in range(self.layout.blocks):
            yield self.layout.span(number).start, self.block(number)

    def array(self, out: Optional[np.ndarray] = None) -> np.ndarray:
        """The whole matrix, (S, T).

        Args:
            out: an array of this shape to fill, such as a np.memmap.
        """
        if out is None:
            out = np.empty(self.shape, self.dtype)
        if out.shape != self.shape:
            raise InvalidArgument(f"out has shape {out.shape}; the matrix has "
                                  f"{self.shape}")
        for first, rows in self.blocks():
            out[first:first + len(rows)] = rows
        return out


def open_matrix(folder: Folder, *, check: bool = True) -> ShardedMatrix:
    """The matrix in a folder.

    Args:
        check: compare all shards with their checksums, which reads all of them.

    Raises:
        InvalidArgument: there is no matrix.
        GeodesicError: shards are missing or wrong; it names the first.
    """
    path = pathlib.Path(folder)
    matrix = ShardedMatrix(path, MatrixLayout.of(read_manifest(path)))
    wrong = matrix.wrong() if check else []
    if wrong:
        raise GeodesicError(
            f"{len(wrong)} of {matrix.layout.blocks} shards are missing or "
            f"wrong, first {matrix.layout.shard(path, wrong[0])}: run again "
            "what makes them")
    return matrix
