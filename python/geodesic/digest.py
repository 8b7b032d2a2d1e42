"""The name of a mesh on every server (docs/protocol.md)."""

from __future__ import annotations

import hashlib
from typing import Sequence, Tuple

import numpy as np


# Joined vertices (J, 2); seam edges, crossing polygons and the first of these.
Reading = Tuple[np.ndarray, Sequence[int]]

# Of a mesh where nothing was joined.
PLAIN: Reading = (np.empty((0, 2), np.uint32), (0, 0, 0))


def mesh_digest(vertices: np.ndarray, faces: np.ndarray,
                reading: Reading = PLAIN) -> str:
    """The sha-256 of a mesh's arrays: float64 (V, 3), and (F, 3) of 32 bits; and
    of what was joined or guessed, if something was."""
    name = hashlib.sha256(b"geodesic.mesh.v1\n")
    name.update(np.array([len(vertices), len(faces)], "<u8").tobytes())
    name.update(np.ascontiguousarray(vertices.astype("<f8", copy=False)).data)
    name.update(np.ascontiguousarray(
        faces.astype(faces.dtype.newbyteorder("<"), copy=False)).data)
    joined, numbers = reading
    if len(joined) or any(numbers):
        name.update(np.array([*numbers, len(joined)], "<u8").tobytes())
        name.update(np.ascontiguousarray(joined.astype("<u4")).data)
    return name.hexdigest()
