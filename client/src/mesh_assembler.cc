#include "mesh_assembler.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "wire_values.h"

namespace geodesic::client {
namespace {

// Appends the elements that `bytes` holds; they are elements `first` and
// following of the `count` there are to be.
template <typename Element>
absl::Status Append(std::string_view what, const std::string& bytes,
                    uint64_t first, uint64_t count,
                    std::vector<Element>* elements) {
  const size_t had = elements->size();
  if (first != had || bytes.size() / sizeof(Element) > count - had ||
      !AppendElements(bytes, elements)) {
    return absl::DataLossError(absl::StrCat(
        "the server sent ", bytes.size(), " bytes of ", std::string(what),
        " from number ", first, " after ", had, " of ", count));
  }
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
  return absl::OkStatus();  // A part that a later server may add.
}

absl::StatusOr<MeshArrays> MeshAssembler::Finish() && {
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
