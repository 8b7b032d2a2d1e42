"""Approximate algorithms, and how answers say that they are."""

import math

import grpc
from client_fixture import INFINITY, ClientTest, main


class ApproximateTest(ClientTest):

    def approximate(self, digest, algorithm, **parameters):
        """The field of vertex 0."""
        return self.field(
            digest, [(0, 0.0)], algorithm=algorithm,
            approximation=(self.query_pb.Approximation(**parameters)
                           if parameters else None))

    def test_approximate_fields_say_so(self):
        digest, positions, _ = self.grid()
        for algorithm in (self.query_pb.ALGORITHM_HEAT,
                          self.query_pb.ALGORITHM_FMM,
                          self.query_pb.ALGORITHM_FMM_UNTIDY,
                          self.query_pb.ALGORITHM_SVG,
                          self.query_pb.ALGORITHM_GTU):
            answer = self.approximate(digest, algorithm)
            self.assertEqual(answer.header.algorithm, algorithm)
            self.assertTrue(answer.header.HasField("approximation"))
            self.assertEqual(answer.trailer.relative_tolerance, INFINITY)
            self.assertEqual(answer.trailer.settled_radius, 0)
            for distance, position in zip(answer.distance, positions):
                exact = math.dist(position, positions[0])
                # Fronts around a source are not straight.
                self.assertAlmostEqual(distance, exact,
                                       delta=0.06 * exact + 0.05)

    def test_exact_fields_do_not(self):
        digest, positions, _ = self.grid()
        self.approximate(digest, self.query_pb.ALGORITHM_FMM)
        answer = self.field(digest, [(0, 0.0)])
        self.assertFalse(answer.header.HasField("approximation"))
        self.assertLess(answer.trailer.relative_tolerance, 1e-9)
        self.assertEqual(answer.trailer.settled_radius, INFINITY)
        for distance, position in zip(answer.distance, positions):
            self.assertAlmostEqual(distance, math.dist(position, positions[0]),
                                   delta=1e-10)

    def test_parameters_come_back(self):
        digest, _, _ = self.grid()
        used = self.approximate(digest, self.query_pb.ALGORITHM_HEAT,
                                **{"lambda": 3.0}).header.approximation
        self.assertEqual(getattr(used, "lambda"), 3.0)
        self.assertFalse(used.HasField("neighbours"))
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "no parameter of svg",
            lambda: self.approximate(digest, self.query_pb.ALGORITHM_SVG,
                                     samples=3))

    def test_parameters_out_of_range_are_refused(self):
        digest, _, _ = self.grid()
        pb = self.query_pb
        self.approximate(digest, pb.ALGORITHM_HEAT)
        for algorithm, name, value in (
                (pb.ALGORITHM_HEAT, "lambda", math.nan),
                (pb.ALGORITHM_HEAT, "lambda", 0),
                (pb.ALGORITHM_SVG, "neighbours", 0),
                (pb.ALGORITHM_GTU, "samples", 0)):
            self.assert_fails(
                grpc.StatusCode.INVALID_ARGUMENT, "is not",
                lambda: self.approximate(digest, algorithm, **{name: value}))

    def test_nothing_is_prepared_for_what_is_refused(self):
        digest, positions, _ = self.grid()
        svg, nine = self.query_pb.ALGORITHM_SVG, self.query_pb.Approximation(
            neighbours=9)
        missing = self.vertices(len(positions))
        sources = [self.surface_pb.Source(vertex=len(positions))]
        common = {"mesh_digest": digest, "algorithm": svg,
                  "approximation": nine}
        pair = self.question_pb.PointPair(source=missing[0], target=missing[0])
        for name, fields in (
                ("ComputeField", {"sources": sources}),
                ("ComputeMatrix", {"sources": sources}),
                ("FindNearest", {"sources": sources, "count": 1,
                                 "targets": self.vertices(1)}),
                ("ComputePairs", {"pairs": [pair]})):
            self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "out of range",
                              lambda: self.ask(name, **common, **fields))
        mesh = self.meshes.GetMesh(
            self.mesh_service_pb.GetMeshRequest(digest=digest),
            timeout=60).mesh
        self.assertNotIn((svg, 9), [(m.algorithm, m.approximation.neighbours)
                                    for m in mesh.prepared_methods])

    def test_what_is_prepared_is_described(self):
        digest, _, _ = self.grid()
        svg = self.query_pb.ALGORITHM_SVG
        self.approximate(digest, svg, neighbours=7)
        mesh = self.meshes.GetMesh(
            self.mesh_service_pb.GetMeshRequest(digest=digest),
            timeout=60).mesh
        self.assertIn((svg, 7, True),
                      [(m.algorithm, m.approximation.neighbours,
                        m.prepared_bytes > 0) for m in mesh.prepared_methods])

    def test_the_list_of_algorithms_tells_them_apart(self):
        listed = self.capabilities.GetCapabilities(
            self.capabilities_pb.GetCapabilitiesRequest(), timeout=60)
        approximate = {a.name for a in listed.approximate_algorithms}
        self.assertEqual(approximate,
                         {"heat", "fmm", "fmm-untidy", "svg", "gtu"})
        self.assertFalse(approximate & {a.name for a in listed.algorithms})

    def test_exact_questions_refuse_them(self):
        digest, _, _ = self.grid()
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "heat is approximate",
            lambda: self.ask("ComputePaths", mesh_digest=digest,
                             sources=[self.surface_pb.Source(vertex=0)],
                             targets=self.vertices(1),
                             algorithm=self.query_pb.ALGORITHM_HEAT))


if __name__ == "__main__":
    main()
