"""The one interface of the two places where questions are answered.

geodesic.Mesh checks and converts what users pass, asks a Backend, and gives the
answers their names. `local.LocalBackend` answers in this process,
`service.ServiceBackend` asks a server.
"""

from __future__ import annotations

import dataclasses
from typing import Any, Dict, Iterator, List, Optional, Protocol, Tuple

import numpy as np

from .errors import InvalidArgument
from .places import Places, Sources
from .progress import ProgressCallback


@dataclasses.dataclass
class Options:
    """What questions have in common.

    Attributes:
        algorithm: a name, or None for the default.
        threads: how many may be used; a service decides that itself.
        progress: called now and then, or None.
    """

    algorithm: Optional[str] = None
    threads: int = 1
    progress: Optional[ProgressCallback] = None

    def __post_init__(self) -> None:
        if self.algorithm is not None and not isinstance(self.algorithm, str):
            raise InvalidArgument(
                f"algorithm is {self.algorithm!r}, which is no name")


@dataclasses.dataclass
class FieldAnswer:
    """A distance field; see geodesic.Field."""

    distances: np.ndarray
    target_distances: np.ndarray
    settled_radius: float
    algorithm: str
    statistics: Dict[str, Any]
    labels: Optional[np.ndarray] = None
    gradients: Optional[np.ndarray] = None


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


class Backend(Protocol):
    """Arrays have the shapes and types of geodesic.Mesh's methods. ``radius`` is
    +inf where there is none."""

    vertex_count: int
    face_count: int

    def vertices(self) -> np.ndarray: ...

    def faces(self) -> np.ndarray: ...

    def facts(self) -> Dict[str, Any]: ...

    def digest(self) -> str: ...

    def where(self) -> str: ...

    def with_faces(self, faces: np.ndarray) -> "Backend":
        """A mesh of the same vertices at the same place."""
        ...

    def field(self, sources: Sources, targets: Places, radius: float,
              stop_after_targets: Optional[int], labels: bool, gradients: bool,
              options: Options) -> FieldAnswer: ...

    def progressive(self, sources: Sources, radius: float, interval: float,
                    options: Options,
                    ) -> Iterator[Tuple[np.ndarray, np.ndarray]]: ...

    def paths(self, sources: Sources, targets: Places, radius: float,
              options: Options) -> List[PathAnswer]: ...

    def isolines(self, sources: Sources, levels: List[float],
                 options: Options) -> List[IsolineAnswer]: ...

    def fill_matrix(self, sources: Sources, targets: Optional[Places],
                    radius: float, out: np.ndarray,
                    options: Options) -> None: ...

    def sparse_matrix(self, sources: Sources, targets: Optional[Places],
                      radius: float, options: Options,
                      ) -> Tuple[np.ndarray, np.ndarray, np.ndarray]: ...

    def nearest(self, sources: Sources, targets: Places, count: int,
                radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]: ...

    def pairs(self, sources: Places, targets: Places,
              options: Options) -> np.ndarray: ...

    def samples(self, sources: Sources, count: int, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]: ...

    def log_map(self, sources: Sources, radius: float, options: Options,
                ) -> Tuple[np.ndarray, np.ndarray]: ...
