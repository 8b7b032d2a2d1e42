// Fetches meshes from other servers.

#ifndef GEODESIC_SERVER_RPC_SIBLINGS_H_
#define GEODESIC_SERVER_RPC_SIBLINGS_H_

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/security/credentials.h>
#include <grpcpp/server_context.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.grpc.pb.h"
#include "server/engine/meshes/mesh_siblings.h"

namespace geodesic::server {

// Whether the caller is a sibling. It is answered from what is here, so that
// two servers do not ask each other forever.
bool IsFromSibling(const grpc::ServerContextBase& context);

// Asks the siblings in the order of their addresses, and spreads meshes to two
// of them from a thread of its own. Thread-safe.
class Siblings final : public MeshSiblings {
 public:
  // REQUIRES: `addresses` is not empty. `token` returns what they are asked
  // with; nothing if it is empty.
  Siblings(const std::vector<std::string>& addresses,
           const std::shared_ptr<grpc::ChannelCredentials>& credentials,
           std::function<std::string()> token);

  absl::StatusOr<SiblingMesh> Find(const std::string& digest, size_t first,
                                   Checkpoint& checkpoint) override;
  absl::StatusOr<TriangleSoup> Read(const SiblingMesh& mesh,
                                    Checkpoint& checkpoint) override;
  void Spread(const MeshHandle& mesh) override;

 private:
  struct Sibling {
    std::string address;
    std::shared_ptr<grpc::Channel> channel;
    std::unique_ptr<v1::MeshService::Stub> meshes;
  };

  void Prepare(grpc::ClientContext& context, const std::string& digest) const;
  // Has sibling `i` describe the mesh, which it fetches if it lacks it.
  grpc::Status GetMesh(size_t i, const std::string& digest,
                       std::chrono::seconds patience,
                       grpc::ClientContext& context,
                       v1::GetMeshResponse& response) const;
  // Asks sibling `i` for what it has itself. Does not ask one that was silent a
  // moment ago.
  grpc::Status Ask(size_t i, const std::string& digest,
                   grpc::ClientContext& context, v1::GetMeshResponse& response);
  // Spreads what is in the queue until it is told to stop.
  void SpreadAll(const std::stop_token& stop);
  // Makes two siblings have the mesh; one of them may be this server.
  void SpreadOne(const std::string& digest, const std::stop_token& stop);

  std::vector<Sibling> siblings_;
  const std::function<std::string()> token_;
  // Of each sibling: until when it counts as silent, in steady nanoseconds.
  std::vector<std::atomic<int64_t>> silent_until_;

  std::mutex mutex_;
  std::condition_variable_any has_work_;
  std::deque<std::string> to_spread_;  // guarded by mutex_
  std::jthread spreader_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_SIBLINGS_H_
