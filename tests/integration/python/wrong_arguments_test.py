"""What each question says to wrong arguments."""

import math

import grpc

from client_fixture import ClientTest, main, planar_grid

INVALID = grpc.StatusCode.INVALID_ARGUMENT


class WrongArgumentsTest(ClientTest):

    def test_errors_have_code_and_message(self):
        positions, faces = planar_grid()
        digest = self.upload(positions, faces).mesh.digest
        self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "100000",
                          lambda: self.compute(digest, [(100000, 0.0)]))
        self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "source",
                          lambda: self.compute(digest, []))
        self.assert_fails(grpc.StatusCode.NOT_FOUND, "upload it again",
                          lambda: self.compute("0" * 64, [(0, 0.0)]))
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "digest",
            lambda: self.upload(positions, faces, expected_digest="0" * 64))

    def questions(self, digest, source):
        """Each question about this source, by name."""
        target = self.vertices(1)
        return {
            "field": lambda: list(self.fields.ComputeField(
                self.field_pb.ComputeFieldRequest(
                    mesh_digest=digest, sources=[source]), timeout=60)),
            "sample": lambda: list(self.fields.SampleFarthestPoints(
                self.field_pb.SampleFarthestPointsRequest(
                    mesh_digest=digest, sources=[source], count=1),
                timeout=60)),
            "path": lambda: list(self.paths.ComputePaths(
                self.path_pb.ComputePathsRequest(
                    mesh_digest=digest, sources=[source], targets=target),
                timeout=60)),
            "isolines": lambda: list(self.paths.ComputeIsolines(
                self.path_pb.ComputeIsolinesRequest(
                    mesh_digest=digest, sources=[source], levels=[0.5]),
                timeout=60)),
            "matrix": lambda: list(self.matrices.ComputeMatrix(
                self.matrix_pb.ComputeMatrixRequest(
                    mesh_digest=digest, sources=[source]), timeout=60)),
            "nearest": lambda: list(self.matrices.FindNearest(
                self.matrix_pb.FindNearestRequest(
                    mesh_digest=digest, sources=[source], targets=target,
                    count=1), timeout=60)),
        }

    def test_wrong_sources_are_named_by_every_question(self):
        digest, _, _ = self.grid()
        face = self.surface_pb.FacePoint
        for words, place in [
                ("sources[0]", {}),
                ("offset", {"vertex": 0, "offset": math.nan}),
                ("offset", {"vertex": 0, "offset": -1.0}),
                ("vertex 121", {"vertex": 121}),
                ("face 200", {"face": face(face=200, weights=[1, 0, 0])}),
                ("weights", {"face": face(face=0, weights=[1, 1, 1])}),
                ("weights", {"face": face(face=0, weights=[1.5, -0.5, 0])}),
                ("weights", {"face": face(face=0, weights=[1, 0])}),
                ("edge", {"edge": self.edge(0, 90, 0.5)}),
                ("t", {"edge": self.edge(0, 1, 1.5)}),
        ]:
            source = self.surface_pb.Source(**place)
            for name, ask in self.questions(digest, source).items():
                with self.subTest(question=name, place=place):
                    self.assert_fails(INVALID, words, ask)

    def test_wrong_places_of_a_log_map_are_named(self):
        digest, _, _ = self.grid()
        for words, place in [("source", {}), ("vertex 121", {"vertex": 121}),
                             ("edge", {"edge": self.edge(0, 90, 0.5)})]:
            self.assert_fails(
                INVALID, words, lambda: list(self.fields.ComputeLogMap(
                    self.field_pb.ComputeLogMapRequest(
                        mesh_digest=digest,
                        source=self.surface_pb.SurfacePoint(**place)),
                    timeout=60)))

    def test_questions_about_nothing(self):
        digest, _, _ = self.grid()
        sources = [self.surface_pb.Source(vertex=0)]
        nearest = self.matrix_pb.FindNearestRequest
        for words, ask in [
                ("targets", lambda: list(self.paths.ComputePaths(
                    self.path_pb.ComputePathsRequest(
                        mesh_digest=digest, sources=sources)))),
                ("levels", lambda: list(self.paths.ComputeIsolines(
                    self.path_pb.ComputeIsolinesRequest(
                        mesh_digest=digest, sources=sources)))),
                ("count", lambda: list(self.fields.SampleFarthestPoints(
                    self.field_pb.SampleFarthestPointsRequest(
                        mesh_digest=digest, sources=sources)))),
                ("count", lambda: list(self.matrices.FindNearest(nearest(
                    mesh_digest=digest, sources=sources,
                    targets=self.vertices(1))))),
                ("targets", lambda: list(self.matrices.FindNearest(nearest(
                    mesh_digest=digest, sources=sources, count=1)))),
        ]:
            self.assert_fails(INVALID, words, ask)


if __name__ == "__main__":
    main()
