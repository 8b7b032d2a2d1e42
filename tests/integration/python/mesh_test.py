"""Meshes: uploaded, described, read back, deleted; and what the server can."""

import math

import grpc

from client_fixture import (GRID, ClientTest, canonical_arrays, main,
                            mesh_digest, planar_grid)


class MeshTest(ClientTest):

    def test_digest_is_the_one_computed_here(self):
        positions, faces = planar_grid()
        digest = mesh_digest(positions, faces)
        mesh = self.upload(positions, faces, expected_digest=digest).mesh
        self.assertEqual(mesh.digest, digest)
        self.assertEqual(mesh.vertex_count, (GRID + 1)**2)
        self.assertEqual(mesh.face_count, 2 * GRID**2)
        self.assertEqual(mesh.boundary_edge_count, 4 * GRID)
        missing = self.meshes.FindMissingMeshes(
            self.mesh_service_pb.FindMissingMeshesRequest(
                mesh_digests=["0" * 64, digest]))
        self.assertEqual(list(missing.missing_mesh_digests), ["0" * 64])

    def test_meshes_are_described_listed_read_and_deleted(self):
        positions = [(0, 0, 0), (3, 0, 0), (0, 4, 0)]
        digest = self.upload(positions, [(0, 1, 2)]).mesh.digest
        mesh = self.meshes.GetMesh(
            self.mesh_service_pb.GetMeshRequest(digest=digest)).mesh
        self.assertEqual(mesh.mean_edge_length, 4)
        self.assertEqual(mesh.bounding_box_max.y, 4)
        listed = self.meshes.ListMeshes(
            self.mesh_service_pb.ListMeshesRequest()).meshes
        self.assertIn(digest, [m.digest for m in listed])
        data = {"vertices": b"", "faces": b""}
        for response in self.meshes.ReadMesh(
                self.mesh_service_pb.ReadMeshRequest(digest=digest)):
            part = response.WhichOneof("part")
            if part == "vertices":
                data[part] += response.vertices.positions
            elif part == "faces":
                data[part] += response.faces.indices
        self.assertEqual(data["vertices"] + data["faces"],
                         canonical_arrays(positions, [(0, 1, 2)]))
        self.meshes.DeleteMesh(
            self.mesh_service_pb.DeleteMeshRequest(digest=digest))
        self.assert_fails(
            grpc.StatusCode.NOT_FOUND, "upload it again",
            lambda: self.meshes.GetMesh(
                self.mesh_service_pb.GetMeshRequest(digest=digest)))

    def test_a_book_of_three_pages_is_told_of_and_measured(self):
        positions = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (-1, 0, 0), (0, 0, 1)]
        mesh = self.upload(positions, [(0, 1, 2), (0, 1, 3), (0, 1, 4)]).mesh
        self.assertEqual(mesh.non_manifold_edge_count, 1)
        self.assertEqual(mesh.non_manifold_vertex_count, 2)
        self.assertFalse(mesh.HasField("genus"))
        values = self.field(mesh.digest, [(2, 0.0)]).distance
        for value, expected in zip(values, [1, math.sqrt(2), 0, 2, 2]):
            self.assertAlmostEqual(value, expected, delta=1e-12)

    def test_capabilities_name_the_algorithms(self):
        capabilities = self.capabilities.GetCapabilities(
            self.capabilities_pb.GetCapabilitiesRequest())
        self.assertEqual({a.name for a in capabilities.algorithms},
                         {"fwp-ch", "fwp-mmp", "ich", "mmp", "ch", "lc-mmp",
                          "lc-ch", "fwp-list"})
        self.assertEqual(sum(a.is_default for a in capabilities.algorithms), 1)


if __name__ == "__main__":
    main()
