#include "tests/reliability/mixed_load.h"

#include <chrono>
#include <random>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic_client/client.h"

namespace geodesic::client {
namespace {

using State = LedgerMesh::State;

// No call hangs, whatever the server does.
const CallOptions kPatience = {.timeout = std::chrono::seconds(60)};

}  // namespace

LoadCounts& LoadCounts::operator+=(const LoadCounts& other) {
  uploads += other.uploads;
  deletions += other.deletions;
  fields += other.fields;
  reads += other.reads;
  unanswered += other.unanswered;
  return *this;
}

MixedLoad::MixedLoad(const std::string& address,
                     std::vector<LedgerMesh>& ledger, size_t clients,
                     uint64_t seed)
    : ledger_(ledger), clients_(clients), running_(clients) {
  for (size_t i = 0; i < clients; ++i) {
    threads_.emplace_back(
        [this, address, i, seed] { Run(address, i, seed + i); });
  }
}

void MixedLoad::AwaitAnswers(uint64_t answers) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return answers_ >= answers || running_ == 0; });
}

LoadCounts MixedLoad::Join() {
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  return counts_;
}

void MixedLoad::Run(const std::string& address, size_t number, uint64_t seed) {
  Client client(address);
  std::mt19937_64 random(seed);
  LoadCounts counts;
  const size_t shares = ledger_.size() / clients_;
  for (bool goes_on = true; goes_on;) {
    // Every clients_-th mesh from `number` on is this client's own.
    const size_t own = number + clients_ * (random() % shares);
    if (random() % 2 == 0) {
      goes_on = Change(client, ledger_[own], counts);
    } else {
      const bool is_own = random() % 2 == 0;
      const size_t any = is_own ? own : random() % ledger_.size();
      goes_on = Ask(client, ledger_[any], is_own, random(), counts);
    }
    std::lock_guard lock(mutex_);
    ++answers_;
    changed_.notify_one();
  }
  std::lock_guard lock(mutex_);
  counts_ += counts;
  --running_;
  changed_.notify_one();
}

bool MixedLoad::Change(Client& client, LedgerMesh& mesh, LoadCounts& counts) {
  const bool upload = mesh.state != State::kPresent;
  // Between the call and its answer the ledger knows neither.
  mesh.state = State::kEither;
  const absl::Status status =
      upload ? client.UploadArrays(mesh.arrays, kPatience).status()
             : client.DeleteMesh(mesh.digest, kPatience);
  if (status.ok()) {
    mesh.state = upload ? State::kPresent : State::kAbsent;
    ++(upload ? counts.uploads : counts.deletions);
    return true;
  }
  ++counts.unanswered;
  return !IsGone(status, upload ? "an upload" : "a deletion");
}

bool MixedLoad::Ask(Client& client, const LedgerMesh& mesh, bool is_own,
                    uint64_t random, LoadCounts& counts) {
  absl::Status status;
  std::string fault;
  if (random % 4 == 0) {
    const absl::StatusOr<MeshArrays> read =
        client.ReadMesh(mesh.digest, kPatience);
    status = read.status();
    if (read.ok() && (read->positions != mesh.arrays.positions ||
                      read->triangles != mesh.arrays.triangles)) {
      fault = "is not what was sent";
    }
    if (read.ok()) ++counts.reads;
  } else {
    // A few sources, so that some fields are found and others computed.
    const uint64_t source = random / 4 % 8;
    const absl::StatusOr<Field> field = client.ComputeField(
        {.mesh_digest = mesh.digest, .sources = {{VertexPoint{source}}}},
        kPatience);
    status = field.status();
    if (field.ok()) fault = CheckField(mesh, source, *field);
    if (field.ok()) ++counts.fields;
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
