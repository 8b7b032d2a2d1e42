"""What users of geodesic software have asked for elsewhere, each as a test.

The threads where they asked are named with each.
"""

import importlib.metadata
import pathlib
import re
import types
import unittest

import meshes
import numpy as np
import oracles
import tolerances

import geodesic
from geodesic import _core


class WishesTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.mesh = geodesic.Mesh(*meshes.terrain(30))

    def assert_close(self, got, wanted, relative=tolerances.EXACT):
        np.testing.assert_allclose(got, wanted, rtol=relative,
                                   atol=relative * np.max(wanted))

    def test_01_hundreds_of_pairs_without_whole_fields(self):
        # cgalMeshes #14
        pairs = np.random.default_rng(1).integers(0, self.mesh.n_vertices,
                                                  (300, 2))
        wanted = [self.mesh.distances(int(a))[b] for a, b in pairs]
        self.assert_close(self.mesh.pairs(pairs), wanted)

    def test_02_bounded_search_that_also_gives_the_path(self):
        # pygeodesic #20, #13
        near, far = self.mesh.paths(0, [32, 960], radius=0.3)
        self.assert_close(near.length, self.mesh.distances(0)[32])
        self.assertEqual((len(far), far.distance), (0, np.inf))

    def test_03_all_pairs_in_parallel_with_progress(self):
        # potpourri3d #7, #27, napari-stress #342, brainsmash #1
        small = geodesic.Mesh(*meshes.terrain(15))
        calls = []
        matrix = small.matrix(threads=2,
                              progress=lambda *call: calls.append(call))
        self.assertTrue(calls)
        self.assert_close(matrix, [small.distances(v) for v in range(256)])
        self.assert_close(matrix, matrix.T)

    def test_04_sources_and_targets_in_faces(self):
        # potpourri3d #8, #26
        vertices, faces = meshes.grid(9)
        mesh = geodesic.Mesh(vertices, faces)
        a = geodesic.FacePoint(3, (0.2, 0.3, 0.5))
        b = geodesic.FacePoint(99, (0.6, 0.1, 0.3))
        straight = np.linalg.norm(np.diff(mesh.positions([a, b]), axis=0))
        self.assert_close(mesh.distance(a, b), straight)
        self.assert_close(mesh.path(a, b).length, straight)

    def test_05_paths_as_faces_and_barycentric_weights(self):
        # potpourri3d #33, #35, pygeodesic #18
        path = self.mesh.path(0, 900)
        corners = self.mesh.vertices[self.mesh.faces[path.faces]]
        np.testing.assert_allclose(
            np.einsum("ij,ijk->ik", path.barycentric, corners), path.points,
            atol=tolerances.COORDINATES)

    def test_06_curves_across_faces_split_for_the_user(self):
        # potpourri3d #31, pmp-library #78
        curve = self.mesh.curve([0, 500, 900])
        d = self.mesh.distances(curve)
        self.assertEqual(d[[0, 500, 900]].max(), 0)
        parts = [self.mesh.distances(list(self.mesh.path(a, b).places)).min()
                 for a, b in ((0, 500), (500, 900))]
        self.assertEqual(max(parts), 0)
        self.assertTrue(np.all(d <= self.mesh.distances([0, 500, 900])))

    def test_07_an_exact_oracle_in_python_typed_with_one_dependency(self):
        # compas_cgal #78, trimesh #955, #880
        needed = [line for line in importlib.metadata.requires("geodesic")
                  if "extra ==" not in line]
        self.assertEqual([re.match(r"\w+", line)[0] for line in needed],
                         ["numpy"])
        package = pathlib.Path(geodesic.__file__).parent
        self.assertTrue((package / "py.typed").exists())
        stub = (package / "_core.pyi").read_text(encoding="utf-8")
        for name in vars(_core):
            if not name.startswith("_"):
                self.assertRegex(stub, rf"(?m)^(class |def )?{name}\b")

    def test_08_infinity_where_nothing_leads(self):
        # libigl #2554, pygeodesic #11, #14
        vertices, faces = meshes.octahedron()
        mesh = geodesic.Mesh(np.concatenate([vertices, vertices + 9]),
                             np.concatenate([faces, faces + 6]))
        self.assertTrue(np.all(mesh.distances(0)[6:] == np.inf))
        self.assertEqual(mesh.distance(0, 7), np.inf)
        self.assertTrue(np.all(mesh.matrix([0, 7])[[0, 1], [7, 0]] == np.inf))

    def test_09_no_assertion_on_degenerate_faces(self):
        # libigl #2535, #1013, tvb-gdist #70
        vertices, faces = meshes.grid(6)
        # A vertex on the middle of an edge, joined by a face without area.
        a, b, c = faces[20]
        middle = len(vertices)
        vertices = np.concatenate([vertices, [(vertices[a] + vertices[b]) / 2]])
        faces = np.concatenate([
            np.delete(faces, 20, axis=0),
            [[a, middle, c], [middle, b, c], [a, b, middle]]])
        mesh = geodesic.Mesh(vertices, faces)
        self.assertEqual(mesh.info()["degenerate_faces"], 1)
        self.assert_close(mesh.distances(0),
                          np.linalg.norm(vertices - vertices[0], axis=1))

    def test_10_borders(self):
        # CGAL #6681, #3993, geometry-central #133
        vertices, faces = meshes.grid(10)
        # An L: paths bend around its inner corner.
        outside = np.all(vertices[:, :2] > 0.5 + 1e-9, axis=1)
        mesh = geodesic.Mesh(vertices, faces).without(outside)
        # From one arm's end to the other's, along the edges of the notch.
        self.assert_close(mesh.distances(65)[115], 1)

    def test_11_non_manifold_and_unoriented_meshes(self):
        # napari-stress #413, potpourri3d #18
        vertices = np.array([[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, -1, 0],
                             [0.5, 0, 1]])
        faces = np.array([[0, 1, 2], [0, 1, 3], [1, 0, 4]])  # one edge, three
        mesh = geodesic.Mesh(vertices, faces)
        self.assertEqual(mesh.info()["non_manifold_edges"], 1)
        self.assert_close(mesh.distances(2)[[3, 4]], [2, 2])
        _, oriented = meshes.octahedron()
        turned = oriented.copy()
        turned[::2] = turned[::2, ::-1]
        self.assert_close(
            geodesic.Mesh(meshes.octahedron()[0], turned).distances(0),
            geodesic.Mesh(meshes.octahedron()[0], oriented).distances(0))

    def test_11_places_on_seams_are_those_of_the_file(self):
        vertices, faces = meshes.sphere(3)
        # Each corner a vertex of its own.
        mesh = geodesic.Mesh(vertices[faces].reshape(-1, 3),
                             np.arange(faces.size).reshape(-1, 3), weld=True)
        [to] = np.flatnonzero(np.all(mesh.vertices == -mesh.vertices[0], axis=1))[:1]
        lines = [mesh.path(0, int(to)), *mesh.isolines(0, levels=[0.4, 1.3])]
        self.assertEqual(len(lines), 3)
        for line in lines:
            corners = mesh.vertices[mesh.faces[line.faces]]
            np.testing.assert_allclose(
                np.einsum("ij,ijk->ik", line.barycentric, corners), line.points,
                atol=1e-12)

    def test_12_right_near_sources_on_coarse_meshes_with_several_sources(self):
        # libigl #2442, potpourri3d #30, compas_cgal #73: asked of the heat
        # method; here nothing is approximate.
        vertices, faces = meshes.spindle(4)
        wanted = np.minimum(oracles.brute_force(vertices, faces, 0),
                            oracles.brute_force(vertices, faces, 7))
        self.assert_close(
            geodesic.Mesh(vertices, faces).distances([0, 7]), wanted,
            tolerances.ORACLE)

    def test_13_masks(self):
        # brainsmash #1
        wall = np.abs(self.mesh.vertices[:, 0] - 0.5) < 0.1
        cortex = self.mesh.without(wall)
        d = cortex.distances(0)
        self.assertTrue(np.all(d[self.mesh.vertices[:, 0] > 0.4] == np.inf))
        self.assertEqual(d.shape, (self.mesh.n_vertices,))

    def test_14_polygon_meshes_and_log_map(self):
        # geometry-central #169
        vertices, _ = meshes.grid(6)
        rows = np.arange(49).reshape(7, 7)
        quads = np.stack([rows[:-1, :-1], rows[:-1, 1:], rows[1:, 1:],
                          rows[1:, :-1]], axis=-1).reshape(-1, 4)
        mesh = geodesic.Mesh(types.SimpleNamespace(
            points=vertices,
            cells=[types.SimpleNamespace(type="quad", data=quads)]))
        uv = mesh.log_map(24).coordinates
        self.assert_close(np.linalg.norm(uv, axis=1),
                          np.linalg.norm(vertices - vertices[24], axis=1))

    def test_15_isolines_as_ordered_curves(self):
        # libigl #1290
        vertices, faces = meshes.sphere(3)
        [line] = geodesic.Mesh(vertices, faces).isolines(0, levels=[1.0])
        self.assertTrue(line.closed)
        # Once around the axis, without going back.
        axis = vertices[0]
        around = line.points - np.outer(line.points @ axis, axis)
        turns = [np.arctan2(np.cross(p, q) @ axis, p @ q)
                 for p, q in zip(around, np.roll(around, -1, axis=0))]
        self.assertTrue(np.all(np.sign(turns) == np.sign(turns[0])))
        self.assertAlmostEqual(abs(sum(turns)), 2 * np.pi)


if __name__ == "__main__":
    unittest.main()
