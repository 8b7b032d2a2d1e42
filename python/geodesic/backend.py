"""The one interface of the two places where questions are answered.

geodesic.Mesh checks and converts what users pass, asks a Backend, and gives the
answers their names. `local.LocalBackend` answers in this process,
`remote.RemoteBackend` asks a server.
"""

from __future__ import annotations

import dataclasses
from typing import (Any, Dict, Iterator, List, Optional, Protocol, Tuple,
                    Union)

import numpy as np

from . import _core
from .approximate import NAMES, Approximate
from .arguments import to_real
from .digest import Reading
from .errors import InvalidArgument
from .places import Places, Sources
from .progress import ProgressCallback
from .results import Field


@dataclasses.dataclass
class Options:
    """What questions have in common.

    Attributes:
        algorithm: a name, or None for the default; of an approximate one also
            an Approximate.
        threads: how many may be used; a service decides that itself.
        progress: called now and then, or None.
        tolerance: the largest relative error of distances; 0: exact. The core
            checks its bounds.
    """

    algorithm: Union[str, Approximate, None] = None
    threads: int = 1
    progress: Optional[ProgressCallback] = None
    tolerance: float = 0

    def __post_init__(self) -> None:
        self.tolerance = to_real(self.tolerance, "tolerance")
        if isinstance(self.algorithm, str) and self.algorithm in NAMES:
            self.algorithm = Approximate(self.algorithm)
        if self.approximate is not None:
            if self.tolerance != 0:
                raise InvalidArgument(
                    f"tolerance: {self.approximate.name} is approximate and "
                    "certifies nothing")
            return
        if self.algorithm is not None and not isinstance(self.algorithm, str):
            raise InvalidArgument(
                f"algorithm is {self.algorithm!r}, which is no name")
        exact = dict(_core.ALGORITHMS)
        if self.algorithm is not None and self.algorithm not in exact:
            raise InvalidArgument(
                f'unknown algorithm "{self.algorithm}"; known are: ' +
                ", ".join(exact) + "; and, approximate: " + ", ".join(NAMES))
        if self.tolerance != 0 and self.algorithm not in (None, "fwp-list"):
            raise InvalidArgument(
                f"tolerance: {self.algorithm} takes none; name no algorithm "
                "beside it, or fwp-list")

    @property
    def exact(self) -> Optional[str]:
        """The exact algorithm that is named; None for the default."""
        return self.algorithm if isinstance(self.algorithm, str) else None

    @property
    def approximate(self) -> Optional[Approximate]:
        """The approximate one; None if the answer is to be exact."""
        return (self.algorithm if isinstance(self.algorithm, Approximate) else
                None)

    def exact_alone(self, what: str) -> "Options":
        """Itself.

        Raises:
            InvalidArgument: it is approximate, which `what` is not.
        """
        if self.approximate is not None:
            raise InvalidArgument(
                f"algorithm: {self.approximate.name} is approximate, and {what} "
                "exact alone: name an exact algorithm or none")
        return self

    def check_places(self, places: Places, name: str) -> None:
        """Raises:
            InvalidArgument: it is approximate, and not all of them are vertices.
        """
        if self.approximate is not None and np.any(places.kinds):
            first = int(np.argmax(places.kinds != 0))
            raise InvalidArgument(
                f"{name}[{first}] is no vertex: {self.approximate.name} is "
                "approximate and gives the distances of vertices alone")


@dataclasses.dataclass
class PathAnswer:
    places: Places
    points: np.ndarray
    distance: float
    length: float
    source: int


@dataclasses.dataclass
class IsolineAnswer:
    level: float
    closed: bool
    places: Places
    points: np.ndarray


# By their numbers in answers.
LINE_ENDS = ("length", "boundary", "singular")


@dataclasses.dataclass
class LineAnswer:
    places: Places
    points: np.ndarray
    length: float
    end: str


class Backend(Protocol):
    """Arrays have the shapes and types of geodesic.Mesh's methods. ``radius`` is
    +inf where there is none."""

    vertex_count: int
    face_count: int

    def vertices(self) -> np.ndarray: ...

    def faces(self) -> np.ndarray: ...

    def facts(self) -> Dict[str, Any]: ...

    def notes(self) -> List[str]:
        """What was joined, left out or guessed; a sentence each."""

    def reading(self) -> Reading:
        """What was joined: see geodesic.digest."""

    def isolated(self, vertices: np.ndarray) -> np.ndarray:
        """Which of the vertices no face has, bool (N,)."""
        ...

    def digest(self) -> str: ...

    def where(self) -> str: ...

    def with_faces(self, faces: np.ndarray) -> "Backend":
        """A mesh of the same vertices, joined as they are, at the same place."""
        ...

    def positions(self, places: Places) -> np.ndarray:
        """Where places lie, which are checked as those of questions are."""
        ...

    def field(self, sources: Sources, targets: Places, radius: float,
              stop_after_targets: Optional[int], labels: bool, gradients: bool,
              certified_errors: bool, options: Options) -> Field:
        """Its target_distances are empty without targets."""
        ...

    def progressive(self, sources: Sources, radius: float, interval: float,
                    options: Options,
                    ) -> Iterator[Tuple[np.ndarray, np.ndarray]]: ...

    def paths(self, sources: Sources, targets: Places, radius: float,
              options: Options) -> List[PathAnswer]: ...

    def isolines(self, sources: Sources, levels: List[float],
                 chord_error: float, options: Options) -> List[IsolineAnswer]: ...

    def trace(self, sources: Places, directions: np.ndarray,
              lengths: np.ndarray, options: Options) -> List[LineAnswer]:
        """`directions`: (N,) angles or (N, 3) vectors. Of each there is one for all
        lines, or one for each."""
        ...

    def fill_matrix(self, sources: Sources, targets: Optional[Places],
                    radius: float, out: np.ndarray,
                    options: Options) -> None: ...

    def sparse_matrix(self, sources: Sources, targets: Optional[Places],
                      radius: float, nearest: Optional[int], options: Options,
                      ) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        """How many values each row has, their columns (int32) and distances: all
        that are finite, or the `nearest` in order of distance."""
        ...

    def pairs(self, sources: Places, targets: Places,
              options: Options) -> np.ndarray: ...

    def samples(self, sources: Sources, count: int, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]: ...

    def log_map(self, sources: Sources, radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]: ...
