// upload, meshes, info and delete.

#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/mesh_argument.h"
#include "client/cli/text.h"

namespace geodesic::client {
namespace {

std::string PointText(const Point& point) {
  return absl::StrCat(ShortNumber(point[0]), " ", ShortNumber(point[1]), " ",
                      ShortNumber(point[2]));
}

std::string Genus(const MeshInfo& mesh) {
  return mesh.genus.has_value() ? absl::StrCat(*mesh.genus) : "none";
}

// Whether the faces are turned alike, or could be.
std::string Orientation(const MeshInfo& mesh) {
  if (!mesh.orientable) return "not orientable";
  if (mesh.inconsistent_edge_count == 0) return "consistent";
  return absl::StrCat("orientable, but the faces at ",
                      GroupedNumber(mesh.inconsistent_edge_count),
                      " edges are turned against each other");
}

std::vector<Fact> FactsOf(const MeshInfo& mesh) {
  return {
      {"digest", mesh.digest},
      {"vertices", GroupedNumber(mesh.vertex_count)},
      {"faces", GroupedNumber(mesh.face_count)},
      {"edges", GroupedNumber(mesh.edge_count)},
      {"boundary",
       absl::StrCat(GroupedNumber(mesh.boundary_edge_count), " edges in ",
                    GroupedNumber(mesh.boundary_loop_count), " loops")},
      {"components", GroupedNumber(mesh.component_count)},
      {"isolated vertices", GroupedNumber(mesh.isolated_vertex_count)},
      {"non-manifold",
       absl::StrCat(GroupedNumber(mesh.non_manifold_edge_count), " edges, ",
                    GroupedNumber(mesh.non_manifold_vertex_count),
                    " vertices")},
      {"orientation", Orientation(mesh)},
      {"genus", Genus(mesh)},
      {"saddle vertices", GroupedNumber(mesh.saddle_vertex_count)},
      {"degenerate faces", GroupedNumber(mesh.degenerate_face_count)},
      {"bounding box", absl::StrCat(PointText(mesh.bounding_box_min), "  to  ",
                                    PointText(mesh.bounding_box_max))},
      {"mean edge length", ShortNumber(mesh.mean_edge_length)},
      {"anisotropy", ShortNumber(mesh.anisotropy)},
      {"resident", ByteCount(mesh.resident_bytes)},
      {"on disk", ByteCount(mesh.stored_bytes)}};
}

}  // namespace

absl::Status RunUpload(const Session& session) {
  absl::StatusOr<UploadOutcome> outcome = UploadMeshArgument(session);
  if (!outcome.ok()) return outcome.status();
  if (session.arguments.json) {
    Json json = {{"mesh", ToJson(outcome->mesh)},
                 {"already_resident", outcome->already_resident},
                 {"bytes_sent", outcome->bytes_sent}};
    PrintJson(json, &session.out);
    return absl::OkStatus();
  }
  std::vector<Fact> facts = FactsOf(outcome->mesh);
  facts.push_back(
      {"upload",
       outcome->bytes_sent == 0 ? "nothing sent: already resident"
       : outcome->already_resident
           ? absl::StrCat(ByteCount(outcome->bytes_sent), ", already resident")
           : ByteCount(outcome->bytes_sent)});
  PrintFacts(facts, &session.out);
  return absl::OkStatus();
}

absl::Status RunMeshes(const Session& session) {
  absl::StatusOr<std::vector<MeshInfo>> meshes =
      session.client.ListMeshes(session.call);
  if (!meshes.ok()) return meshes.status();
  if (session.arguments.json) {
    Json list = Json::array();
    for (const MeshInfo& mesh : *meshes) list.push_back(ToJson(mesh));
    PrintJson({{"meshes", list}}, &session.out);
    return absl::OkStatus();
  }
  if (meshes->empty()) {
    session.out << "no resident meshes: add one with geodesic upload FILE\n";
    return absl::OkStatus();
  }
  std::vector<std::vector<std::string>> rows;
  for (const MeshInfo& mesh : *meshes) {
    rows.push_back({mesh.digest.substr(0, 16), GroupedNumber(mesh.vertex_count),
                    GroupedNumber(mesh.face_count),
                    GroupedNumber(mesh.component_count),
                    GroupedNumber(mesh.boundary_loop_count), Genus(mesh),
                    ByteCount(mesh.resident_bytes)});
  }
  PrintTable({"digest", "vertices", "faces", "components", "boundaries",
              "genus", "resident"},
             rows, &session.out);
  return absl::OkStatus();
}

absl::Status RunInfo(const Session& session) {
  absl::StatusOr<std::string> digest = ResolveMesh(session);
  if (!digest.ok()) return digest.status();
  absl::StatusOr<MeshInfo> mesh = session.client.GetMesh(*digest, session.call);
  if (!mesh.ok()) return mesh.status();
  if (session.arguments.json) {
    PrintJson(ToJson(*mesh), &session.out);
  } else {
    PrintFacts(FactsOf(*mesh), &session.out);
  }
  return absl::OkStatus();
}

absl::Status RunDelete(const Session& session) {
  absl::StatusOr<std::string> digest = FindMesh(session);
  if (!digest.ok()) return digest.status();
  absl::Status status = session.client.DeleteMesh(*digest, session.call);
  if (!status.ok()) return status;
  if (session.arguments.json) {
    PrintJson({{"deleted", *digest}}, &session.out);
  } else {
    session.out << "deleted " << *digest << '\n';
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
