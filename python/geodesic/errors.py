"""The exceptions of the package.

Each is also the usual Python exception of its kind, so that ``except
ValueError`` works. The message names what is wrong, e.g. ``sources[0].vertex
991 is out of range: the mesh has 502 vertices, numbered from 0``.
"""

from __future__ import annotations

import contextlib
import os
from typing import Iterator, Optional, Union


class GeodesicError(Exception):
    """The base of all errors of this package.

    Attributes:
        reason: for programs; what the service calls the error, e.g.
            ``"QUEUE_FULL"``. None for errors of this process.
        retry_after: after so many seconds the service would like to be asked
            again; +inf: not at all. None if it did not say.
    """

    reason: Optional[str] = None
    retry_after: Optional[float] = None


class GeodesicWarning(UserWarning):
    """What was joined, left out or guessed when a mesh was made, or looks as if
    it should have been joined; and an answer that is right, and surely not what
    was wanted: a source on no face, a target that cannot be reached, fewer
    samples than asked for."""


class InvalidArgument(GeodesicError, ValueError):
    """A malformed mesh, a place that the mesh does not have, a bad option."""


class NotFound(GeodesicError, LookupError):
    """The service does not have the mesh."""


class ResourceExhausted(GeodesicError, MemoryError):
    """More than a limit, the memory or a quota allows."""


class DeadlineExceeded(GeodesicError, TimeoutError):
    """The answer did not come within ``timeout``."""


class Cancelled(GeodesicError):
    """The computation was stopped."""


class Unavailable(GeodesicError, ConnectionError):
    """The service cannot be reached, or is shutting down."""


class NotAllowed(GeodesicError, PermissionError):
    """The service wants another token, or a certificate."""


class InternalError(GeodesicError, RuntimeError):
    """A defect of geodesic itself: please report it."""


# By gRPC's codes, which the core uses as well.
_BY_CODE = {
    1: Cancelled,
    3: InvalidArgument,
    4: DeadlineExceeded,
    5: NotFound,
    7: NotAllowed,
    8: ResourceExhausted,
    14: Unavailable,
    16: NotAllowed,
}


def from_code(code: int, message: str,
              reason: Optional[str] = None) -> GeodesicError:
    """The exception for one of gRPC's codes."""
    error = _BY_CODE.get(code, InternalError)(message)
    error.reason = reason
    return error


@contextlib.contextmanager
def naming(path: Union[str, "os.PathLike[str]"]) -> Iterator[None]:
    """Errors about what is in a file name the file."""
    try:
        yield
    except GeodesicError as error:
        error.args = (f"{os.fspath(path)}: {error}",)
        raise
