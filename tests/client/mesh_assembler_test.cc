#include "client/src/mesh_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

template <typename Element>
std::string Bytes(const std::vector<Element>& elements) {
  return {reinterpret_cast<const char*>(elements.data()),
          elements.size() * sizeof(Element)};
}

v1::ReadMeshResponse Header(uint64_t vertices, uint64_t faces) {
  v1::ReadMeshResponse message;
  message.mutable_header()->set_vertex_count(vertices);
  message.mutable_header()->set_face_count(faces);
  return message;
}

v1::ReadMeshResponse Vertices(uint64_t first,
                              const std::vector<Point>& points) {
  v1::ReadMeshResponse message;
  message.mutable_vertices()->set_first_vertex(first);
  message.mutable_vertices()->set_positions(Bytes(points));
  return message;
}

v1::ReadMeshResponse Faces(uint64_t first,
                           const std::vector<Triangle>& triangles) {
  v1::ReadMeshResponse message;
  message.mutable_faces()->set_first_face(first);
  message.mutable_faces()->set_indices(Bytes(triangles));
  return message;
}

// The first status that is not OK, Finish's included.
absl::Status Assemble(const std::vector<v1::ReadMeshResponse>& messages,
                      MeshArrays* mesh = nullptr) {
  MeshAssembler assembler;
  for (const v1::ReadMeshResponse& message : messages) {
    absl::Status status = assembler.Consume(message);
    if (!status.ok()) return status;
  }
  absl::StatusOr<MeshArrays> finished = std::move(assembler).Finish();
  if (finished.ok() && mesh != nullptr) *mesh = *std::move(finished);
  return finished.status();
}

void ExpectDataLoss(const absl::Status& status, const std::string& words) {
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(words));
}

const Point kA = {0, 0, 0};
const Point kB = {1, 0, 0.1};
const Point kC = {0, 1, 1e300};

TEST(MeshAssemblerTest, PutsChunksTogether) {
  MeshArrays mesh;
  ASSERT_TRUE(Assemble({Header(3, 2), Vertices(0, {kA, kB}), Vertices(2, {kC}),
                        Faces(0, {{0, 1, 2}}), Faces(1, {{2, 1, 0}})},
                       &mesh)
                  .ok());
  EXPECT_THAT(mesh.positions, ElementsAre(kA, kB, kC));
  EXPECT_THAT(mesh.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 0}));
}

TEST(MeshAssemblerTest, RefusesMissingHeader) {
  ExpectDataLoss(Assemble({Vertices(0, {kA})}), "without its header");
}

TEST(MeshAssemblerTest, RefusesSecondHeader) {
  ExpectDataLoss(Assemble({Header(1, 0), Header(1, 0)}), "twice");
}

TEST(MeshAssemblerTest, RefusesGap) {
  ExpectDataLoss(Assemble({Header(3, 0), Vertices(1, {kB})}), "from number 1");
}

TEST(MeshAssemblerTest, RefusesMoreThanAnnounced) {
  ExpectDataLoss(Assemble({Header(1, 0), Vertices(0, {kA, kB})}), "of 1");
}

TEST(MeshAssemblerTest, RefusesPartOfAVertex) {
  v1::ReadMeshResponse message;
  message.mutable_vertices()->set_positions("0123456789");
  ExpectDataLoss(Assemble({Header(3, 0), message}), "10 bytes of vertices");
}

TEST(MeshAssemblerTest, RefusesEarlyEnd) {
  ExpectDataLoss(Assemble({Header(2, 1), Vertices(0, {kA})}), "1 of 2");
}

TEST(MeshAssemblerTest, RefusesIndexOutOfRange) {
  ExpectDataLoss(Assemble({Header(3, 1), Vertices(0, {kA, kB, kC}),
                           Faces(0, {{0, 1, 3}})}),
                 "face 0 with vertex 3 of 3");
}

TEST(MeshAssemblerTest, HugeCountsTakeNoMemory) {
  constexpr uint64_t kHuge = std::numeric_limits<uint64_t>::max();
  ExpectDataLoss(Assemble({Header(kHuge, kHuge), Vertices(0, {kA})}), "1 of");
}

}  // namespace
}  // namespace geodesic::client
