"""The name of a mesh on every server (docs/protocol.md)."""

from __future__ import annotations

import hashlib

import numpy as np


def mesh_digest(vertices: np.ndarray, faces: np.ndarray) -> str:
    """The sha-256 of a mesh's arrays: float64 (V, 3), and (F, 3) of 32 bits."""
    name = hashlib.sha256(b"geodesic.mesh.v1\n")
    name.update(np.array([len(vertices), len(faces)], "<u8").tobytes())
    name.update(np.ascontiguousarray(vertices.astype("<f8", copy=False)).data)
    name.update(np.ascontiguousarray(
        faces.astype(faces.dtype.newbyteorder("<"), copy=False)).data)
    return name.hexdigest()
