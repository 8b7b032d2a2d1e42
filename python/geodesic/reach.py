"""What can be reached on a mesh, and why something cannot."""

from __future__ import annotations

import sys
import warnings
from typing import Callable

import numpy as np

from .digest import Reading
from .errors import GeodesicWarning
from .face_geometry import in_surface
from .places import Places, Sources

# Of many numbers, a message names so many.
_MOST_NAMED = 3


def joined_into(reading: Reading, count: int) -> np.ndarray:
    """The vertex that each of the `count` vertices was joined into, or itself."""
    into = np.arange(count)
    into[reading[0][:, 0]] = reading[0][:, 1]
    return into


def warn(message: str) -> None:
    """In the name of the line that called this package."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get(
            "__name__", "").startswith("geodesic."):
        level, frame = level + 1, frame.f_back
    warnings.warn(message, GeodesicWarning, stacklevel=level)


def warn_of_isolated(sources: Sources,
                     isolated: Callable[[np.ndarray], np.ndarray]) -> None:
    """Says which sources are vertices of no face."""
    places = sources.places
    numbers = places.numbers[places.kinds == 0, 0]
    numbers = np.unique(numbers)
    if numbers.size == 0:
        return
    found = numbers[isolated(numbers)]
    if found.size:
        named = ", ".join(map(str, found[:_MOST_NAMED].tolist()))
        if found.size > _MOST_NAMED:
            named += f" and {found.size - _MOST_NAMED} more"
        warn(f"sources: {'vertex' if found.size == 1 else 'vertices'} {named} "
             f"{'is' if found.size == 1 else 'are'} on no face: nothing else can "
             "be reached from there")


def _component(faces: np.ndarray, count: int, start: int) -> np.ndarray:
    """Which vertices are in the component of one of them, bool (V,)."""
    corners = np.argsort(faces, axis=None, kind="stable")  # by vertex
    ends = np.cumsum(np.bincount(faces.reshape(-1), minlength=count))
    reached = np.zeros(count, bool)
    reached[start] = True
    front = np.array([start])
    while front.size:
        sizes = ends[front] - np.where(front > 0, ends[front - 1], 0)
        within = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes,
                                                    sizes)
        around = corners[np.repeat(ends[front] - sizes, sizes) + within] // 3
        front = np.unique(faces[around])
        front = front[~reached[front]]
        reached[front] = True
    return reached


def _vertices(places: Places, faces: np.ndarray) -> np.ndarray:
    """A vertex of the element that each place lies in, (N,)."""
    vertices = places.numbers[:, 0].astype(np.int64)
    in_face = places.kinds == 2
    vertices[in_face] = faces[vertices[in_face], 0]
    return vertices


def why_unreached(vertices: np.ndarray, faces: np.ndarray, reading: Reading,
                  sources: Sources, target: Places, radius: float) -> str:
    """In words, why no path leads to the one place in `target`."""
    into = joined_into(reading, len(vertices))
    faces = into[faces]
    surface = faces[in_surface(faces)]
    isolated = np.ones(len(vertices), bool)
    isolated[surface] = False
    [to] = into[_vertices(target, faces)]
    starts = into[_vertices(sources.places, faces)]
    if isolated[to]:
        return f"vertex {to} is on no face"
    if isolated[starts].all():
        return f"vertex {starts[0]}, the source, is on no face"
    there = _component(surface, len(vertices), int(to))
    if not there[starts].any():
        return ("it lies in another component of the mesh" +
                _seam(vertices, there, ~(there | isolated)))
    if radius < np.inf:
        return f"it is farther than the radius, {radius:g}"
    return "no path leads there"


def _seam(vertices: np.ndarray, there: np.ndarray, others: np.ndarray) -> str:
    """Says where it touches others without sharing vertices, if it does."""

    def rows(mask):
        # 0 and -0 are the same.
        return np.ascontiguousarray(vertices[mask] + 0.0).view(
            [("", np.float64)] * 3).reshape(-1)

    shared, first, second = np.intersect1d(rows(there), rows(others),
                                           return_indices=True)
    if shared.size == 0:
        return ""
    a, b = np.flatnonzero(there)[first[0]], np.flatnonzero(others)[second[0]]
    points = "1 point" if shared.size == 1 else f"{shared.size} points"
    return (f"; it touches others at {points}, where vertices lie twice ({a} and "
            f"{b}, say): merge them to let paths pass")
