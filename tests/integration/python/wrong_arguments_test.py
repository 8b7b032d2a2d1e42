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
                          lambda: self.field(digest, [(100000, 0.0)]))
        self.assert_fails(grpc.StatusCode.INVALID_ARGUMENT, "source",
                          lambda: self.field(digest, []))
        self.assert_fails(grpc.StatusCode.NOT_FOUND, "upload it again",
                          lambda: self.field("0" * 64, [(0, 0.0)]))
        self.assert_fails(
            grpc.StatusCode.INVALID_ARGUMENT, "digest",
            lambda: self.upload(positions, faces, expected_digest="0" * 64))

    # What each question is asked with, beside its sources.
    QUESTIONS = {
        "ComputeField": {},
        "SampleFarthestPoints": {"count": 1},
        "ComputePaths": {"vertex_targets": [1]},
        "ComputeIsolines": {"levels": [0.5]},
        "ComputeMatrix": {},
        "FindNearest": {"vertex_targets": [1], "count": 1},
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
            for name, fields in self.QUESTIONS.items():
                with self.subTest(question=name, place=place):
                    self.assert_fails(
                        INVALID, words,
                        lambda: self.ask(name, mesh_digest=digest,
                                         sources=[source], **fields))

    def test_wrong_places_of_a_log_map_are_named(self):
        digest, _, _ = self.grid()
        for words, place in [("source", {}), ("vertex 121", {"vertex": 121}),
                             ("edge", {"edge": self.edge(0, 90, 0.5)})]:
            self.assert_fails(
                INVALID, words, lambda: self.ask(
                    "ComputeLogMap", mesh_digest=digest,
                    source=self.surface_pb.SurfacePoint(**place)))

    def test_questions_about_nothing(self):
        digest, _, _ = self.grid()
        for words, name, fields in [
                ("targets", "ComputePaths", {}),
                ("levels", "ComputeIsolines", {}),
                ("count", "SampleFarthestPoints", {}),
                ("count", "FindNearest", {"vertex_targets": [1]}),
                ("targets", "FindNearest", {"count": 1}),
        ]:
            self.assert_fails(INVALID, words, lambda: self.ask(
                name, mesh_digest=digest,
                sources=[self.surface_pb.Source(vertex=0)], **fields))


if __name__ == "__main__":
    main()
