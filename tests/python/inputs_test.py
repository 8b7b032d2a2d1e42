"""What meshes are made of, and what is said of what they cannot be."""

import copy
import gzip
import pathlib
import pickle
import tempfile
import types
import unittest

import meshes
import numpy as np
import tolerances

import geodesic


class Refusing(unittest.TestCase):

    def assert_refused(self, words, call, *arguments, **named):
        with self.assertRaises(geodesic.InvalidArgument) as caught:
            call(*arguments, **named)
        self.assertIn(words, str(caught.exception))
        self.assertIsInstance(caught.exception, ValueError)


class RefusedQuestionsTest(Refusing):
    """service_test.py asks the same of a mesh of a service."""

    make = geodesic.Mesh

    def test_a_mesh_never_changes(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(vertices, faces)
        digest, wanted = mesh.digest, mesh.distances(0)
        for name, other in (("vertices", 2 * vertices), ("faces", faces[1:]),
                            ("kept_faces", np.arange(8)), ("digest", "other"),
                            ("n_vertices", 7), ("n_faces", 7)):
            with self.subTest(name=name):
                with self.assertRaises(AttributeError):
                    setattr(mesh, name, other)
                with self.assertRaises(AttributeError):
                    delattr(mesh, name)
        np.testing.assert_array_equal(mesh.vertices, vertices)
        np.testing.assert_array_equal(mesh.faces, faces)
        self.assertIsNone(mesh.kept_faces)
        self.assertEqual(mesh.digest, digest)
        np.testing.assert_array_equal(mesh.distances(0), wanted)

    def test_weights_that_were_rounded_to_six_digits(self):
        mesh = self.make(*meshes.octahedron())
        weights = np.array([0.333334, 0.333334, 0.333333])
        place = geodesic.FacePoint(0, tuple(weights))
        corners = mesh.vertices[mesh.faces[0]]
        wanted = weights @ corners / weights.sum()
        np.testing.assert_allclose(mesh.positions([place]), [wanted],
                                   rtol=tolerances.EXACT)
        np.testing.assert_allclose(mesh.distance(place, int(mesh.faces[0, 0])),
                                   np.linalg.norm(wanted - corners[0]),
                                   rtol=tolerances.EXACT)

    def test_refused_types(self):
        vertices, faces = meshes.octahedron()
        mesh = self.make(vertices, faces)
        for name in ("samples", "threads", "k"):
            ask = {"samples": lambda n: mesh.samples(n, 0),
                   "threads": lambda n: mesh.distances(0, threads=n),
                   "k": lambda n: mesh.nearest(0, [1], n)}[name]
            shown = {"samples": "count"}.get(name, name)
            for value in (0, -1, 1.5, True, "x", 2**70):
                self.assert_refused(f"{shown} is {value!r}", ask, value)
        self.assert_refused("k is 2147483647", mesh.nearest, 0, [1], 2**31 - 1)
        for words, place in (
            ("places[1].vertex 6 is out of range", 6),
            ("places[1].face.face 8 is out of range",
             geodesic.FacePoint(8, (0.2, 0.3, 0.5))),
            ("places[1].edge.to 6 is out of range",
             geodesic.EdgePoint(0, 6, 0.5)),
            ("places[1].edge.t 1.5", geodesic.EdgePoint(0, 2, 1.5)),
            ("places[1].edge.t nan", geodesic.EdgePoint(0, 2, np.nan)),
            ("places[1].edge: the mesh has no edge between vertices 0 and 1",
             geodesic.EdgePoint(0, 1, 0.5)),
            ("places[1].face.weights sum to 1.5",
             geodesic.FacePoint(0, (0.5, 0.5, 0.5))),
            ("places[1].face.weights[1] -0.5",
             geodesic.FacePoint(0, (1.5, -0.5, 0))),
            ("places[1].face.weights[0] nan",
             geodesic.FacePoint(0, (np.nan, 0, 1)))):
            self.assert_refused(words, mesh.positions, [0, place])
        self.assert_refused("count is 0", mesh.isolines, 0, count=0)
        self.assert_refused("levels and count", mesh.isolines, 0, count=2,
                            levels=[1])
        self.assert_refused("levels cannot be", mesh.isolines, 0, levels="x")
        self.assert_refused("stop_after_targets is 1.5", mesh.field, 0,
                            stop_after_targets=1.5)
        self.assert_refused("interval is nan", mesh.progressive, 0,
                            interval=np.nan)
        self.assert_refused("radius is 'x'", mesh.distances, 0, radius="x")
        self.assert_refused("offsets cannot be", mesh.distances, 0, offsets="a")
        self.assert_refused("out is of type list", mesh.matrix, 0, [0],
                            out=[[0]])
        self.assert_refused("dtype is 'x'", mesh.matrix, 0, dtype="x")
        self.assert_refused("dtype is int64", mesh.matrix, 0, dtype=int)
        self.assert_refused("progress is 3", mesh.distances, 0, progress=3)
        self.assert_refused("progress is 'x'", mesh.samples, 1, 0, progress="x")
        self.assert_refused("algorithm is 3", mesh.distances, 0, algorithm=3)
        self.assert_refused("sources cannot be", mesh.distances,
                            [0, np.arange(2)])
        self.assert_refused("pairs cannot be", mesh.pairs, [[0, 1], [2]])
        self.assert_refused("pairs(sources, targets)", mesh.pairs,
                            [[geodesic.EdgePoint(0, 2, 0.5), 1]])
        self.assert_refused("sources[0].t is 'x'", mesh.distances,
                            geodesic.EdgePoint(0, 2, "x"))
        self.assert_refused("sources[0].weights", mesh.distances,
                            geodesic.FacePoint(0, "abc"))
        self.assert_refused("xyz cannot be", mesh.nearest_point, "abc")
        self.assert_refused("vertices cannot be", self.make,
                            [[0, 0, 0], [1, 0]], faces)
        self.assert_refused("faces cannot be", self.make, vertices,
                            [[0, 1, 2], [1, 0]])


class InputsTest(Refusing):

    def setUp(self):
        self.vertices, self.faces = meshes.octahedron()
        self.wanted = geodesic.Mesh(self.vertices, self.faces)

    def assert_same(self, mesh):
        np.testing.assert_array_equal(mesh.vertices, self.wanted.vertices)
        np.testing.assert_array_equal(mesh.faces, self.wanted.faces)
        self.assertEqual(mesh.digest, self.wanted.digest)

    def test_places_on_seams_are_those_of_the_file(self):
        vertices, faces = meshes.sphere(3)
        # Each corner a vertex of its own.
        mesh = geodesic.Mesh(vertices[faces].reshape(-1, 3),
                             np.arange(faces.size).reshape(-1, 3), weld=True)
        to = np.flatnonzero(np.all(mesh.vertices == -mesh.vertices[0], axis=1))
        lines = [mesh.path(0, int(to[0])),
                 *mesh.isolines(0, levels=[0.4, 1.3])]
        self.assertEqual(len(lines), 3)
        for line in lines:
            corners = mesh.vertices[mesh.faces[line.faces]]
            np.testing.assert_allclose(
                np.einsum("ij,ijk->ik", line.barycentric, corners), line.points,
                atol=1e-12)

    def test_types_and_layouts(self):
        for kind in (np.int8, np.uint16, np.int32, np.uint32, np.int64,
                     np.uint64, ">i4"):
            self.assert_same(
                geodesic.Mesh(self.vertices, self.faces.astype(kind)))
        self.assert_same(
            geodesic.Mesh(np.asfortranarray(self.vertices),
                          np.asfortranarray(self.faces)))
        self.assert_same(geodesic.Mesh(self.vertices.astype(np.float32),
                                       self.faces))
        self.assert_same(geodesic.Mesh(self.vertices.astype(int), self.faces))
        self.assert_same(geodesic.Mesh(self.vertices.tolist(),
                                       self.faces.tolist()))
        backwards = geodesic.Mesh(self.vertices, self.faces[::-1])
        np.testing.assert_array_equal(backwards.faces, self.faces[::-1])

    def test_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "octahedron.off"
            path.write_text(meshes.off_text(self.vertices, self.faces))
            self.assert_same(geodesic.Mesh(path))
            self.assert_same(geodesic.Mesh(str(path)))
            packed = pathlib.Path(folder) / "octahedron.off.gz"
            packed.write_bytes(gzip.compress(path.read_bytes()))
            self.assert_same(geodesic.Mesh(packed))
            bad = pathlib.Path(folder) / "bad.off"
            bad.write_text("OFF\n1 1 0\n0 0 zero\n3 0 0 0\n")
            self.assert_refused("line 3", geodesic.Mesh, bad)
            self.assert_refused("faces come from the file", geodesic.Mesh,
                                path, self.faces)
            picture = pathlib.Path(folder) / "a.gif"
            picture.touch()
            self.assert_refused(".gif", geodesic.Mesh, picture)
            with self.assertRaises(FileNotFoundError):
                geodesic.Mesh(pathlib.Path(folder) / "none.off")

    def test_meshes_of_other_libraries(self):
        # As trimesh, PyVista and meshio show theirs.
        self.assert_same(
            geodesic.Mesh(
                types.SimpleNamespace(vertices=self.vertices,
                                      faces=self.faces)))
        flat = np.column_stack([np.full(8, 3), self.faces]).reshape(-1)
        self.assert_same(
            geodesic.Mesh(
                types.SimpleNamespace(points=self.vertices, faces=flat)))
        block = types.SimpleNamespace(type="triangle", data=self.faces)
        line = types.SimpleNamespace(type="line", data=[[0, 1]])
        self.assert_same(
            geodesic.Mesh(
                types.SimpleNamespace(points=self.vertices, cells=[block])))
        for cells in ([line, block],
                      [("line", [[0, 1]]), ("triangle", self.faces)]):
            with self.assertWarnsRegex(UserWarning,
                                       "type line are left out") as told:
                mesh = geodesic.Mesh(
                    types.SimpleNamespace(points=self.vertices, cells=cells))
            self.assertEqual(told.filename, __file__)
            self.assert_same(mesh)
        self.assert_refused(
            "no triangles, only cells of type line and vertex", geodesic.Mesh,
            types.SimpleNamespace(points=self.vertices,
                                  cells=[line, ("vertex", [[0]])]))
        for cells in ([self.faces.tolist()], [("triangle",)]):
            self.assert_refused(
                "cells[0] is of type", geodesic.Mesh,
                types.SimpleNamespace(points=self.vertices, cells=cells))
        tetrahedra = types.SimpleNamespace(type="tetra", data=[[0, 1, 2, 3]])
        self.assert_refused(
            "tetra", geodesic.Mesh,
            types.SimpleNamespace(points=self.vertices, cells=[tetrahedra]))
        self.assert_refused("dict is no mesh", geodesic.Mesh, {})

    def test_polygons_become_fans(self):
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
        wanted = [[0, 1, 2], [0, 2, 3]]
        for faces in ([4, 0, 1, 2, 3], [3, 0, 1, 2, 3, 0, 2, 3]):
            mesh = geodesic.Mesh(
                types.SimpleNamespace(points=square, faces=np.array(faces)))
            np.testing.assert_array_equal(mesh.faces, wanted)
        quads = types.SimpleNamespace(type="quad", data=[[0, 1, 2, 3]])
        mesh = geodesic.Mesh(
            types.SimpleNamespace(points=square[:, :2], cells=[quads]))
        np.testing.assert_array_equal(mesh.faces, wanted)
        np.testing.assert_array_equal(mesh.vertices, square)

    def test_polygons_are_cut_inside_themselves(self):
        # An L of area 3: from corner 0 to corner 3 straight lines stay inside
        # by way of corner 2.
        ell = np.array([[2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0],
                        [0, 0, 0.0]])
        for first in range(6):
            corners = np.roll(np.arange(6), first)
            for faces in ({"faces": np.append(6, corners)},
                          {"cells": [("polygon", [corners.tolist()])]}):
                mesh = geodesic.Mesh(types.SimpleNamespace(points=ell, **faces))
                self.assertEqual(mesh.n_faces, 4)
                self.assertAlmostEqual(mesh.distances(0)[3], 1 + 2**0.5, 12)
        # Polygons of several sizes.
        for faces in (
                {"faces": np.array([6, 0, 1, 2, 3, 4, 5, 3, 5, 1, 0])},
                {"cells": [("polygon", [[0, 1, 2, 3, 4, 5], [5, 1, 0]])]}):
            mesh = geodesic.Mesh(types.SimpleNamespace(points=ell, **faces))
            self.assertEqual(mesh.n_faces, 5)
            np.testing.assert_array_equal(mesh.faces[4], [5, 1, 0])

    def test_polygons_that_cross_themselves_are_told(self):
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
        tie = [0, 2, 1, 3]
        for faces in ({"faces": np.array([3, 0, 1, 2, 4] + tie)},
                      {"cells": [("triangle", [[0, 1, 2]]), ("quad", [tie])]}):
            with self.assertWarnsRegex(UserWarning, "first of them face 1:"
                                       ) as told:
                geodesic.Mesh(types.SimpleNamespace(points=square, **faces))
            self.assertEqual(told.filename, __file__)

    def test_bad_polygons_are_named(self):
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
        for faces in ({"faces": np.array([3, 0, 1, 2, 4, 0, 1, 2, 4])},
                      {"cells": [("triangle", [[0, 1, 2]]),
                                 ("quad", [[0, 1, 2, 4]])]}):
            self.assert_refused("face 1 names vertex 4, but there are 4",
                                geodesic.Mesh,
                                types.SimpleNamespace(points=square, **faces))
        self.assert_refused(
            "faces are of type float64", geodesic.Mesh,
            types.SimpleNamespace(points=square,
                                  faces=np.array([4, 0, 1, 2, 3.0])))

    def test_strips_of_pyvista(self):
        # Two strips over a row of squares, behind a face.
        points = np.array([[x, y, 0.0] for x in range(4) for y in range(2)])
        none = np.empty(0, int)
        strips = np.array([5, 0, 1, 2, 3, 4, 4, 4, 5, 6, 7])
        wanted = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 5, 6], [6, 5, 7]]
        for faces, first in ((none, []), (np.array([3, 3, 5, 4]), [[3, 5, 4]])):
            mesh = geodesic.Mesh(
                types.SimpleNamespace(points=points, faces=faces, strips=strips,
                                      lines=none, verts=none))
            np.testing.assert_array_equal(mesh.faces, first + wanted)
        self.assert_refused(
            "strips[6] says that a strip has 4 corners, and 3 numbers",
            geodesic.Mesh,
            types.SimpleNamespace(points=points, faces=none,
                                  strips=strips[:-1]))

    def test_other_things_of_pyvista_and_vtk(self):
        none = np.empty(0, int)
        self.assert_refused(
            "has lines and verts, but no faces", geodesic.Mesh,
            types.SimpleNamespace(points=self.vertices, faces=none, strips=none,
                                  lines=np.array([2, 0, 1]),
                                  verts=np.array([1, 0])))
        self.assert_refused(
            "give its surface, .extract_surface()", geodesic.Mesh,
            types.SimpleNamespace(points=self.vertices,
                                  cells=np.array([4, 0, 1, 2, 3]),
                                  extract_surface=None))
        self.assert_refused("pyvista.wrap", geodesic.Mesh,
                            types.SimpleNamespace(GetPoints=None))

    def test_refused_meshes(self):
        v, f = self.vertices, self.faces
        self.assert_refused("(3, 6), not (V, 3): transpose", geodesic.Mesh, v.T,
                            f)
        self.assert_refused("third coordinate", geodesic.Mesh, v[:, :2], f)
        self.assert_refused("(6,), not (V, 3)", geodesic.Mesh, v[:, 0], f)
        self.assert_refused("complex128", geodesic.Mesh, v * 1j, f)
        self.assert_refused("vertices has masked", geodesic.Mesh,
                            np.ma.masked_greater(v, 0.5), f)
        self.assert_refused("<U", geodesic.Mesh, [["a", "b", "c"]], f)
        self.assert_refused(".astype(int)", geodesic.Mesh, v, f * 1.0)
        self.assert_refused("tetrahedra", geodesic.Mesh, v, f[:, [0, 1, 2, 0]])
        self.assert_refused("(24,), not (F, 3)", geodesic.Mesh, v, f.ravel())
        self.assert_refused("faces[0, 1] is -1", geodesic.Mesh, v,
                            np.array([[0, -1, 2]]))
        self.assert_refused("faces[1, 0] is 4294967296, which is out of range",
                            geodesic.Mesh, v,
                            np.array([[0, 1, 2], [2**32, 1, 2]]))
        self.assert_refused("face 0 names vertex 6", geodesic.Mesh, v,
                            np.array([[0, 1, 6]]))
        self.assert_refused("names a vertex twice", geodesic.Mesh, v,
                            np.array([[0, 0, 2], [3, 3, 4]]))
        self.assert_refused("vertex 2", geodesic.Mesh,
                            np.where(np.arange(6)[:, None] == 2, np.nan, v), f)
        self.assert_refused("no face", geodesic.Mesh, v, f[:0])

    def test_refused_places(self):
        mesh = self.wanted
        ask = mesh.distances
        self.assert_refused("sources[0] is -1", ask, -1)
        self.assert_refused("sources[1] is -3", ask, [0, -3])
        self.assert_refused("sources[0].vertex 6 is out of range", ask, 6)
        self.assert_refused("sources[1].vertex 6", ask, np.array([0, 6]))
        large = 2**40
        for words, place in (
            ("sources[0] is", large), ("sources[1] is", [0, large]),
            ("sources[1] is", np.array([0, large])),
            ("sources[0].end is", geodesic.EdgePoint(0, large, 0.5)),
            ("sources[0].face is", geodesic.FacePoint(large, (1, 0, 0)))):
            self.assert_refused(words + " 1099511627776, which is out of range",
                                ask, place)
        self.assert_refused("nearest_point", ask, np.array([0.0, 1, 2]))
        self.assert_refused("nearest_point", ask, [0.0, 1.0, 2.0])
        self.assert_refused("mask of shape (5,)", ask, np.ones(5, bool))
        self.assert_refused("no source", ask, [])
        self.assert_refused("no source", ask, np.zeros(6, bool))
        self.assert_refused("sources is None", ask, None)
        self.assert_refused("sources is 'x'", ask, "x")
        self.assert_refused("sources[1] is None", ask, [0, None])
        self.assert_refused("three numbers", ask, geodesic.FacePoint(0, (1, 0)))
        self.assert_refused("targets[0] is a curve", ask, 0,
                            targets=geodesic.Curve([0, 2]))
        self.assert_refused("targets[1].vertex 9", ask, 0, targets=[0, 9])
        self.assert_refused("curve", ask, geodesic.Curve([0, 1]))
        self.assert_refused("sources[0].points is None", ask,
                            geodesic.Curve(None))
        curve = geodesic.Curve([0, 2, 4])
        self.assert_refused("sources[1] is 'x'", ask, [curve, "x"])
        self.assert_refused("sources[1].t is 'x'", ask,
                            [curve, geodesic.EdgePoint(0, 2, "x")])
        self.assert_refused("sources[1].points[2] is None", ask,
                            [5, geodesic.Curve([0, 2, None])])
        self.assert_refused("sources[1].points[0] is a curve", ask,
                            [5, geodesic.Curve([curve])])
        self.assert_refused("offsets have shape (2,)", ask, 0, offsets=[0, 1])
        self.assert_refused("sources[0].offset", ask, 0, offsets=[-1])
        self.assert_refused("sources[0].offset", ask, 0, offsets=np.nan)

    def test_refused_options(self):
        mesh = self.wanted
        for words in ("known are: fwp-list", "approximate: fmm"):
            self.assert_refused(words, mesh.distances, 0, algorithm="dijkstra")
        self.assert_refused("radius is -1", mesh.distances, 0, radius=-1)
        self.assert_refused("radius is nan", mesh.distances, 0,
                            radius=float("nan"))
        self.assert_refused("level", mesh.isolines, 0, levels=[-1])
        self.assert_refused("1 sources, but 2 targets", mesh.pairs, [0], [1, 2])
        self.assert_refused("(3,), not (N, 2)", mesh.pairs, [0, 1, 2])
        self.assert_refused("out has shape", mesh.matrix, [0, 1],
                            out=np.empty((2, 5)))
        self.assert_refused("out has shape", mesh.matrix, [0, 1],
                            out=np.empty((2, 6), int))
        # Before any path is computed: there is no source 6.
        self.assert_refused("2 targets", mesh.path, 6, [1, 2])
        self.assert_refused("values have shape",
                            mesh.plot, np.zeros(5))
        self.assert_refused("complex numbers are not real", mesh.plot, np.zeros(6) * 1j)
        self.assert_refused("values cannot be", mesh.plot, ["a"] * 6)
        self.assert_refused("not finite", mesh.nearest_point, [0, 0, np.inf])
        self.assert_refused("(2,), not (3,)", mesh.nearest_point, [0, 0])

    def test_what_they_say_of_themselves(self):
        mesh = self.wanted
        self.assertEqual(
            repr(mesh),
            "<geodesic.Mesh: 6 vertices, 8 faces, in this process>")
        self.assertIn("6 of 6 vertices reached", repr(mesh.field(0)))
        self.assertIn("fwp-list", repr(mesh.field(0)))
        self.assertIn("points, length", repr(mesh.path(0, 1)))
        self.assertIn("closed", repr(mesh.isolines(0, levels=[0.5])))
        self.assertIn("6 of 6", repr(mesh.log_map(0)))
        self.assertEqual(mesh.info()["genus"], 0)
        self.assertEqual(mesh.info()["edges"], 12)
        line = geodesic.Mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
        self.assertEqual(line.info()["degenerate_faces"], 1)

    def test_pickles(self):
        self.assert_same(pickle.loads(pickle.dumps(self.wanted)))
        rest = self.wanted.without(faces=[1, 4])
        for again in (pickle.loads(pickle.dumps(rest)), copy.copy(rest),
                      copy.deepcopy(rest)):
            np.testing.assert_array_equal(again.kept_faces, rest.kept_faces)

    def test_errors_name_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "twice.off"
            path.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n")
            self.assert_refused(f"{path}: ", geodesic.Mesh, path)

    def test_faces_of_pyvista_that_are_cut_off(self):
        vertices, _ = meshes.octahedron()
        for faces, words in (([5, 0, 1, 2], "faces[0] says that a face has 5"),
                             ([3, 0, 1, 2, 3, 0], "faces[4]"),
                             ([3, 0, 1, 2, 2, 0, 1], "faces[4]"),
                             ([-1, 3, 0, 1, 2], "faces[0]"),
                             ([0], "faces[0]"), ([10**9, 0, 1, 2], "faces[0]")):
            self.assert_refused(words, geodesic.Mesh, types.SimpleNamespace(
                points=vertices, faces=np.array(faces)))


if __name__ == "__main__":
    unittest.main()
