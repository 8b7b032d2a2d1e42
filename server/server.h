// Puts the service together: clock, threads, engine, gRPC.
//
//   Server server(options, logger);
//   absl::Status status = server.Start();
//   ...  // elsewhere, on a signal: server.Shutdown(grace);
//   Server::Ending ending = server.Wait();

#ifndef GEODESIC_SERVER_SERVER_H_
#define GEODESIC_SERVER_SERVER_H_

#include <chrono>
#include <condition_variable>
#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/acceptor.h"
#include "server/engine/base/clock.h"
#include "server/engine/jobs/thread_pool.h"
#include "server/engine/meshes/shared_meshes.h"
#include "server/engine/query_engine.h"
#include "server/locks/mutex.h"
#include "server/operations/accept_queue.h"
#include "server/operations/http_server.h"
#include "server/operations/metrics.h"
#include "server/options/options.h"
#include "server/rpc/calls/call.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/peer.h"
#include "server/rpc/calls/request_log.h"
#include "server/rpc/calls/service.h"
#include "server/security/access_control.h"
#include "server/security/quotas.h"
#include "server/security/tls_copies.h"
#include "server/tier/redis_blobs.h"
#include "server/web/web_door.h"

namespace grpc {
class Server;
class ServerCredentials;
}  // namespace grpc

namespace geodesic::server {

// Version of this program.
std::string_view ServerVersion();

class Server {
 public:
  // `start` is the seam where tests hold a solver up.
  Server(const ServerOptions& options, std::shared_ptr<spdlog::logger> logger,
         StartFunction start = &StartComputation);

  // Shuts down without grace if that was not done before.
  ~Server();

  // Opens the data folder, if one is set, binds the address and serves. Call
  // once.
  // Errors: UNAVAILABLE naming the folder that cannot be used or the address
  // that could not be bound; as TlsCopies::Make and AccessControl::Reload.
  absl::Status Start();

  // The port served on. REQUIRES: Start succeeded, not with a socket.
  int port() const { return acceptor_->port(); }

  // Begins to drain and returns at once: health checks answer NOT_SERVING, new
  // work is refused, and Wait cancels what has not ended after `grace`. A
  // second call cuts the grace short. Thread-safe. The server itself calls this
  // when it has been idle for options.exit_when_idle.
  // REQUIRES: Start succeeded.
  void Shutdown(std::chrono::milliseconds grace);

  enum class Ending {
    kInOrder,    // every request ended within the grace period
    kCancelled,  // some were cut off
    kStuck,      // so were some that wait for a disk, as the destructor would
  };
  // Waits for Shutdown and for the drain. Call once, after Start succeeded.
  Ending Wait();

  // Reads the tokens again; if they are malformed, logs it and keeps the old
  // ones. Thread-safe.
  void Reload();

  // The port of /metrics. REQUIRES: Start succeeded, with metrics_listen.
  int metrics_port() const { return http_->port(); }

  // The port of the page. REQUIRES: Start succeeded, with web_listen.
  int web_port() const { return door_->port(); }

  QueryEngine& engine() { return engine_; }

 private:
  // What outlives the server, and what it shares with others.
  absl::Status OpenStores();
  absl::StatusOr<std::unique_ptr<DurableStore>> OpenDataFolder();
  absl::Status OpenSharedTier();
  // Binds the address and serves.
  absl::Status Listen(std::shared_ptr<grpc::ServerCredentials> credentials);
  absl::Status ReloadTokens();
  // Serves browsers, if that is asked for.
  absl::Status OpenDoor();
  // Serves metrics, watches the token file and whether the server is idle.
  absl::Status StartOperations();
  void SetServing(bool serving);
  bool IsReady();
  // Called from one thread: that of http_.
  bool IsAlive();

  const ServerOptions options_;
  const std::shared_ptr<spdlog::logger> logger_;

  SteadyClock clock_;
  AccessControl access_;
  AccessControl web_access_;
  Quotas quotas_;
  Metrics metrics_;
  RequestLog log_;
  ThreadPool pool_;
  std::unique_ptr<RedisBlobs> shared_tier_;  // null without one
  std::optional<SharedMeshes> shared_meshes_;
  QueryEngine engine_;
  Intake intake_;
  const Peers peers_;
  const ServiceContext service_context_;
  const std::vector<std::unique_ptr<Service>> services_;
  std::optional<TlsCopies> tls_copies_;  // gRPC follows them
  std::unique_ptr<grpc::Server> grpc_server_;
  std::unique_ptr<Acceptor> acceptor_;
  AcceptWatch accept_watch_;

  std::stop_source hurry_;  // cuts the grace short

  Mutex mutex_;
  std::condition_variable_any shutdown_;
  bool draining_ ABSL_GUARDED_BY(mutex_) = false;
  TimePoint drain_until_ ABSL_GUARDED_BY(mutex_);

  // Last, because their threads use the other members.
  std::optional<WebDoor> door_;
  std::optional<HttpServer> http_;
  std::jthread tls_watch_;
  std::jthread token_watch_;
  std::jthread web_token_watch_;
  std::jthread search_watch_;
  std::jthread idle_watch_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_SERVER_H_
