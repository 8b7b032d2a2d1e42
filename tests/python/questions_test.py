"""Paths, isolines, matrices and the other questions, from their definitions."""

import unittest
import warnings

import meshes
import numpy as np
import tolerances

import geodesic


class QuestionsTest(unittest.TestCase):
    # service_test.py has these answered elsewhere.
    make = staticmethod(geodesic.Mesh)

    @classmethod
    def setUpClass(cls):
        cls.mesh = cls.make(*meshes.terrain(24))

    def test_nothing_beyond_the_radius_is_told(self):
        mesh = self.make([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
                         [[0, 1, 2], [0, 2, 3]])
        field = mesh.field(0, radius=0.1, labels=True, gradients=True)
        np.testing.assert_array_equal(field.distances, [0] + 3 * [np.inf])
        np.testing.assert_array_equal(field.labels, [0, -1, -1, -1])
        np.testing.assert_array_equal(field.gradients, np.zeros((4, 3)))
        self.assertEqual(field.settled_radius, 0.1)
        for target in (2, geodesic.FacePoint(0, (0.2, 0.3, 0.5))):
            path = mesh.path(0, target, radius=0.1)
            self.assertEqual((path.length, len(path.points)), (np.inf, 0))
        # Nor beyond the last target that was waited for.
        field = mesh.field(0, targets=[2, 1], stop_after_targets=1, labels=True)
        np.testing.assert_array_equal(field.distances, [0, 1, np.inf, 1])
        np.testing.assert_array_equal(field.target_distances, [np.inf, 1])
        np.testing.assert_array_equal(field.labels, [0, 0, -1, 0])

    def test_nothing_is_measured_from_a_source_that_nobody_named(self):
        for ask in (self.mesh.distances, self.mesh.field, self.mesh.labels,
                    self.mesh.gradients, self.mesh.progressive,
                    self.mesh.isolines, self.mesh.log_map, self.mesh.path,
                    self.mesh.paths, self.mesh.nearest, self.mesh.distance,
                    lambda: self.mesh.samples(5), self.mesh.pairs):
            with self.assertRaisesRegex(TypeError, "source"):
                ask()

    def assert_close(self, got, wanted, relative=tolerances.EXACT):
        np.testing.assert_allclose(got, wanted, rtol=relative,
                                   atol=relative * np.max(wanted))

    def assert_on_faces(self, line):
        """Faces and weights give the points, and each piece is in its face."""
        corners = self.mesh.vertices[self.mesh.faces[line.faces]]
        points = np.einsum("ij,ijk->ik", line.barycentric, corners)
        np.testing.assert_allclose(points, line.points,
                                   atol=tolerances.COORDINATES)
        np.testing.assert_allclose(line.barycentric.sum(axis=1), 1,
                                   atol=tolerances.COORDINATES)
        np.testing.assert_allclose(self.mesh.positions(line.places),
                                   line.points, atol=tolerances.COORDINATES)
        # The end of each piece lies in the plane and inside the piece's face.
        for i in range(len(line) - 1):
            a, b, c = corners[i]
            solved, residual, _, _ = np.linalg.lstsq(
                np.column_stack([b - a, c - a]), line.points[i + 1] - a,
                rcond=None)
            self.assertTrue(np.all(solved >= -tolerances.COORDINATES))
            self.assertLess(solved.sum(), 1 + tolerances.COORDINATES)
            if residual.size:
                self.assertLess(residual[0], tolerances.COORDINATES)

    def test_paths(self):
        distances = self.mesh.distances(0)
        targets = [624, 300, geodesic.FacePoint(77, (0.2, 0.3, 0.5)), 0]
        paths = self.mesh.paths(0, targets)
        for path, target in zip(paths, targets):
            with self.subTest(target=target):
                pieces = np.diff(path.points, axis=0)
                self.assert_close(np.linalg.norm(pieces, axis=1).sum(),
                                  path.length)
                wanted = (distances[target] if isinstance(target, int) else
                          self.mesh.distances(0, targets=target)[0])
                self.assert_close(path.distance, wanted)
                self.assertEqual(path.source, 0)
                np.testing.assert_allclose(
                    path.points[[0, -1]],
                    self.mesh.positions([0, target]),
                    atol=tolerances.COORDINATES)
                self.assert_on_faces(path)

    def test_paths_within_a_radius(self):
        whole = self.mesh.distances(0)
        # Though a service has kept a field that reaches further.
        near, far = self.mesh.paths(0, [26, 624], radius=0.3)
        self.assert_close(near.length, whole[26])
        self.assertEqual((len(far), far.distance), (0, np.inf))

    def test_path_that_is_not_there(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(np.concatenate([vertices, [[9, 9, 9]]]), faces)
        path = mesh.path(0, 6)
        self.assertEqual((path.distance, path.length, len(path), path.source),
                         (np.inf, np.inf, 0, None))
        self.assertEqual(path.faces.shape, (0,))
        self.assertEqual(path.barycentric.shape, (0, 3))

    def test_isolines(self):
        lines = self.mesh.isolines(5, levels=[0.2, 0.5])
        self.assertEqual({line.level for line in lines}, {0.2, 0.5})
        for line in lines:
            self.assert_close(self.mesh.distances(5, targets=line.places),
                              np.full(len(line), line.level), tolerances.ORACLE)
            self.assert_on_faces(line)
        by_count = self.mesh.isolines(5, count=4)
        largest = self.mesh.distances(5).max()
        self.assert_close(sorted({line.level for line in by_count}),
                          largest * np.arange(1, 5) / 5)

    def test_isolines_within_a_chord_error(self):
        # A circle inside a face, at sixty degrees a chord and at far less.
        mesh = geodesic.Mesh([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
        source = geodesic.FacePoint(0, (0.5, 0.25, 0.25))
        perimeters = []
        for error in (0.1, 1e-6):
            [line] = mesh.isolines(source, levels=[0.5], chord_error=error)
            self.assertTrue(line.closed)
            pieces = line.points - np.roll(line.points, 1, axis=0)
            perimeters.append(np.linalg.norm(pieces, axis=1).sum())
        self.assertLess(perimeters[0], 0.99 * np.pi)
        self.assertAlmostEqual(perimeters[1], np.pi, delta=1e-5)
        for error in (0, -1, np.nan):
            with self.assertRaisesRegex(geodesic.InvalidArgument,
                                        "chord_error"):
                mesh.isolines(source, levels=[0.5], chord_error=error)

    def test_matrix(self):
        targets = [7, 400, geodesic.FacePoint(77, (0.2, 0.3, 0.5))]
        sources = [3, geodesic.EdgePoint(0, 1, 0.5), 600]
        dense = self.mesh.matrix(sources, targets, threads=2)
        for row, source in zip(dense, sources):
            self.assert_close(row, self.mesh.distances(source, targets=targets))
        whole = self.mesh.matrix([3, 600])
        np.testing.assert_array_equal(whole[1], self.mesh.distances(600))
        single = self.mesh.matrix([3, 600], dtype=np.float32)
        np.testing.assert_array_equal(single, whole.astype(np.float32))
        out = np.full((2, self.mesh.n_vertices), -1.0)
        self.assertIs(self.mesh.matrix([3, 600], out=out), out)
        np.testing.assert_array_equal(out, whole)

    def test_sparse_matrix(self):
        whole = self.mesh.matrix()
        self.assert_close(whole, whole.T)
        near = self.mesh.matrix(radius=0.1)
        self.assertEqual(near.shape, whole.shape)
        kept = np.zeros(whole.shape, bool)
        kept[near.nonzero()] = True
        np.fill_diagonal(kept, True)
        np.testing.assert_array_equal(kept, whole <= 0.1)
        self.assert_close(near.toarray(), np.where(kept, whole, 0))
        # Zeros of the diagonal are entries, too.
        self.assertEqual(near.nnz, kept.sum())

    def test_nearest(self):
        sources, targets = [0, 77, 301], [5, 9, 100, 400, 624]
        wanted = self.mesh.matrix(sources, targets)
        numbers, distances = self.mesh.nearest(sources, targets, k=3)
        np.testing.assert_array_equal(numbers, np.argsort(wanted)[:, :3])
        self.assert_close(distances, np.sort(wanted)[:, :3])
        numbers, distances = self.mesh.nearest(0, [5, 9], k=4)
        np.testing.assert_array_equal(numbers[0, 2:], [-1, -1])
        np.testing.assert_array_equal(distances[0, 2:], [np.inf, np.inf])

    def test_more_sources_than_targets(self):
        # Their distances are found from the targets.
        sources = [*range(0, 600, 12), geodesic.FacePoint(7, (0.2, 0.3, 0.5))]
        offsets = np.linspace(0, 0.5, len(sources))
        targets = [5, geodesic.EdgePoint(0, 1, 0.5), 5]
        wanted = np.array([self.mesh.distances(source, targets=targets)
                           for source in sources]) + offsets[:, None]
        for dtype in (np.float64, np.float32):
            found = self.mesh.matrix(sources, targets, offsets=offsets,
                                     dtype=dtype, threads=2)
            self.assertEqual(found.dtype, dtype)
            self.assert_close(found, wanted.astype(dtype))
        # No distance lies as near to it as rounding may move one.
        radius = np.median(wanted) + 1e-9
        near = wanted <= radius
        sparse = self.mesh.matrix(sources, targets, offsets=offsets,
                                  radius=radius)
        self.assertEqual(sparse.nnz, near.sum())
        self.assert_close(sparse.toarray(), np.where(near, wanted, 0))
        numbers, distances = self.mesh.nearest(sources, targets, k=4,
                                               offsets=offsets)
        # Of the targets that are the same, the first comes first.
        np.testing.assert_array_equal(
            numbers[:, :3], np.argsort(wanted.round(12), axis=1, kind="stable"))
        self.assert_close(distances[:, :3], np.sort(wanted))
        np.testing.assert_array_equal(numbers[:, 3], -1)

    def test_pairs(self):
        random = np.random.default_rng(1)
        pairs = random.integers(0, self.mesh.n_vertices, (40, 2))
        # Enough with one end in common for a field, forwards and backwards.
        shared = np.column_stack([np.full(20, 5), np.arange(20)])
        for asked in (pairs, np.concatenate([pairs, shared]),
                      np.concatenate([pairs, shared[:, ::-1]])):
            wanted = [
                self.mesh.distances(a, targets=int(b))[0] for a, b in asked
            ]
            self.assert_close(self.mesh.pairs(asked, threads=2), wanted)
        self.assert_close(self.mesh.distance(3, 99),
                          self.mesh.distances(3)[99])

    def test_a_source_on_no_face_is_told(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(np.concatenate([vertices, [[9, 9, 9]]]), faces)
        ask = {
            "distances": lambda: mesh.distances([0, 6]),
            "nearest": lambda: mesh.nearest(6, [0, 1]),
            "progressive": lambda: list(mesh.progressive(6)),
            "matrix": lambda: mesh.matrix([6], [0]),
            "isolines": lambda: mesh.isolines([0, 6], levels=[0.5]),
            "samples": lambda: mesh.samples(2, 6),
        }
        for name, question in ask.items():
            with self.subTest(name), self.assertWarnsRegex(
                    geodesic.GeodesicWarning, "vertex 6 is on no face") as caught:
                question()
            # It is told of the line that asked.
            self.assertEqual(caught.filename, __file__)
        # All vertices, which nobody named; and meshes without such vertices.
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            mesh.matrix(targets=[0])
            mesh.distances(0)
            self.mesh.distances(0)

    def test_why_a_target_is_not_reached(self):
        # Two squares side by side that share no vertex, a third far away, and a
        # vertex of no face.
        square, faces = meshes.grid(1)
        moved = [square + [x, 0, 0] for x in (0, 1, 5)]
        mesh = self.make(np.concatenate(moved + [[[7, 7, 7]]]),
                         np.concatenate([faces, faces + 4, faces + 8]))
        for sources, target, radius, why in (
                (0, 4, None, r"another component of the mesh; it touches others "
                             r"at 2 points, where vertices lie twice \(4 and 1"),
                ([0, 12], geodesic.FacePoint(4, (1, 0, 0)), None,
                 "another component of the mesh$"),
                (0, 12, None, "vertex 12 is on no face"),
                (0, 3, 0.5, "farther than the radius, 0.5"),
                (12, 3, None, "vertex 12, the source, is on no face")):
            with self.assertWarnsRegex(geodesic.GeodesicWarning,
                                       "cannot be reached: .*" + why):
                path = mesh.path(sources, target, radius=radius)
            self.assertRegex(path.unreached, why)
            self.assertEqual(path.distance, np.inf)
        self.assertIsNone(mesh.path(0, 3).unreached)
        with self.assertWarnsRegex(geodesic.GeodesicWarning, "lie twice"):
            self.assertEqual(mesh.distance(0, 4), np.inf)
        with self.assertRaisesRegex(geodesic.InvalidArgument,
                                    "from places.0. to the next: it lies in"):
            mesh.curve([0, 9])

    def test_curves_tell_what_was_added(self):
        vertices, faces = meshes.grid(4)
        mesh = self.make(vertices, faces)
        # Along a side, and back to its beginning: three vertices between, twice.
        curve = mesh.curve([0, 4], closed=True)
        self.assertEqual((curve.added, len(curve.points)), (6, 9))
        self.assert_close(curve.length, 2)
        self.assertRegex(repr(curve), "9 points, 6 of them added, length 2")
        # Neighbours need nothing between them.
        self.assertEqual(mesh.curve([0, 1, 2]).added, 0)

    def test_fewer_samples_than_asked_for_are_told(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(vertices, faces)
        with self.assertWarnsRegex(geodesic.GeodesicWarning,
                                   "100 samples were asked for and 5 are there"):
            found, _ = mesh.samples(100, 0)
        self.assertEqual(sorted(found), [1, 2, 3, 4, 5])

    def test_many_pairs(self):
        # Enough for landmarks, which bound what a search opens.
        pairs = np.random.default_rng(4).integers(0, self.mesh.n_vertices,
                                                  (1200, 2))
        whole = self.mesh.matrix()
        self.assert_close(self.mesh.pairs(pairs), whole[pairs[:, 0], pairs[:, 1]])
        self.assert_close(self.mesh.pairs(pairs, threads=3),
                          whole[pairs[:, 0], pairs[:, 1]])

    def test_samples(self):
        vertices, distances = self.mesh.samples(8, source=3)
        nearest = self.mesh.distances(3)
        for vertex, distance in zip(vertices, distances):
            self.assert_close(distance, nearest.max())
            self.assert_close(nearest[vertex], nearest.max())
            nearest = np.minimum(nearest, self.mesh.distances(int(vertex)))

    def test_labels_and_gradients(self):
        sources = [3, 99, 500]
        field = self.mesh.field(sources, labels=True, gradients=True)
        each = self.mesh.matrix(sources)
        self.assert_close(each[field.labels, np.arange(each.shape[1])],
                          each.min(axis=0))
        np.testing.assert_array_equal(field.labels, self.mesh.labels(sources))
        lengths = np.linalg.norm(field.gradients, axis=1)
        away = np.ones(len(lengths), bool)
        away[sources] = False
        self.assert_close(lengths[away], np.ones(away.sum()))
        np.testing.assert_array_equal(lengths[sources], 0)
        plane_vertices, faces = meshes.grid(9)
        gradients = self.make(plane_vertices, faces).gradients(0)
        wanted = plane_vertices - plane_vertices[0]
        wanted[1:] /= np.linalg.norm(wanted[1:], axis=1)[:, None]
        np.testing.assert_allclose(gradients, wanted,
                                   atol=tolerances.COORDINATES)

    def test_labels_of_what_is_not_reached(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(np.concatenate([vertices, [[9, 9, 9]]]), faces)
        np.testing.assert_array_equal(mesh.labels([0, 1])[[0, 1, 6]],
                                      [0, 1, -1])

    def test_log_map_of_plane(self):
        vertices, faces = meshes.grid(10)
        mesh = self.make(vertices, faces)
        source = 60
        log_map = mesh.log_map(source)
        around = vertices[:, :2] - vertices[source, :2]
        x = log_map.zero_direction[:2]
        y = np.array([-x[1], x[0]])
        np.testing.assert_allclose(log_map.coordinates,
                                   np.column_stack([around @ x, around @ y]),
                                   atol=tolerances.COORDINATES)
        near = mesh.log_map(source, radius=0.25).coordinates
        np.testing.assert_array_equal(
            np.isnan(near[:, 0]), np.linalg.norm(around, axis=1) > 0.25)

    def test_lines_of_plane(self):
        vertices, faces = meshes.grid(10)
        mesh = self.make(vertices, faces)
        source, length = 60, 0.3
        start = vertices[source]
        for way in ([1, 0, 0], [-0.3, 0.7, 0], [0.2, -1, 0]):
            line = mesh.trace(source, direction=way, length=length)
            np.testing.assert_allclose(
                line.points[-1], start + length * np.array(way) /
                np.linalg.norm(way), atol=tolerances.COORDINATES)
            self.assertEqual((line.length, line.end), (length, "length"))
            np.testing.assert_allclose(mesh.positions(line.places), line.points,
                                       atol=tolerances.COORDINATES)
        line = mesh.trace(source, towards=source + 1)
        self.assertEqual(line.end, "boundary")
        # The log map says where they lead.
        log_map = mesh.log_map(source)
        inner = [v for v in range(len(vertices)) if 0 < np.linalg.norm(
            log_map.coordinates[v]) < 0.4]
        u, v = log_map.coordinates[inner].T
        lines = mesh.trace(source, angle=np.arctan2(v, u),
                           length=np.hypot(u, v))
        self.assertEqual(len(lines), len(inner))
        for vertex, line in zip(inner, lines):
            np.testing.assert_allclose(line.points[-1], vertices[vertex],
                                       atol=tolerances.COORDINATES)
        with self.assertRaisesRegex(geodesic.InvalidArgument, "name one"):
            mesh.trace(source, length=1)
        with self.assertRaisesRegex(geodesic.InvalidArgument, "right angles"):
            mesh.trace(source, direction=[0, 0, 1], length=1)

    def test_nearest_point_of_far_points_and_of_any_size(self):
        vertices, faces = meshes.octahedron()
        for size in (1e-200, 1, 1e200):
            mesh = geodesic.Mesh(vertices * size, faces)
            for far in (3, 1e9, 1e20, 1e100):
                with np.errstate(all="raise"):
                    places = mesh.nearest_point(vertices * size * far)
                np.testing.assert_array_equal(mesh.positions(places),
                                              vertices * size)
        mesh = geodesic.Mesh(vertices, faces)
        for far in (1e200, 1.7e308):
            np.testing.assert_array_equal(
                mesh.positions(mesh.nearest_point(vertices * far)), vertices)
        # Straight above a square, however high.
        square = geodesic.Mesh(*meshes.grid(4))
        for height in (0, 1, 1e9, 1e100):
            np.testing.assert_allclose(
                square.positions([square.nearest_point([0.3, 0.6, height])]),
                [[0.3, 0.6, 0]], atol=tolerances.COORDINATES)

    def test_nearest_point(self):
        random = np.random.default_rng(2)
        points = random.uniform(-0.2, 1.2, (20, 3))
        found = self.mesh.positions(self.mesh.nearest_point(points))
        # No point of a fine sampling of every face is nearer.
        weights = np.array([(i, j, 12 - i - j) for i in range(13)
                            for j in range(13 - i)]) / 12
        sampled = np.einsum("wc,fcx->fwx", weights,
                            self.mesh.vertices[self.mesh.faces]).reshape(-1, 3)
        for point, there in zip(points, found):
            best = np.min(np.linalg.norm(sampled - point, axis=1))
            self.assertLessEqual(np.linalg.norm(there - point),
                                 best + tolerances.COORDINATES)
        on_vertex = self.mesh.nearest_point(self.mesh.vertices[17])
        self.assertEqual(self.mesh.distances(on_vertex)[17], 0)


if __name__ == "__main__":
    unittest.main()
