// What is refused of the messages of a mesh.

#include "client/src/mesh_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tests/client/scripted_service.h"

namespace geodesic::client {
namespace {

// Elements as they travel.
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
absl::Status Assemble(const std::vector<v1::ReadMeshResponse>& messages) {
  MeshAssembler assembler;
  for (const v1::ReadMeshResponse& message : messages) {
    absl::Status status = assembler.Consume(message);
    if (!status.ok()) return status;
  }
  return std::move(assembler).Finish().status();
}

const Point kA = {0, 0, 0};
const Point kB = {1, 0, 0.1};
const Point kC = {0, 1, 1e300};

TEST(MeshAssemblerTest, RefusesWhatIsNotDue) {
  v1::ReadMeshResponse part;
  part.mutable_vertices()->set_positions("0123456789");
  // Counts that are no reason to take memory.
  constexpr uint64_t kHuge = std::numeric_limits<uint64_t>::max();
  const std::vector<std::pair<std::vector<v1::ReadMeshResponse>, std::string>>
      table = {
          {{Vertices(0, {kA})}, "without its header"},
          {{Header(1, 0), Header(1, 0)}, "twice"},
          {{Header(3, 0), Vertices(1, {kB})}, "from number 1"},
          {{Header(1, 0), Vertices(0, {kA, kB})}, "of 1"},
          {{Header(3, 0), part}, "10 bytes of vertices"},
          {{Header(2, 1), Vertices(0, {kA})}, "1 of 2"},
          {{Header(3, 1), Vertices(0, {kA, kB, kC}), Faces(0, {{0, 1, 3}})},
           "face 0 with vertex 3 of 3"},
          {{Header(kHuge, kHuge), Vertices(0, {kA})}, "1 of"}};
  for (const auto& [messages, words] : table) {
    ExpectDataLoss(Assemble(messages), words);
  }
}

}  // namespace
}  // namespace geodesic::client
