#include "tests/reliability/mesh_ledger.h"

#include <cmath>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "tests/integration/meshes.h"

namespace geodesic::client {
namespace {

using State = LedgerMesh::State;

// Empty if the server gives the mesh out as it was sent.
std::string CheckArrays(Client& client, const LedgerMesh& mesh) {
  const absl::StatusOr<MeshArrays> read = client.ReadMesh(mesh.digest);
  if (!read.ok()) {
    return absl::StrCat("cannot be read: ", read.status().ToString());
  }
  return read->positions == mesh.arrays.positions &&
                 read->triangles == mesh.arrays.triangles
             ? ""
             : "is not what was sent";
}

std::string CheckAbsence(Client& client, const LedgerMesh& mesh) {
  const absl::Status get = client.GetMesh(mesh.digest).status();
  const absl::Status field = client
                                 .ComputeField({.mesh_digest = mesh.digest,
                                                .sources = {{VertexPoint{0}}}})
                                 .status();
  for (const absl::Status& status : {get, field}) {
    if (!absl::IsNotFound(status)) {
      return absl::StrCat("was deleted, but: ", status.ToString());
    }
  }
  return "";
}

// Empty if the mesh is as the ledger says, which `is_listed` then settles.
std::string CheckMesh(Client& client, LedgerMesh& mesh, bool is_listed) {
  if (mesh.state == State::kPresent && !is_listed) {
    return "was acknowledged and is lost";
  }
  if (mesh.state == State::kAbsent && is_listed) return "came back";
  mesh.state = is_listed ? State::kPresent : State::kAbsent;
  if (!is_listed) return CheckAbsence(client, mesh);
  std::string wrong = CheckArrays(client, mesh);
  if (!wrong.empty()) return wrong;
  const absl::StatusOr<Field> field = client.ComputeField(
      {.mesh_digest = mesh.digest, .sources = {{VertexPoint{0}}}});
  return field.ok() ? CheckField(mesh, 0, *field) : field.status().ToString();
}

}  // namespace

std::vector<LedgerMesh> MakeLedger(size_t count) {
  std::vector<LedgerMesh> ledger;
  for (size_t i = 0; i < count; ++i) {
    LedgerMesh mesh;
    // From 50 faces to some ten thousand.
    mesh.arrays = PlanarGrid(static_cast<uint32_t>(5 + 7 * (i % 10)));
    // No two are the same.
    const double scale = 1 + static_cast<double>(i);
    for (Point& p : mesh.arrays.positions) p[0] *= scale;
    mesh.digest = MeshDigest(mesh.arrays);
    ledger.push_back(std::move(mesh));
  }
  return ledger;
}

std::string CheckField(const LedgerMesh& mesh, uint64_t source,
                       const Field& field) {
  const std::vector<Point>& positions = mesh.arrays.positions;
  if (field.distances.size() != positions.size()) {
    return absl::StrCat("has ", field.distances.size(), " distances for ",
                        positions.size(), " vertices");
  }
  const Point& from = positions[source];
  for (size_t v = 0; v < positions.size(); ++v) {
    const double expected =
        std::hypot(positions[v][0] - from[0], positions[v][1] - from[1]);
    if (!(std::abs(field.distances[v] - expected) <= 1e-9 * (1 + expected))) {
      return absl::StrCat("distance ", field.distances[v], " at vertex ", v,
                          " instead of ", expected);
    }
  }
  return "";
}

std::vector<std::string> CheckLedger(Client& client,
                                     std::vector<LedgerMesh>& ledger) {
  const absl::StatusOr<std::vector<MeshInfo>> list = client.ListMeshes();
  if (!list.ok()) {
    return {absl::StrCat("cannot list: ", list.status().ToString())};
  }
  std::set<std::string> listed;
  for (const MeshInfo& info : *list) listed.insert(info.digest);
  std::vector<std::string> wrong;
  for (LedgerMesh& mesh : ledger) {
    const bool is_listed = listed.erase(mesh.digest) > 0;
    const std::string fault = CheckMesh(client, mesh, is_listed);
    if (!fault.empty()) {
      wrong.push_back(absl::StrCat("mesh ", mesh.digest, " ", fault));
    }
  }
  for (const std::string& digest : listed) {
    wrong.push_back(absl::StrCat("mesh ", digest, " was never sent"));
  }
  return wrong;
}

}  // namespace geodesic::client
