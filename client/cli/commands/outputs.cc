#include "client/cli/commands/outputs.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/terminal/exit_code.h"
#include "client/cli/terminal/text.h"
#include "client/output/extended_ply.h"

namespace geodesic::client {

Point PositionOf(const SurfacePoint& point, const MeshArrays& mesh) {
  std::vector<std::pair<double, uint64_t>> corners;  // weights and vertices
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    corners = {{1, vertex->vertex}};
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    corners = {{1 - edge->t, edge->from}, {edge->t, edge->to}};
  } else if (const auto& at = std::get<FacePoint>(point);
             at.face < mesh.triangles.size()) {
    for (size_t i = 0; i < at.weights.size(); ++i) {
      corners.emplace_back(at.weights[i], mesh.triangles[at.face][i]);
    }
  }
  Point sum = {};
  for (const auto& [weight, vertex] : corners) {
    if (vertex >= mesh.positions.size()) continue;
    for (size_t axis = 0; axis < sum.size(); ++axis) {
      sum[axis] += weight * mesh.positions[vertex][axis];
    }
  }
  return sum;
}

absl::StatusOr<MeshArrays> FetchMesh(const Session& session,
                                     const AnswerInfo& info) {
  absl::StatusOr<MeshArrays> mesh =
      session.client.ReadMesh(info.mesh_digest, session.call);
  if (mesh.ok() && mesh->positions.size() != info.vertex_count) {
    return absl::DataLossError(
        absl::StrCat("the server sent a mesh of ", mesh->positions.size(),
                     " vertices and an answer for ", info.vertex_count));
  }
  return mesh;
}

absl::StatusOr<uint64_t> WriteFile(
    const std::string& path, const std::function<void(AtomicFile*)>& write) {
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return FileError(file.status());
  write(&*file);
  if (absl::Status status = file->Commit(); !status.ok()) {
    return FileError(status);
  }
  return file->size();
}

absl::StatusOr<uint64_t> WriteAnswerAsPly(const Session& session,
                                          const MeshArgument& argument,
                                          const AnswerInfo& info,
                                          const MeshArrays& mesh,
                                          std::span<const Column> columns,
                                          const std::string& mark,
                                          const std::string& path) {
  std::optional<std::string> extended;
  if (IsPlyFileOf(session, argument, info.mesh_digest)) {
    extended = ExtendedPlyFile(argument.text, columns, mark);
  }
  if (!extended.has_value() && IsPlyFile(argument)) {
    const std::string lost = absl::StrCat(
        "what else ", argument.text,
        " holds, such as colours, cannot be kept: it has changed meanwhile, or "
        "values cannot be added to it");
    std::error_code error;
    if (std::filesystem::equivalent(path, argument.text, error)) {
      return FileError(absl::FailedPreconditionError(
          absl::StrCat(lost, "; write to another file")));
    }
    session.err << "geodesic: " << Printable(lost) << '\n';
  }
  return WriteFile(path, [&](AtomicFile* file) {
    if (extended.has_value()) return file->Append(*extended);
    WritePly(mesh, columns, file, mark);
  });
}

void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content) {
  const auto show = [&](const auto& place) {
    if constexpr (std::is_same_v<decltype(place), const Curve&>) {
      PictureLine& line = content->bold_lines.emplace_back();
      for (const SurfacePoint& point : place.points) {
        line.points.push_back(PositionOf(point, mesh));
      }
    } else {
      content->sources.push_back(PositionOf(place, mesh));
    }
  };
  for (const Source& source : sources) std::visit(show, source.place);
}

void ShowTargets(const std::vector<SurfacePoint>& targets,
                 const MeshArrays& mesh, PictureContent* content) {
  for (const SurfacePoint& target : targets) {
    content->targets.push_back(PositionOf(target, mesh));
  }
}

absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options) {
  absl::StatusOr<std::string> png = Render(mesh, content, options).EncodePng();
  if (!png.ok()) return png.status();
  return WriteFile(path, [&png](AtomicFile* file) { file->Append(*png); });
}

absl::StatusOr<std::vector<WrittenFile>> WriteOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const AnswerInfo& info, std::initializer_list<OutputFormat> with_mesh,
    const std::function<absl::StatusOr<uint64_t>(
        const OutputArgument&, const MeshArrays& mesh)>& write) {
  std::vector<WrittenFile> written;
  const MeshArrays none;
  std::optional<MeshArrays> mesh;
  for (const OutputArgument& output : outputs) {
    if (session.call.stop.stop_requested()) {
      return absl::CancelledError("stopped before all files were written");
    }
    const bool needs_mesh = std::ranges::count(with_mesh, output.format) > 0;
    if (needs_mesh && !mesh.has_value()) {
      absl::StatusOr<MeshArrays> fetched = FetchMesh(session, info);
      if (!fetched.ok()) return fetched.status();
      mesh = *std::move(fetched);
    }
    const MeshArrays& wanted = needs_mesh ? *mesh : none;
    absl::StatusOr<uint64_t> bytes = write(output, wanted);
    if (!bytes.ok()) return bytes.status();
    written.push_back({output, *bytes});
  }
  return written;
}

}  // namespace geodesic::client
