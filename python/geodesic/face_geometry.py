"""Geometry of single faces: where places lie, and which faces hold them."""

from __future__ import annotations

from typing import Tuple

import numpy as np

from .places import FacePoint, Places


def in_surface(faces: np.ndarray) -> np.ndarray:
    """The numbers of the faces that name three vertices; others are left out."""
    a, b, c = faces.T
    return np.flatnonzero((a != b) & (b != c) & (c != a))


class FaceFinder:
    """Faces by their edges, which are the same where vertices were joined.
    `into` (V,): the vertex that each was joined into. O(F log F) once."""

    def __init__(self, faces: np.ndarray, into: np.ndarray) -> None:
        self._into = into
        self._named = faces
        self._faces = into[faces]
        self._numbers = in_surface(self._faces)
        faces = self._faces[self._numbers]
        first = faces.reshape(-1).astype(np.uint64)
        second = faces[:, [1, 2, 0]].reshape(-1).astype(np.uint64)
        keys = (np.minimum(first, second) << np.uint64(32)) | np.maximum(
            first, second)
        order = np.argsort(keys, kind="stable")
        self._keys = keys[order]
        self._face_of_key = np.repeat(self._numbers, 3)[order]

    def _corners(self, places: Places, i: int) -> set:
        """The vertices of the lowest element that holds place i."""
        kind, numbers = places.kinds[i], places.numbers[i]
        if kind == 0:
            return {int(numbers[0])}
        if kind == 1:
            return {int(numbers[0]), int(numbers[1])}
        return set(self._named[numbers[0]].tolist())

    def face_with(self, named: set) -> int:
        """A face that has all these vertices, or those that they were joined
        with; where sheets lie on each other, the one that has most of them by
        these numbers. -1 if there is none."""
        corners = {int(self._into[vertex]) for vertex in named}
        if len(corners) == 1:
            [vertex] = corners
            holds = np.any(self._faces[self._numbers] == vertex, axis=1)
            return int(self._numbers[np.argmax(holds)]) if holds.any() else -1
        low, high = sorted(corners)[:2]
        key = np.uint64(low << 32 | high)
        at = np.searchsorted(self._keys, key)
        best, most = -1, -1
        while at < len(self._keys) and self._keys[at] == key:
            face = int(self._face_of_key[at])
            at += 1
            if not corners <= set(self._faces[face].tolist()):
                continue
            common = len(named & set(self._named[face].tolist()))
            if common > most:
                best, most = face, common
        return best

    def along(self, places: Places) -> Tuple[np.ndarray, np.ndarray]:
        """For a polyline on the surface: the face in which the piece after each
        point runs (for the last point: before it), int64 (P,), and the point's
        barycentric weights there, (P, 3)."""
        count = len(places)
        faces = np.full(count, -1, np.int64)
        weights = np.zeros((count, 3))
        corners = [self._corners(places, i) for i in range(count)]
        for i in range(count - 1):
            in_face = next((int(places.numbers[j, 0])
                            for j in (i, i + 1) if places.kinds[j] == 2), None)
            faces[i] = (self.face_with(corners[i] | corners[i + 1])
                        if in_face is None else in_face)
        if count > 1:
            faces[-1] = faces[-2]
        elif count == 1:
            faces[0] = (places.numbers[0, 0] if places.kinds[0] == 2 else
                        self.face_with(corners[0]))
        for i in range(count):
            if faces[i] < 0:
                continue
            of_face = self._faces[faces[i]]
            if places.kinds[i] == 0:
                weights[i, of_face == self._into[places.numbers[i, 0]]] = 1
            elif places.kinds[i] == 1:
                t = places.weights[i, 0]
                first, second = self._into[places.numbers[i, :2]]
                weights[i, of_face == first] = 1 - t
                weights[i, of_face == second] = t
            else:
                weights[i] = places.weights[i]
        return faces, weights


def nearest_on_faces(point: np.ndarray, corners: np.ndarray,
                     reference: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """The nearest point of each triangle: barycentric weights (N, 3), and how
    much its squared distance is more than that of `reference` (N,). `corners`
    has shape (N, 3, 3)."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    ab, ac = b - a, c - a
    normal = np.cross(ab, ac)
    area = np.einsum("ij,ij->i", normal, normal)
    best = np.full(len(corners), np.inf)
    weights = np.zeros((len(corners), 3))

    def offer(candidate: np.ndarray, valid: np.ndarray) -> None:
        there = np.einsum("ij,ijk->ik", candidate, corners)
        # |there - point|^2 - |reference - point|^2 without large numbers that
        # cancel.
        squared = np.sum((there - reference) *
                         ((there - point) + (reference - point)), axis=1)
        better = valid & (squared < best)
        best[better] = squared[better]
        weights[better] = candidate[better]

    # The foot of the perpendicular, where it falls into the triangle.
    with np.errstate(divide="ignore", invalid="ignore",
                     over="ignore"):
        to_point = point - a
        w_c = np.einsum("ij,ij->i", np.cross(ab, to_point), normal) / area
        w_b = np.einsum("ij,ij->i", np.cross(to_point, ac), normal) / area
    inside = np.stack([1 - w_b - w_c, w_b, w_c], axis=1)
    valid = np.all(inside >= 0, axis=1)
    inside[~valid] = 0
    offer(inside, valid)
    # The nearest point of each side, corners included.
    everywhere = np.ones(len(corners), bool)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        side = corners[:, j] - corners[:, i]
        length = np.einsum("ij,ij->i", side, side)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            t = np.einsum("ij,ij->i", point - corners[:, i], side) / length
        t = np.clip(np.nan_to_num(t), 0, 1)
        on_side = np.zeros((len(corners), 3))
        on_side[:, i] = 1 - t
        on_side[:, j] = t
        offer(on_side, everywhere)
    return weights, best


# Points farther away than this, in sizes of the mesh, are taken for points in
# the same direction: the squares of their coordinates are still numbers.
_FARTHEST = 1e150
# More than the rounding of squared distances.
_ROUNDING = 1e-12


# Faces that share a box: searches try as many boxes as there are such groups.
_GROUP = 64


def _along_curve(points: np.ndarray) -> np.ndarray:
    """An order in which points that follow each other are near each other: that
    of a curve through the cells of a grid, of 1024 along each side."""
    low = points.min(axis=0)
    extent = max(np.ptp(points, axis=0).max(), 1e-300)  # 1 over it is a number
    cells = ((points - low) * (1023 / extent)).astype(np.int64)
    code = np.zeros(len(points), np.int64)
    for bit in range(10):
        for axis in range(3):
            code |= (cells[:, axis] >> bit & 1) << (3 * bit + axis)
    return np.argsort(code, kind="stable")


def _to_boxes(point: np.ndarray, low: np.ndarray, high: np.ndarray,
              ) -> np.ndarray:
    """The squared distance to each box, (N,)."""
    gap = np.maximum(np.maximum(low - point, point - high), 0)
    return np.sum(gap**2, axis=1)


class PointFinder:
    """Nearest points of a surface to points in space. O(F log F) once, and for
    each a look at the boxes of groups of faces, and at the faces of a few."""

    def __init__(self, vertices: np.ndarray, faces: np.ndarray) -> None:
        # Coordinates of at most 1, by a power of two, which rounds nothing.
        self._exponent = int(np.frexp(np.abs(vertices).max(initial=0))[1])
        self._vertices = np.ldexp(vertices, -self._exponent)
        self._faces = faces
        corners = self._vertices[faces]
        numbers = in_surface(faces)
        order = numbers[_along_curve(corners[numbers].mean(axis=1))]
        # The last group is filled up with its last face.
        groups = np.resize(order, (-(-len(order) // _GROUP), _GROUP))
        groups.reshape(-1)[len(order):] = order[-1]
        self._groups = groups
        self._low = corners.min(axis=1)
        self._high = corners.max(axis=1)
        self._middles = corners[groups[:, _GROUP // 2], 0]
        self._group_low = self._low[groups].min(axis=1)
        self._group_high = self._high[groups].max(axis=1)

    def nearest(self, point: np.ndarray) -> FacePoint:
        """A nearest point."""
        exponent = int(np.frexp(np.abs(point).max())[1])
        if exponent - self._exponent > np.log2(_FARTHEST):
            point = np.ldexp(point, -exponent) * _FARTHEST
        else:
            point = np.ldexp(point, -self._exponent)
        # Only what lies in boxes that come as near as a corner of the group whose
        # middle seems nearest can win.
        near = np.argmin(np.sum((self._middles - point)**2, axis=1))
        corners = self._vertices[self._faces[self._groups[near]]].reshape(-1, 3)
        to_corners = np.sum((corners - point)**2, axis=1)
        reference = corners[np.argmin(to_corners)]
        bound = to_corners.min() * (1 + _ROUNDING)
        box = _to_boxes(point, self._group_low, self._group_high)
        candidates = np.sort(self._groups[box <= bound].reshape(-1))
        box = _to_boxes(point, self._low[candidates], self._high[candidates])
        candidates = candidates[box <= bound]
        # From far away all squared distances would be the same up to rounding:
        # a vertex is what they are compared with.
        is_far = np.abs(point).max() > 2
        weights, squared = nearest_on_faces(
            point, self._vertices[self._faces[candidates]],
            reference if is_far else point)
        best = int(np.argmin(squared))
        one, two, three = weights[best].tolist()
        return FacePoint(int(candidates[best]), (one, two, three))
