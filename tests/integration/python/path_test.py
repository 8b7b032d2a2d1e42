"""Shortest paths and isolines."""

import math
import types

from client_fixture import GRID, INFINITY, ClientTest, main, planar_grid


class PathTest(ClientTest):

    def paths(self, digest, sources, targets, **more):
        """The paths, in order of target."""
        answer = self.ask("ComputePaths", mesh_digest=digest, sources=sources,
                          targets=targets, **more)
        self.assertEqual(len(answer.source), len(targets))
        return [types.SimpleNamespace(source=source, distance=distance,
                                      length=length,
                                      places=[place for place, _ in line],
                                      points=[point for _, point in line])
                for source, distance, length, line in zip(
                    answer.source, answer.distance, answer.length,
                    self.lines(answer))]

    def length(self, points):
        return sum(math.dist(a, b) for a, b in zip(points, points[1:]))

    def test_paths_are_straight(self):
        digest, positions, _ = self.grid()
        source, place = self.face_source()
        last = len(positions) - 1
        ends = self.vertices(0, last)
        for path, vertex in zip(self.paths(digest, [source], ends), (0, last)):
            self.assertEqual(path.source, 0)
            expected = math.dist(place, positions[vertex])
            self.assertAlmostEqual(path.length, expected, delta=1e-10)
            self.assertAlmostEqual(math.dist(path.points[0], place), 0,
                                   delta=1e-10)
            self.assertAlmostEqual(self.length(path.points), expected,
                                   delta=1e-10)

    def test_paths_to_points_on_edges_and_in_faces(self):
        digest, positions, faces = self.grid()
        source, start = self.face_source(offset=0.25)
        targets = self.places()
        for path, target in zip(self.paths(digest, [source], targets), targets):
            end = self.where(target, positions, faces)
            expected = math.dist(start, end)
            self.assertAlmostEqual(path.length, expected, delta=1e-10)
            self.assertAlmostEqual(path.distance, 0.25 + expected,
                                   delta=1e-10)
            points = path.points
            self.assertAlmostEqual(math.dist(points[0], start), 0, delta=1e-10)
            self.assertAlmostEqual(math.dist(points[-1], end), 0, delta=1e-10)
            self.assertAlmostEqual(self.length(points), expected, delta=1e-10)
            # Both forms of a point say the same, and those between the ends
            # are where the straight line crosses edges.
            for place, point in zip(path.places, points):
                self.assertAlmostEqual(
                    math.dist(self.where(place, positions, faces), point), 0,
                    delta=1e-12)
            for place, point in zip(path.places[1:-1], points[1:-1]):
                self.assertIn(place.WhichOneof("place"), ("edge", "vertex"))
                self.assertAlmostEqual(
                    math.dist(start, point) + math.dist(point, end), expected,
                    delta=1e-10)

    def test_a_path_starts_at_the_nearest_of_several(self):
        digest, positions, faces = self.grid()
        curve = self.surface_pb.Curve(points=self.vertices(0, 1, 2))
        sources = [
            self.surface_pb.Source(vertex=len(positions) - 1, offset=0.1),
            self.surface_pb.Source(edge=self.edge(55, 56, 0.5), offset=0.02),
            self.surface_pb.Source(curve=curve),
        ]
        targets = self.places() + self.vertices(1)
        for path, target in zip(self.paths(digest, sources, targets), targets):
            x, y, _ = end = self.where(target, positions, faces)
            ways = [
                0.1 + math.dist(end, positions[-1]),
                0.02 + math.dist(end, (0.05, 0.5, 0)),
                math.hypot(x - min(x, 0.2), y),
            ]
            self.assertAlmostEqual(path.distance, min(ways), delta=1e-10)
            self.assertAlmostEqual(ways[path.source], min(ways), delta=1e-10)
        # The last target lies on the curve: a path of one point.
        self.assertEqual(len(path.points), 1)

    def test_paths_bend_around_a_corner(self):
        # The square without its upper right quarter.
        positions, faces = planar_grid()
        middle = (0.5, 0.5, 0)
        faces = [f for f in faces
                 if any(positions[v][0] < 0.5 or positions[v][1] < 0.5
                        for v in f)]
        digest = self.upload(positions, faces).mesh.digest
        upper, right = GRID * (GRID + 1) + 4, 4 * (GRID + 1) + GRID
        (path,) = self.paths(digest, [self.surface_pb.Source(vertex=upper)],
                           self.vertices(right))
        self.assertAlmostEqual(
            path.length, math.dist(positions[upper], middle) +
            math.dist(middle, positions[right]), delta=1e-10)
        self.assertIn((GRID // 2) * (GRID + 2),
                      [p.vertex for p in path.places
                       if p.WhichOneof("place") == "vertex"])

    def test_what_is_not_reached_has_no_path(self):
        positions, faces = planar_grid()
        alone = len(positions)
        digest = self.upload(positions + [(2.0, 2.0, 0.0)], faces).mesh.digest
        near, far, other = self.paths(
            digest, [self.surface_pb.Source(vertex=0)],
            self.vertices(3, alone - 1, alone), radius=0.5)
        self.assertAlmostEqual(near.length, 0.3, delta=1e-10)
        for path in (far, other):
            self.assertEqual(path.distance, INFINITY)
            self.assertEqual(path.source, 0xffffffff)
            self.assertEqual(path.points, [])

    def test_isolines_are_circles(self):
        digest, positions, _ = self.grid()
        middle = (GRID // 2) * (GRID + 2)
        answer = self.ask(
            "ComputeIsolines", mesh_digest=digest, levels=[0.4, 0.25],
            sources=[self.surface_pb.Source(vertex=middle)])
        self.assertEqual(answer.level, [0.25, 0.4])
        self.assertEqual(answer.is_closed, [1, 1])
        for level, line in zip(answer.level, self.lines(answer)):
            for _, point in line:
                self.assertAlmostEqual(math.dist(point, positions[middle]),
                                       level, delta=1e-10)


if __name__ == "__main__":
    main()
