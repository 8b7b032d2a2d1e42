#include "server/rpc/siblings.h"

#include <grpcpp/create_channel.h>

#include <chrono>
#include <cstring>
#include <utility>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr char kSiblingMetadata[] = "geo-sibling";

// Whether a mesh is there is known at once. A sibling that takes longer counts
// as gone.
constexpr std::chrono::seconds kFindPatience{2};
// One that did not answer is not asked again for so long.
constexpr std::chrono::seconds kSilence{10};
// How often it is checked whether anybody still waits.
constexpr std::chrono::milliseconds kPollPeriod{50};
// Of a sibling's words in an error.
constexpr size_t kMostWords = 200;
// For all of a mesh: a hundred million faces take about that long on a network
// of 100 MB/s.
constexpr std::chrono::seconds kReadPatience{60};

// Meshes that wait to be spread; the oldest give way.
constexpr size_t kMostToSpread = 1024;
constexpr size_t kCopies = 2;

// Copies the next items of an array from a message. Whether they fit.
template <typename Item>
bool Append(const std::string& bytes, uint64_t first, uint64_t count,
            std::vector<Item>& items) {
  const uint64_t added = bytes.size() / sizeof(Item);
  if (bytes.size() % sizeof(Item) != 0 || first != items.size() ||
      added > count - items.size()) {
    return false;
  }
  items.resize(items.size() + added);
  std::memcpy(items.data() + first, bytes.data(), bytes.size());
  return true;
}

bool Append(const v1::ReadMeshResponse& message, const SiblingMesh& mesh,
            TriangleSoup& soup) {
  switch (message.part_case()) {
    case v1::ReadMeshResponse::kHeader: {
      const v1::ReadMeshHeader& header = message.header();
      soup.reading.seam_edges = header.seam_edge_count();
      soup.reading.crossing_polygons = header.crossing_polygon_count();
      soup.reading.first_crossing_polygon = header.first_crossing_polygon();
      return true;
    }
    case v1::ReadMeshResponse::kJoined:
      return Append(message.joined().pairs(), message.joined().first_pair(),
                    mesh.vertices, soup.reading.joined);
    case v1::ReadMeshResponse::kVertices:
      return Append(message.vertices().positions(),
                    message.vertices().first_vertex(), mesh.vertices,
                    soup.positions);
    case v1::ReadMeshResponse::kFaces:
      return Append(message.faces().indices(), message.faces().first_face(),
                    mesh.faces, soup.triangles);
    default:
      return true;
  }
}

int64_t SteadyNow() {
  return std::chrono::steady_clock::now().time_since_epoch().count();
}

std::string WordsOf(const grpc::Status& status) {
  return status.error_message().substr(0, kMostWords);
}

// Cancels a call when nobody waits for it any more, or the server ends.
class Watch {
 public:
  // Polls the checkpoint until Stop; nobody else may.
  Watch(grpc::ClientContext& context, Checkpoint& checkpoint)
      : thread_([this, &context, &checkpoint](const std::stop_token& stop) {
          std::unique_lock lock(mutex_);
          while (!stop.stop_requested()) {
            status_ = checkpoint.Poll({});
            if (!status_.ok()) {
              context.TryCancel();
              return;
            }
            waiting_.wait_for(lock, stop, kPollPeriod, [] { return false; });
          }
        }) {}

  // What the checkpoint said.
  absl::Status Stop() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    return status_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any waiting_;
  absl::Status status_;
  std::jthread thread_;  // last, since it uses the others
};

}  // namespace

bool IsFromSibling(const grpc::ServerContextBase& context) {
  return context.client_metadata().count(kSiblingMetadata) > 0;
}

Siblings::Siblings(const std::vector<std::string>& addresses,
                   const std::shared_ptr<grpc::ChannelCredentials>& credentials,
                   std::function<std::string()> token)
    : token_(std::move(token)), silent_until_(addresses.size()) {
  for (const std::string& address : addresses) {
    std::shared_ptr<grpc::Channel> channel =
        grpc::CreateChannel(address, credentials);
    auto meshes = v1::MeshService::NewStub(channel);
    siblings_.push_back({address, std::move(channel), std::move(meshes)});
  }
  spreader_ =
      std::jthread([this](const std::stop_token& stop) { SpreadAll(stop); });
}

void Siblings::Prepare(grpc::ClientContext& context,
                       const std::string& digest) const {
  context.AddMetadata("geo-mesh-digest", digest);
  const std::string token = token_();
  if (!token.empty()) {
    context.AddMetadata("authorization", absl::StrCat("Bearer ", token));
  }
}

grpc::Status Siblings::GetMesh(size_t i, const std::string& digest,
                               std::chrono::seconds patience,
                               grpc::ClientContext& context,
                               v1::GetMeshResponse& response) const {
  Prepare(context, digest);
  context.set_deadline(std::chrono::system_clock::now() + patience);
  // gRPC's own pause before it connects again is up to two minutes, and may be
  // longer if the clock is set back meanwhile.
  grpc::Channel& channel = *siblings_[i].channel;
  if (channel.GetState(false) == GRPC_CHANNEL_TRANSIENT_FAILURE) {
    grpc::experimental::ChannelResetConnectionBackoff(&channel);
  }
  v1::GetMeshRequest request;
  request.set_digest(digest);
  return siblings_[i].meshes->GetMesh(&context, request, &response);
}

grpc::Status Siblings::Ask(size_t i, const std::string& digest,
                           grpc::ClientContext& context,
                           v1::GetMeshResponse& response) {
  if (SteadyNow() < silent_until_[i]) {
    return {grpc::StatusCode::DEADLINE_EXCEEDED, "it did not answer before"};
  }
  context.AddMetadata(kSiblingMetadata, "1");
  grpc::Status status = GetMesh(i, digest, kFindPatience, context, response);
  if (status.error_code() == grpc::StatusCode::DEADLINE_EXCEEDED) {
    silent_until_[i] = SteadyNow() + std::chrono::nanoseconds(kSilence).count();
  }
  return status;
}

absl::StatusOr<SiblingMesh> Siblings::Find(const std::string& digest,
                                           size_t first,
                                           Checkpoint& checkpoint) {
  std::string silent;
  for (size_t i = first; i < siblings_.size(); ++i) {
    grpc::ClientContext context;
    v1::GetMeshResponse response;
    Watch watch(context, checkpoint);
    const grpc::Status status = Ask(i, digest, context, response);
    if (absl::Status s = watch.Stop(); !s.ok()) return s;
    if (status.ok()) {
      return SiblingMesh{.digest = digest,
                         .vertices = response.mesh().vertex_count(),
                         .faces = response.mesh().face_count(),
                         .sibling = i};
    }
    if (status.error_code() != grpc::StatusCode::NOT_FOUND) {
      absl::StrAppend(&silent, silent.empty() ? "" : "; ", siblings_[i].address,
                      ": ", WordsOf(status));
    }
  }
  if (silent.empty()) {
    return absl::NotFoundError(absl::StrCat("no sibling has mesh ", digest));
  }
  return absl::UnavailableError(
      absl::StrCat("mesh ", digest,
                   " is not here, and some siblings did not say whether "
                   "they have it: ",
                   silent));
}

absl::StatusOr<TriangleSoup> Siblings::Read(const SiblingMesh& mesh,
                                            Checkpoint& checkpoint) {
  const Sibling& sibling = siblings_[mesh.sibling];
  grpc::ClientContext context;
  Prepare(context, mesh.digest);
  context.AddMetadata(kSiblingMetadata, "1");
  context.set_deadline(std::chrono::system_clock::now() + kReadPatience);
  v1::ReadMeshRequest request;
  request.set_digest(mesh.digest);
  TriangleSoup soup;
  soup.positions.reserve(mesh.vertices);
  soup.triangles.reserve(mesh.faces);
  Watch watch(context, checkpoint);
  const auto reader = sibling.meshes->ReadMesh(&context, request);
  v1::ReadMeshResponse message;
  bool fits = true;
  while (fits && reader->Read(&message)) fits = Append(message, mesh, soup);
  if (!fits) context.TryCancel();
  const grpc::Status status = reader->Finish();
  if (absl::Status s = watch.Stop(); !s.ok()) return s;
  if (!fits) {
    return absl::UnavailableError(
        absl::StrCat(sibling.address, " sent another mesh than ", mesh.digest,
                     ", or out of order"));
  }
  if (!status.ok()) {
    return absl::UnavailableError(
        absl::StrCat("mesh ", mesh.digest, " did not come whole from ",
                     sibling.address, ": ", WordsOf(status)));
  }
  return soup;
}

void Siblings::Spread(const MeshHandle& mesh) {
  {
    std::lock_guard lock(mutex_);
    to_spread_.push_back(mesh->digest);
    if (to_spread_.size() > kMostToSpread) to_spread_.pop_front();
  }
  has_work_.notify_one();
}

void Siblings::SpreadAll(const std::stop_token& stop) {
  for (;;) {
    std::string digest;
    {
      std::unique_lock lock(mutex_);
      if (!has_work_.wait(lock, stop, [this] { return !to_spread_.empty(); })) {
        return;
      }
      digest = std::move(to_spread_.front());
      to_spread_.pop_front();
    }
    SpreadOne(digest, stop);
  }
}

void Siblings::SpreadOne(const std::string& digest,
                         const std::stop_token& stop) {
  // Not always the same ones.
  const size_t first = std::hash<std::string>()(digest);
  size_t copies = 0;
  for (size_t k = 0; k < siblings_.size() && copies < kCopies; ++k) {
    const size_t i = (first + k) % siblings_.size();
    v1::GetMeshResponse response;
    {
      grpc::ClientContext context;
      const std::stop_callback cancel(stop, [&] { context.TryCancel(); });
      const grpc::Status status = Ask(i, digest, context, response);
      copies += status.ok();
      if (status.error_code() != grpc::StatusCode::NOT_FOUND) continue;
    }
    // As a client, so that the sibling fetches it.
    grpc::ClientContext context;
    const std::stop_callback cancel(stop, [&] { context.TryCancel(); });
    copies += GetMesh(i, digest, kReadPatience, context, response).ok();
  }
}

}  // namespace geodesic::server
