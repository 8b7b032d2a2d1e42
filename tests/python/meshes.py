"""Generated meshes, and the meshes from outside the project where they are."""

import os
import pathlib

import numpy as np


def off_text(vertices, faces):
    """A file of the mesh, with every digit."""
    return (f"OFF\n{len(vertices)} {len(faces)} 0\n" +
            "".join("%r %r %r\n" % tuple(v) for v in np.asarray(vertices).tolist()) +
            "".join("3 %d %d %d\n" % tuple(f) for f in faces))


def grid(n, size=1.0, heights=None):
    """A square of (n + 1)^2 vertices in the plane, or a terrain over it."""
    steps = np.linspace(0, size, n + 1)
    x, y = np.meshgrid(steps, steps)
    z = np.zeros(x.size) if heights is None else heights(x.ravel(), y.ravel())
    numbers = np.arange((n + 1)**2).reshape(n + 1, n + 1)
    a, b = numbers[:-1, :-1].ravel(), numbers[:-1, 1:].ravel()
    c, d = numbers[1:, 1:].ravel(), numbers[1:, :-1].ravel()
    faces = np.concatenate(
        [np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    return np.column_stack([x.ravel(), y.ravel(), z]), faces


def terrain(n):
    return grid(n, heights=lambda x, y: 0.15 * np.sin(9 * x) * np.cos(7 * y))


def octahedron():
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0],
                         [0, 0, 1], [0, 0, -1]], float)
    faces = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5],
                      [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    return vertices, faces


def sphere(levels):
    """An octahedron whose faces were cut into four and pushed out."""
    vertices, faces = octahedron()
    for _ in range(levels):
        sides = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        edges, number = np.unique(sides, axis=0, return_inverse=True)
        middle = (len(vertices) + number.reshape(-1, 3)).T
        vertices = np.concatenate([vertices, vertices[edges].mean(axis=1)])
        a, b, c = faces.T
        ab, bc, ca = middle
        faces = np.concatenate([
            np.column_stack(corners)
            for corners in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
        ])
    return vertices / np.linalg.norm(vertices, axis=1)[:, None], faces


def spindle(seed):
    """A closed surface of 12 vertices and 20 faces with saddles: a random
    icosahedron."""
    golden = (1 + 5**0.5) / 2
    vertices = np.array([
        roll for s in (-1, 1) for t in (-golden, golden)
        for roll in ((0, s, t), (s, t, 0), (t, 0, s))
    ])
    lengths = np.linalg.norm(vertices[:, None] - vertices, axis=2)
    near = np.abs(lengths - 2) < 1e-9
    faces = np.array([(a, b, c) for a in range(12) for b in range(a + 1, 12)
                      for c in range(b + 1, 12)
                      if near[a, b] and near[b, c] and near[a, c]])
    random = np.random.default_rng(seed)
    return vertices * random.uniform(0.4, 1.6, (12, 1)), faces


def real_meshes():
    """Files of real meshes, by name; none where there are none."""
    root = pathlib.Path(__file__).resolve().parents[2]
    folder = pathlib.Path(os.environ.get("GEODESIC_TEST_MESHES",
                                         root.parent / "shared" / "meshes"))
    return sorted(
        path for path in folder.glob("real/*")
        if path.suffix.lower() in (".obj", ".ply", ".off", ".stl"))
