#include "tests/reliability/mixed_load.h"

#include <chrono>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "tests/integration/meshes.h"

namespace geodesic::client {
namespace {

using State = LedgerMesh::State;

// No call hangs, whatever the server does.
const CallOptions kPatience = {.timeout = std::chrono::seconds(60)};

// Empty if the field from this vertex is the right one, else what is wrong.
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

// Empty if these are the arrays that were sent.
std::string CheckArrays(const LedgerMesh& mesh, const MeshArrays& read) {
  return read.positions == mesh.arrays.positions &&
                 read.triangles == mesh.arrays.triangles
             ? ""
             : "is not what was sent";
}

// Empty if the server gives the mesh out as it was sent.
std::string CheckRead(Client& client, const LedgerMesh& mesh) {
  const absl::StatusOr<MeshArrays> read = client.ReadMesh(mesh.digest);
  return read.ok() ? CheckArrays(mesh, *read)
                   : absl::StrCat("cannot be read: ", read.status().ToString());
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
  std::string wrong = CheckRead(client, mesh);
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

MixedLoad::MixedLoad(const std::string& address,
                     std::vector<LedgerMesh>& ledger, LoadCounts& counts,
                     size_t clients, uint64_t seed)
    : ledger_(ledger), counts_(counts), clients_(clients), running_(clients) {
  for (size_t i = 0; i < clients; ++i) {
    threads_.emplace_back(
        [this, address, i, seed] { Run(address, i, seed + i); });
  }
}

void MixedLoad::AwaitAnswers(uint64_t answers) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return answers_ >= answers || running_ == 0; });
}

void MixedLoad::Join() {
  for (std::thread& thread : threads_) thread.join();
}

void MixedLoad::Run(const std::string& address, size_t number, uint64_t seed) {
  Client client(address);
  std::mt19937_64 random(seed);
  const size_t shares = ledger_.size() / clients_;
  for (bool goes_on = true; goes_on;) {
    // Every clients_-th mesh from `number` on is this client's own.
    const size_t own = number + clients_ * (random() % shares);
    if (random() % 2 == 0) {
      goes_on = Change(client, ledger_[own]);
    } else {
      const bool is_own = random() % 2 == 0;
      const size_t any = is_own ? own : random() % ledger_.size();
      goes_on = Ask(client, ledger_[any], is_own, random());
    }
    std::lock_guard lock(mutex_);
    ++answers_;
    changed_.notify_one();
  }
  std::lock_guard lock(mutex_);
  --running_;
  changed_.notify_one();
}

bool MixedLoad::Change(Client& client, LedgerMesh& mesh) {
  const bool upload = mesh.state != State::kPresent;
  // Between the call and its answer the ledger knows neither.
  mesh.state = State::kEither;
  const absl::Status status =
      upload ? client.UploadArrays(mesh.arrays, kPatience).status()
             : client.DeleteMesh(mesh.digest, kPatience);
  if (status.ok()) {
    mesh.state = upload ? State::kPresent : State::kAbsent;
    ++(upload ? counts_.uploads : counts_.deletions);
    return true;
  }
  ++counts_.unanswered;
  return !IsGone(status, upload ? "an upload" : "a deletion");
}

bool MixedLoad::Ask(Client& client, const LedgerMesh& mesh, bool is_own,
                    uint64_t random) {
  absl::Status status;
  std::string fault;
  if (random % 4 == 0) {
    const absl::StatusOr<MeshArrays> read =
        client.ReadMesh(mesh.digest, kPatience);
    status = read.status();
    if (read.ok()) fault = CheckArrays(mesh, *read);
    if (read.ok()) ++counts_.reads;
  } else {
    // A few sources, so that some fields are found and others computed.
    const auto source = static_cast<uint32_t>(random / 4 % 8);
    const absl::StatusOr<Field> field = client.ComputeField(
        {.mesh_digest = mesh.digest, .sources = {{VertexPoint{source}}}},
        kPatience);
    status = field.status();
    if (field.ok()) fault = CheckField(mesh, source, *field);
    if (field.ok()) ++counts_.fields;
  }
  // Who owns a mesh knows whether it is there.
  if (is_own && status.ok() != (mesh.state == State::kPresent) &&
      (status.ok() || absl::IsNotFound(status))) {
    fault = status.ok() ? "was deleted and is served"
                        : "was acknowledged and is not found";
  }
  if (!fault.empty()) Report(absl::StrCat("mesh ", mesh.digest, " ", fault));
  if (status.ok() || absl::IsNotFound(status)) return true;
  return !IsGone(status, "a question");
}

bool MixedLoad::IsGone(const absl::Status& status, const std::string& what) {
  if (is_dying_) return true;
  Report(absl::StrCat(what, " failed: ", status.ToString()));
  // A server that has died by itself answers nobody any more.
  return absl::IsUnavailable(status);
}

void MixedLoad::Report(const std::string& fault) {
  std::lock_guard lock(mutex_);
  wrong_.push_back(fault);
}

}  // namespace geodesic::client
