"""Distances computed without any code of the project."""

import heapq

import numpy as np


def _cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def brute_force(vertices, faces, source):
    """Distances by unfolding every sequence of faces; exact, for small meshes.

    From each vertex, faces are laid into the plane one after the other across
    the edges that the straight lines from it can pass; a vertex that such a line
    meets is at that line's length. Shortest paths are chains of such lines. A
    shortest path enters no face twice, which ends the search.
    """
    count = len(vertices)
    beyond = {}
    for number, face in enumerate(faces):
        for i in range(3):
            a, b, c = (int(face[(i + k) % 3]) for k in range(3))
            for key in ((a, b), (b, a)):
                beyond.setdefault(key, []).append((number, c))

    def length(a, b):
        return float(np.linalg.norm(vertices[a] - vertices[b]))

    def lay(a, b, c, at_a, at_b):
        """Where c lies, to the left of a -> b."""
        base = at_b - at_a
        side = np.linalg.norm(base)
        along = (length(a, c)**2 - length(b, c)**2 + side**2) / (2 * side)
        up = np.sqrt(max(length(a, c)**2 - along**2, 0))
        unit = base / side
        return at_a + along * unit + up * np.array([-unit[1], unit[0]])

    lines = np.full((count, count), np.inf)
    for start in range(count):
        lines[start, start] = 0

        def go(a, b, at_a, at_b, right, left, used):
            """Beyond edge a -> b, seen between two directions; the vertex
            `start` is at the origin, on the right of a -> b turned back."""
            for face, c in beyond[(a, b)]:
                if face in used:
                    continue
                at_c = lay(b, a, c, at_b, at_a)
                if (_cross(right, at_c) >= -1e-12 and
                        _cross(at_c, left) >= -1e-12):
                    lines[start, c] = min(lines[start, c],
                                          float(np.linalg.norm(at_c)))
                more = used | {face}
                # Edge a -> c takes the rays right of c, c -> b those left.
                new_left = at_c if _cross(at_c, left) > 0 else left
                if _cross(right, new_left) > 0:
                    go(a, c, at_a, at_c, right, new_left, more)
                new_right = at_c if _cross(right, at_c) > 0 else right
                if _cross(new_right, left) > 0:
                    go(c, b, at_c, at_b, new_right, left, more)

        for number, face in enumerate(faces):
            if start not in face:
                continue
            i = list(face).index(start)
            for a, b in ((int(face[(i + 1) % 3]), int(face[(i + 2) % 3])),
                         (int(face[(i + 2) % 3]), int(face[(i + 1) % 3]))):
                at_a = np.array([length(start, a), 0.0])
                at_b = lay(start, a, b, np.zeros(2), at_a)
                lines[start, a] = min(lines[start, a], length(start, a))
                go(a, b, at_a, at_b, at_a, at_b, frozenset([number]))

    distances = np.full(count, np.inf)
    distances[source] = 0
    open_vertices = set(range(count))
    while open_vertices:
        v = min(open_vertices, key=lambda u: distances[u])
        open_vertices.remove(v)
        distances = np.minimum(distances, distances[v] + lines[v])
    return distances


def along_edges(vertices, faces, source):
    """Dijkstra's distances along edges: never less than the true ones."""
    neighbours = [set() for _ in vertices]
    for a, b, c in faces:
        neighbours[a] |= {b, c}
        neighbours[b] |= {a, c}
        neighbours[c] |= {a, b}
    distances = np.full(len(vertices), np.inf)
    distances[source] = 0
    queue = [(0.0, source)]
    while queue:
        distance, v = heapq.heappop(queue)
        if distance > distances[v]:
            continue
        for u in neighbours[v]:
            step = distance + float(np.linalg.norm(vertices[u] - vertices[v]))
            if step < distances[u]:
                distances[u] = step
                heapq.heappush(queue, (step, u))
    return distances
