// upload, meshes, info, delete: make meshes resident, list, describe and drop
// them.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/commands/report.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

// "3", or "none".
std::string Genus(const MeshInfo& mesh) {
  return mesh.genus.has_value() ? absl::StrCat(*mesh.genus) : "none";
}

// Whether the faces are oriented consistently, or could be.
std::string Orientation(const MeshInfo& mesh) {
  if (!mesh.is_orientable) return "not orientable";
  if (mesh.inconsistent_edges == 0) return "consistent";
  return absl::StrCat("orientable, but the faces at ",
                      GroupedNumber(mesh.inconsistent_edges),
                      " edges are turned against each other");
}

// From the least to the greatest coordinates.
Point Extent(const MeshInfo& mesh) {
  Point size = mesh.bounding_box_max;
  for (size_t axis = 0; axis < size.size(); ++axis) {
    size[axis] -= mesh.bounding_box_min[axis];
  }
  return size;
}

// A source to begin with: the end of the mesh's longest side.
std::string FirstSource(const MeshInfo& mesh) {
  const Point size = Extent(mesh);
  const auto longest = std::ranges::max_element(size) - size.begin();
  return absl::StrCat("--source max:", std::string(1, "xyz"[longest]),
                      " (a vertex at this end of the mesh), or --source "
                      "nearest:X,Y,Z");
}

// All that is known of a mesh, one fact a line.
std::vector<Fact> FactsOf(const MeshInfo& mesh) {
  std::vector<Fact> facts = {
      {"digest", mesh.digest},
      {"vertices", GroupedNumber(mesh.vertices)},
      {"faces", GroupedNumber(mesh.faces)},
      {"edges", GroupedNumber(mesh.edges)},
      {"boundary",
       absl::StrCat(GroupedNumber(mesh.boundary_edges), " edges in ",
                    GroupedNumber(mesh.boundary_loops), " loops")},
      {"components", GroupedNumber(mesh.components)},
      {"isolated vertices", GroupedNumber(mesh.isolated_vertices)},
      {"non-manifold",
       absl::StrCat(GroupedNumber(mesh.non_manifold_edges), " edges, ",
                    GroupedNumber(mesh.non_manifold_vertices), " vertices")},
      {"orientation", Orientation(mesh)},
      {"genus", Genus(mesh)},
      {"saddle vertices", GroupedNumber(mesh.saddle_vertices)},
      {"degenerate faces", GroupedNumber(mesh.degenerate_faces)},
      {"left out faces", GroupedNumber(mesh.left_out_faces)},
      {"seams",
       absl::StrCat(GroupedNumber(mesh.seam_edges), " edges joined, ",
                    GroupedNumber(mesh.joined_vertices), " vertices repeated")},
      {"bounding box",
       absl::StrCat(ShortNumbers(mesh.bounding_box_min), "  to  ",
                    ShortNumbers(mesh.bounding_box_max))},
      {"size", ShortNumbers(Extent(mesh))},
      {"mean edge length", ShortNumber(mesh.mean_edge_length)},
      {"anisotropy", ShortNumber(mesh.anisotropy)},
      {"resident", ByteCount(mesh.resident_bytes)},
      {"on disk", ByteCount(mesh.stored_bytes)},
      {"landmarks", GroupedNumber(mesh.landmark_count)}};
  for (const PreparedMethod& method : mesh.prepared_methods) {
    facts.push_back(
        {"prepared",
         absl::StrCat(AlgorithmText(method.algorithm, method.approximation),
                      ": ", ByteCount(method.bytes), ", ",
                      Seconds(method.prepare_seconds))});
  }
  for (const std::string& note : mesh.notes) facts.push_back({"note", note});
  return facts;
}

Json MethodsJson(const std::vector<PreparedMethod>& methods) {
  Json list = Json::array();
  for (const PreparedMethod& method : methods) {
    list.push_back({{"algorithm", method.algorithm},
                    {"parameters", ParametersJson(method.approximation)},
                    {"bytes", method.bytes},
                    {"prepare_seconds", method.prepare_seconds}});
  }
  return list;
}

Json ToJson(const MeshInfo& mesh) {
  Json json = {{"digest", mesh.digest}};
  ForEachFact(mesh, [&json](const char* name, const auto& fact) {
    if constexpr (requires { fact.has_value(); }) {
      json[name] = fact.has_value() ? Json(*fact) : Json();
    } else {
      json[name] = fact;
    }
  });
  json["bounding_box_size"] = Extent(mesh);
  json["notes"] = mesh.notes;
  json["resident_bytes"] = mesh.resident_bytes;
  json["stored_bytes"] = mesh.stored_bytes;
  json["landmarks"] = mesh.landmark_count;
  json["prepared"] = MethodsJson(mesh.prepared_methods);
  return json;
}

struct UploadArguments {
  std::vector<std::string> files;
  // How they are read.
  MeshArgument reading;
};

void AddUploadOptions(CLI::App* app, UploadArguments* arguments) {
  AddFiles(app,
           "Meshes in OBJ, PLY, OFF, STL, VTK, VTP or glTF, or .gz of these; "
           "sent only if the server does not know them",
           &arguments->files);
  AddReading(app, &arguments->reading);
}

void PrintUpload(const Session& session, const UploadOutcome& outcome) {
  if (session.quiet) {
    session.out << outcome.mesh.digest << std::endl;
    return;
  }
  std::vector<Fact> facts = FactsOf(outcome.mesh);
  facts.push_back({"upload", outcome.bytes_sent == 0
                                 ? "nothing sent: already resident"
                                 : absl::StrCat(ByteCount(outcome.bytes_sent),
                                                outcome.already_resident
                                                    ? ", already resident"
                                                    : "")});
  PrintFacts(facts, &session.out);
  session.out.flush();
}

absl::Status Upload(const UploadArguments& arguments, const Session& session) {
  const bool is_one = arguments.files.size() == 1;
  if (session.json && !is_one) (*session.json)["uploads"] = Json::array();
  for (const std::string& file : arguments.files) {
    absl::StatusOr<UploadOutcome> outcome = UploadMesh(
        session, {file, arguments.reading.format, arguments.reading.welding});
    if (!outcome.ok()) {
      if (session.json) (*session.json)["error"]["file"] = file;
      return outcome.status();
    }
    if (!session.json) {
      const bool is_first = &file == &arguments.files.front();
      if (!is_first && !session.quiet) session.out << '\n';
      PrintUpload(session, *outcome);
      continue;
    }
    Json upload = {{"file", file},
                   {"mesh", ToJson(outcome->mesh)},
                   {"already_resident", outcome->already_resident},
                   {"bytes_sent", outcome->bytes_sent}};
    if (is_one) {
      *session.json = std::move(upload);
    } else {
      (*session.json)["uploads"].push_back(std::move(upload));
    }
  }
  return absl::OkStatus();
}

absl::Status List(const NoArguments&, const Session& session) {
  absl::StatusOr<std::vector<MeshInfo>> meshes =
      session.client.ListMeshes(session.call);
  if (!meshes.ok()) return meshes.status();
  Json list = Json::array();
  std::vector<std::vector<std::string>> rows;
  for (const MeshInfo& mesh : *meshes) {
    list.push_back(ToJson(mesh));
    rows.push_back({mesh.digest.substr(0, 16), GroupedNumber(mesh.vertices),
                    GroupedNumber(mesh.faces), GroupedNumber(mesh.components),
                    GroupedNumber(mesh.boundary_loops), Genus(mesh),
                    ByteCount(mesh.resident_bytes)});
  }
  if (session.json) {
    (*session.json)["meshes"] = std::move(list);
  } else if (meshes->empty()) {
    session.out << "no resident meshes: add one with geodesic upload FILE\n";
  } else {
    PrintTable({"digest", "vertices", "faces", "components", "boundaries",
                "genus", "resident"},
               rows, &session.out);
  }
  return absl::OkStatus();
}

absl::Status Describe(const MeshArgument& argument, const Session& session) {
  return AskAboutMesh(session, argument, [&](const std::string& digest) {
    absl::StatusOr<MeshInfo> mesh =
        session.client.GetMesh(digest, session.call);
    if (!mesh.ok()) return mesh.status();
    if (session.json) {
      *session.json = ToJson(*mesh);
    } else {
      std::vector<Fact> facts = FactsOf(*mesh);
      facts.push_back({"begin with", FirstSource(*mesh)});
      PrintFacts(facts, &session.out);
    }
    return absl::OkStatus();
  });
}

absl::Status Delete(const MeshArgument& mesh, const Session& session) {
  absl::StatusOr<std::string> digest = FindMesh(session, mesh);
  if (!digest.ok()) return digest.status();
  absl::Status status = session.client.DeleteMesh(*digest, session.call);
  if (!status.ok()) return status;
  if (session.json) {
    (*session.json)["deleted"] = *digest;
  } else if (!session.quiet) {
    session.out << "deleted " << *digest << '\n';
  }
  return absl::OkStatus();
}

}  // namespace

Command UploadCommand() {
  return MakeCommand<UploadArguments>(
      "upload", "Make mesh files resident on the server",
      "  geodesic upload horse.ply\n"
      "  geodesic upload --quiet left.ply right.ply",
      AddUploadOptions, Upload);
}

Command MeshesCommand() {
  return MakeCommand<NoArguments>("meshes", "List the resident meshes",
                                  "  geodesic meshes", AddNoOptions, List);
}

Command InfoCommand() {
  return MakeCommand<MeshArgument>(
      "info", "Describe a mesh: counts, topology, extent",
      "  geodesic info horse.ply",
      [](CLI::App* app, MeshArgument* mesh) { AddMesh(app, kMeshHelp, mesh); },
      Describe);
}

Command DeleteCommand() {
  return MakeCommand<MeshArgument>(
      "delete", "Drop a mesh from the server", "  geodesic delete horse.ply",
      [](CLI::App* app, MeshArgument* mesh) {
        AddMesh(app,
                "The digest of a resident mesh, of which the first 8 digits do "
                "if they are unique; or the file it came from",
                mesh);
      },
      Delete);
}

}  // namespace geodesic::client
