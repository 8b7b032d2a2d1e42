"""Numbers and arrays of numbers as users pass them."""

from __future__ import annotations

import math
import numbers
import os
from typing import Any, Optional

import numpy as np

from .errors import InvalidArgument

_LARGEST = 2**32 - 1


def to_count(value: Any, name: str, why: str = "ask for at least one") -> int:
    """In [1, 2^32)."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(
            value, numbers.Integral):
        raise InvalidArgument(f"{name} is {value!r}, which is no whole number")
    count = int(value)
    if count < 1:
        raise InvalidArgument(f"{name} is {count}; {why}")
    if count > _LARGEST:
        raise InvalidArgument(f"{name} is {count}; at most {_LARGEST} will do")
    return count


def to_real(value: Any, name: str) -> float:
    """A float, which may be infinite or NaN."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise InvalidArgument(f"{name} is {value!r}, which is no number") from None


def to_threads(threads: Optional[int]) -> int:
    """None: as many as this process may use."""
    if threads is None:
        return len(os.sched_getaffinity(0))
    return to_count(threads, "threads", "at least one has to work")


def to_radius(radius: Optional[float]) -> float:
    """None: +inf."""
    if radius is None:
        return math.inf
    radius = to_real(radius, "radius")
    if not radius >= 0:
        raise InvalidArgument(f"radius is {radius}, which is no distance")
    return radius


def to_array(value: Any, name: str, dtype: Optional[Any] = None) -> np.ndarray:
    """An array, not copied where it is one of that type."""
    if np.ma.is_masked(value):
        raise InvalidArgument(f"{name} has masked elements, which are no numbers: "
                              "leave them out")
    try:
        array = np.asarray(value)
        if dtype is None:
            return array
        if array.dtype.kind == "c":
            raise TypeError("complex numbers are not real")
        return np.asarray(array, dtype)
    except (TypeError, ValueError, OverflowError) as error:
        raise InvalidArgument(f"{name} cannot be an array of numbers: "
                              f"{error}") from None
