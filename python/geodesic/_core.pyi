"""The core, as geodesic.local uses it. Everything is thread-safe unless said
otherwise; what computes lets other threads of Python run, and stops when Ctrl-C
or an exception of `progress` says so.
"""

from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

_Progress = Optional[Callable[[int, int], object]]

VERSION: str
# (name, summary) of each; the first is the default.
ALGORITHMS: Tuple[Tuple[str, str], ...]
METHODS: Tuple[Tuple[str, Optional[str], Any], ...]

def mesh_format(path: bytes) -> str:
    """That a file's ending names: "obj", "ply"... Raises InvalidArgument, which
    names the endings that are known."""

def triangulate(vertices: NDArray[np.float64], corners: NDArray[np.int64],
                sizes: NDArray[np.int64]) -> Tuple[NDArray[np.uint32], int, int]:
    """Polygons as triangles (N, 3), as files' are (geodesic/polygons.h): polygon
    i has sizes[i] of the `corners`. Then how many cross themselves, and the
    number of the first. Raises InvalidArgument naming the first bad face."""

class Places:
    """The arrays of geodesic.places.Places."""
    def __init__(self, kinds: NDArray[np.uint8], numbers: NDArray[np.uint32],
                 weights: NDArray[np.float64]) -> None: ...
    @property
    def kinds(self) -> NDArray[np.uint8]: ...
    @property
    def numbers(self) -> NDArray[np.uint32]: ...
    @property
    def weights(self) -> NDArray[np.float64]: ...

class Sources:
    """The arrays of geodesic.places.Sources."""
    def __init__(self, places: Places, counts: NDArray[np.int64],
                 offsets: NDArray[np.float64]) -> None: ...

class Mesh:
    """Immutable. `vertices` (V, 3) and `faces` (F, 3), 32- or 64-bit integers,
    are copied once. `joins`: whether boundary edges are joined that lie within
    `distance` of each other; None: within the rounding of the coordinates."""
    def __init__(self, vertices: NDArray[np.float64],
                 faces: NDArray[np.integer[Any]], joins: bool,
                 distance: Optional[float]) -> None: ...
    @staticmethod
    def read(data: bytes, name: str, joins: bool,
             distance: Optional[float]) -> Mesh:
        """Of a file's bytes; the ending of `name` says in which format."""
    @staticmethod
    def restore(vertices: NDArray[np.float64], faces: NDArray[np.integer[Any]],
                joined: NDArray[np.uint32], numbers: Sequence[int]) -> Mesh:
        """A mesh of what another's reading() told: which vertices were joined,
        and into which (J, 2); seam edges, crossing polygons, the first one."""
    def reading(self) -> Tuple[NDArray[np.uint32], List[int]]:
        """What restore() takes."""
    def isolated(self, vertices: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Which of these are on no face (N,); not those that are out of range."""
    def notes(self) -> List[str]:
        """What was joined, left out or guessed, and what looks as if it should
        have been joined."""
    @property
    def positions(self) -> NDArray[np.float64]:
        """(V, 3); the mesh's own memory, read only."""
    def positions_of(self, places: Places) -> NDArray[np.float64]:
        """(N, 3). Raises InvalidArgument naming the first of the places that is
        not on the mesh, such as places[2]."""
    @property
    def vertex_count(self) -> int: ...
    @property
    def face_count(self) -> int: ...
    def triangles(self) -> NDArray[np.int32]:
        """(F, 3); a copy."""
    def facts(self) -> Dict[str, Any]: ...

class Query:
    """A question that was checked against its mesh."""
    def __init__(self, mesh: Mesh, sources: Sources, targets: Places,
                 algorithm: str, trace: bool, tolerance: float) -> None: ...

class Field:
    """What solve() found."""
    @property
    def distances(self) -> NDArray[np.float64]:
        """(V,); the field's own memory, read only."""
    def take_distances(self) -> NDArray[np.float64]:
        """(V,); not copied, but gone from the field."""
    def take_target_distances(self) -> NDArray[np.float64]:
        """(T,); likewise."""
    @property
    def settled_radius(self) -> float: ...
    @property
    def algorithm(self) -> str: ...
    def statistics(self) -> Dict[str, Any]: ...
    def nearest_sources(self) -> NDArray[np.uint32]: ...
    def gradients(self) -> NDArray[np.float64]: ...
    @property
    def certified_error(self) -> float:
        """0 if it is exact."""
    def certified_errors(self) -> NDArray[np.float32]:
        """(V,)."""
    def log_map(self, radius: float) -> Tuple[NDArray[np.float64], List[float]]: ...

def solve(query: Query, radius: float, stop_after_targets: int, threads: int,
          progress: _Progress) -> Field: ...

class Progression:
    """A computation in slices. For one thread at a time."""
    def __init__(self, query: Query, radius: float, threads: int) -> None: ...
    def next(self, seconds: float) -> Optional[
        Tuple[NDArray[np.int64], NDArray[np.float64]]]: ...

def trace(mesh: Mesh, sources: Places, directions: np.ndarray,
          lengths: List[float], threads: int, progress: _Progress,
          ) -> List[Tuple[Places, np.ndarray, float, str]]:
    """The places, positions, length and end of each line; of sources, directions
    (angles, or vectors of shape (N, 3)) and lengths there is one for all, or one
    for each."""
    ...


def paths(query: Query, radius: float, threads: int, progress: _Progress,
          ) -> List[Tuple[Places, NDArray[np.float64], float, float, int]]:
    """Places, points, distance, length and source of each target's path."""
def isolines(query: Query, levels: List[float], chord_error: float,
             threads: int, progress: _Progress) -> List[
                 Tuple[float, bool, Places, NDArray[np.float64]]]: ...
def samples(query: Query, count: int, threads: int, progress: _Progress,
            ) -> Tuple[NDArray[np.int64], NDArray[np.float64]]: ...

class Method:
    """What an approximate algorithm has prepared of a mesh: any but heat."""
    def __init__(self, mesh: Mesh, name: str, neighbours: int, samples: int,
                 threads: int, progress: _Progress) -> None: ...
    def distances(self, query: Query, progress: _Progress,
                  ) -> Tuple[NDArray[np.float64], float]:
        """(V,), and the seconds that it took."""

# Of the exact algorithm where `method` is None.
def fill_matrix(query: Query, radius: float, method: Optional[Method],
                threads: int, progress: _Progress, out: NDArray[Any]) -> None:
    """`out` is C-contiguous, of float64 or float32."""
def sparse_matrix(query: Query, radius: float, nearest: Optional[int],
                  method: Optional[Method], threads: int,
                  progress: _Progress) -> Tuple[
                      NDArray[np.int64], NDArray[np.int32],
                      NDArray[np.float64]]:
    """Counts of the rows, columns, values."""
def pairs(mesh: Mesh, sources: Places, targets: Places,
          method: Optional[Method], tolerance: float, threads: int,
          progress: _Progress) -> NDArray[np.float64]:
    """(N,)."""
