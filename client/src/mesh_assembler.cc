#include "mesh_assembler.h"

#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

// Numbers arrive little endian and are copied as they are.
static_assert(std::endian::native == std::endian::little);

// Appends the elements that `bytes` holds, which begin with number `first` of
// `count`.
template <typename Element>
absl::Status Append(std::string_view what, const std::string& bytes,
                    uint64_t first, uint64_t count,
                    std::vector<Element>* elements) {
  const size_t had = elements->size();
  const size_t more = bytes.size() / sizeof(Element);
  if (first != had || more > count - had ||
      bytes.size() % sizeof(Element) != 0) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", bytes.size(), " bytes of ", std::string(what),
        " from number ", first, " after ", had, " of ", count));
  }
  elements->resize(had + more);
  if (more > 0) std::memcpy(elements->data() + had, bytes.data(), bytes.size());
  return absl::OkStatus();
}

}  // namespace

absl::Status MeshAssembler::Consume(const v1::ReadMeshResponse& message) {
  if (message.has_header()) {
    if (has_header_) {
      return absl::DataLossError("the server described one mesh twice");
    }
    has_header_ = true;
    vertex_count_ = message.header().vertex_count();
    face_count_ = message.header().face_count();
    return absl::OkStatus();
  }
  if (!has_header_) {
    return absl::DataLossError("the server sent a mesh without its header");
  }
  if (message.has_vertices()) {
    return Append("vertices", message.vertices().positions(),
                  message.vertices().first_vertex(), vertex_count_,
                  &mesh_.positions);
  }
  if (message.has_faces()) {
    return Append("faces", message.faces().indices(),
                  message.faces().first_face(), face_count_, &mesh_.triangles);
  }
  if (message.has_joined()) {
    return Append("joined vertices", message.joined().pairs(),
                  message.joined().first_pair(), vertex_count_, &mesh_.joined);
  }
  return absl::OkStatus();  // A part that a later server may add.
}

absl::StatusOr<MeshArrays> MeshAssembler::Finish() && {
  for (const auto& [vertex, into] : mesh_.joined) {
    if (vertex >= vertex_count_ || into >= vertex_count_) {
      return absl::DataLossError(absl::StrCat("the server sent vertex ", vertex,
                                              " joined into ", into, " of ",
                                              vertex_count_));
    }
  }
  if (!has_header_ || mesh_.positions.size() != vertex_count_ ||
      mesh_.triangles.size() != face_count_) {
    return absl::DataLossError(
        absl::StrCat("the server ended the mesh after ", mesh_.positions.size(),
                     " of ", vertex_count_, " vertices and ",
                     mesh_.triangles.size(), " of ", face_count_, " faces"));
  }
  for (size_t face = 0; face < mesh_.triangles.size(); ++face) {
    for (const uint32_t vertex : mesh_.triangles[face]) {
      if (vertex >= vertex_count_) {
        return absl::DataLossError(absl::StrCat("the server sent face ", face,
                                                " with vertex ", vertex, " of ",
                                                vertex_count_));
      }
    }
  }
  return std::move(mesh_);
}

}  // namespace geodesic::client
