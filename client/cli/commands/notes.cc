#include "client/cli/commands/notes.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "client/cli/terminal/text.h"
#include "client/places/reach.h"

namespace geodesic::client {
namespace {

// The vertex that a source is, or that its curve begins at. Neither edges nor
// faces are without one.
std::optional<uint32_t> VertexOf(const Source& source) {
  const VertexPoint* const first = AsVertex(FirstPoint(source));
  return first == nullptr ? std::nullopt : std::optional(first->vertex);
}

}  // namespace

absl::StatusOr<std::vector<std::string>> NotesOnSources(
    const Session& session, const std::string& mesh_digest,
    std::span<const Source> sources) {
  std::vector<uint64_t> vertices;
  for (const Source& source : sources) {
    if (const auto vertex = VertexOf(source)) vertices.push_back(*vertex);
  }
  if (vertices.empty()) return std::vector<std::string>();
  absl::StatusOr<MeshInfo> info =
      session.client.GetMesh(mesh_digest, session.call);
  // The shared tier may have it, from which the question fetches it.
  if (absl::IsNotFound(info.status())) return std::vector<std::string>();
  if (!info.ok()) return info.status();
  if (info->isolated_vertices == 0) return std::vector<std::string>();
  absl::StatusOr<MeshArrays> mesh =
      session.client.ReadMesh(mesh_digest, session.call);
  if (!mesh.ok()) return mesh.status();
  const Reach reach(*mesh, sources);
  std::erase_if(vertices,
                [&](uint64_t vertex) { return !reach.IsIsolated(vertex); });
  if (vertices.empty()) return std::vector<std::string>();
  const std::string others =
      vertices.size() == 1
          ? " is"
          : absl::StrCat(" and ", GroupedNumber(vertices.size() - 1),
                         " more sources are");
  return std::vector{absl::StrCat("vertex ", vertices[0], others,
                                  " on no face: nothing else can be reached "
                                  "from there")};
}

std::vector<std::string> WhyUnreached(const Session& session,
                                      const std::string& mesh_digest,
                                      std::span<const Source> sources,
                                      std::span<const SurfacePoint> targets,
                                      std::span<const double> distances,
                                      const std::string& otherwise) {
  std::vector<std::string> reasons(targets.size());
  const auto is_finite = [](double distance) {
    return std::isfinite(distance);
  };
  if (std::ranges::all_of(distances, is_finite)) return reasons;
  const absl::StatusOr<MeshArrays> mesh =
      session.client.ReadMesh(mesh_digest, session.call);
  std::optional<Reach> reach;
  if (mesh.ok()) reach.emplace(*mesh, sources);
  for (size_t i = 0; i < targets.size(); ++i) {
    if (is_finite(distances[i])) continue;
    reasons[i] = reach.has_value() ? reach->WhyUnreached(targets[i], otherwise)
                                   : otherwise;
  }
  return reasons;
}

std::string BeyondRadius(std::optional<double> radius) {
  return radius.has_value() ? absl::StrCat("it is farther than the radius, ",
                                           ShortNumber(*radius))
                            : "no path leads there";
}

void PrintNotes(const Session& session, std::span<const std::string> notes) {
  for (const std::string& note : notes) {
    session.err << "geodesic: " << Printable(note) << '\n';
  }
}

}  // namespace geodesic::client
