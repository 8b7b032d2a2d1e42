#include "server/server.h"

#include <grpc/health/v1/health.pb.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/resource_quota.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <spdlog/spdlog.h>

#include <string>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "server/engine/base/status_details.h"
#include "server/operations/metrics.h"
#include "server/periodic.h"
#include "server/rpc/services.h"
#include "server/rpc/unary_calls.h"
#include "server/security/file_text.h"
#include "server/unix_socket.h"

namespace geodesic::server {
namespace {

// How long finished answers may take to be sent.
constexpr std::chrono::milliseconds kFlushGrace{500};

// How long the last files may take to be written to disk.
constexpr std::chrono::seconds kStoreGrace{2};

// How long cancelled calls may take to end.
constexpr std::chrono::seconds kCancelGrace{10};

constexpr int kMostReflections = 32;

// How often gRPC looks for a new certificate, by three calls of stat.
constexpr unsigned int kRefreshSeconds = 1;

double EndOf(const TlsFiles& files) {
  const auto end = CertificateEnd(files);
  if (!end.ok()) return 0;
  return std::chrono::duration<double>(end->time_since_epoch()).count();
}

void WarnIfExpired(const TlsFiles& files, spdlog::logger& logger) {
  const std::chrono::duration<double> now =
      std::chrono::system_clock::now().time_since_epoch();
  if (EndOf(files) > now.count()) return;
  logger.warn(
      "the certificate in {} has expired: clients will refuse it; a new one "
      "that is written over it is taken up without a restart",
      files.certificate);
}

// TLS credentials that follow the files: connections made after a file has
// changed get the new certificate, open ones keep the old one.
std::shared_ptr<grpc::ServerCredentials> MakeTlsCredentials(
    const TlsFiles& files) {
  grpc::experimental::TlsServerCredentialsOptions options(
      std::make_shared<grpc::experimental::FileWatcherCertificateProvider>(
          files.key, files.certificate, files.client_authorities,
          kRefreshSeconds));
  options.watch_identity_key_cert_pairs();
  if (!files.client_authorities.empty()) {
    options.watch_root_certs();
    options.set_cert_request_type(
        GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  }
  return grpc::experimental::TlsServerCredentials(options);
}

// Bounds what connections can hold, and closes those that are slow in the
// handshake or whose client is gone without a word.
void BoundConnections(const ServerOptions& options,
                      grpc::ServerBuilder& builder) {
  // Intake bounds the memory of messages for the protocol's methods; this also
  // bounds others', though a little late. Each reflection call takes a thread.
  builder.SetResourceQuota(grpc::ResourceQuota("geodesicd")
                               .Resize(2 * options.receive_memory_bytes)
                               .SetMaxThreads(kMostReflections));
  constexpr int kSecond = 1000;
  builder.AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS,
                             20 * kSecond);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 120 * kSecond);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 20 * kSecond);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  // A client that waits may ask every few seconds whether the server is there.
  builder.AddChannelArgument(
      GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 5 * kSecond);
  // The bytes a client may send on a stream that is not read, however fast the
  // connection is. While the stream is read, a whole message may come.
  builder.AddChannelArgument(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, 16 << 10);
  // A client's calls beyond this wait.
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS,
                             static_cast<int>(options.max_connection_streams));
}

// What the file at `path` says now; empty if it cannot be read.
std::string SecretIn(const std::string& path) {
  if (path.empty()) return "";
  const absl::StatusOr<std::string> text = ReadFileText(path);
  return text.ok() ? std::string(absl::StripAsciiWhitespace(*text)) : "";
}

// The largest upload, framed and as base64.
uint64_t MaxBodyBytes(const Limits& limits) {
  constexpr uint64_t kFrames = 1 << 20;
  return (limits.max_upload_bytes + limits.max_upload_bytes / 16) / 3 * 4 +
         kFrames;
}

}  // namespace

std::string_view ServerVersion() { return GEODESIC_VERSION; }

Server::Server(const ServerOptions& options,
               std::shared_ptr<spdlog::logger> logger, StartFunction start)
    : options_(options),
      logger_(std::move(logger)),
      access_(options.token_file),
      web_access_(options.web_token_file.empty() ? options.token_file
                                                 : options.web_token_file),
      quotas_(clock_),
      log_(logger_, options.max_requests, access_, web_access_, quotas_,
           metrics_),
      pool_(Scheduler::ThreadsFor(options.limits.max_concurrent_jobs)),
      engine_(options.limits, clock_, pool_, std::move(start)),
      intake_(
          {.slots = options.receive_memory_bytes / options.max_message_bytes,
           .patience = options.receive_patience,
           .memory_bytes = options.request_memory_bytes}),
      service_context_{
          engine_,
          log_,
          intake_,
          peers_,
          MakeCapabilities(options.limits, options.max_message_bytes,
                           std::string(ServerVersion())),
          options.send_patience},
      services_(MakeServices(service_context_)) {
  engine_.scheduler().ObserveJobs(
      clock_, [this](const JobTimes& times) { metrics_.JobEnded(times); });
  search_watch_ = Every(SearchPool::kPatience / 2,
                        [this] { engine_.searches().pool().DropOld(); });
  metrics_.Add([this] { return CollectEngine(engine_, intake_.memory()); });
  metrics_.AddGauge("geodesic_active_requests", "Requests that have not ended",
                    [this] { return static_cast<double>(log_.active()); });
  if (options_.tls.enabled()) {
    metrics_.AddGauge("geodesic_tls_certificate_end_seconds",
                      "When the certificate ends, in Unix time; 0 if it cannot "
                      "be read",
                      [this] { return EndOf(options_.tls); });
  }
}

Server::~Server() {
  if (grpc_server_ == nullptr) return;
  Shutdown(std::chrono::milliseconds(0));
  Wait();
}

absl::Status Server::OpenStores() {
  std::unique_ptr<DurableStore> durable;
  if (!options_.data_dir.empty()) {
    auto opened = OpenDataFolder();
    if (!opened.ok()) return opened.status();
    durable = *std::move(opened);
  }
  if (!options_.shared_tier.empty()) {
    if (absl::Status status = OpenSharedTier(); !status.ok()) return status;
    shared_meshes_.emplace(*shared_tier_);
    engine_.meshes().Attach(*shared_meshes_);
  }
  if (durable != nullptr || shared_tier_ != nullptr) {
    engine_.Attach(std::move(durable), std::string(ServerVersion()),
                   shared_tier_.get());
  }
  return absl::OkStatus();
}

absl::StatusOr<std::unique_ptr<DurableStore>> Server::OpenDataFolder() {
  absl::StatusOr<std::unique_ptr<DurableStore>> store =
      DurableStore::Open({.path = options_.data_dir,
                          .mesh_bytes = options_.limits.mesh_disk_bytes,
                          .field_bytes = options_.limits.field_disk_bytes,
                          .warn = [logger = logger_](const std::string& line) {
                            logger->error("data folder: {}", line);
                          }});
  if (!store.ok()) return store.status();
  const BlobStore& meshes = (*store)->meshes->blobs();
  const BlobStore& fields = *(*store)->fields;
  logger_->info("data folder {}: {} meshes ({} bytes), {} fields ({} bytes)",
                options_.data_dir, meshes.size(), meshes.used_bytes(),
                fields.size(), fields.used_bytes());
  return store;
}

absl::Status Server::OpenSharedTier() {
  const std::string& file = options_.shared_tier_password_file;
  if (!file.empty()) {
    const absl::StatusOr<std::string> password = ReadFileText(file);
    if (!password.ok()) return password.status();
  }
  shared_tier_ = std::make_unique<RedisBlobs>(RedisBlobs::Options{
      .address = options_.shared_tier,
      .patience = std::chrono::milliseconds(options_.shared_tier_timeout_ms),
      .expiry = options_.shared_tier_expiry,
      .max_bytes = options_.shared_tier_max_value_bytes,
      .connections = options_.limits.max_concurrent_jobs,
      // Redis refuses whoever comes without, and its words are logged.
      .password = [file] { return SecretIn(file); },
      .tell =
          [logger = logger_](const std::string& line) {
            logger->warn("shared tier: {}", line);
          }});
  metrics_.Add([this] { return CollectSharedTier(*shared_tier_); });
  return absl::OkStatus();
}

absl::Status Server::Start() {
  std::shared_ptr<grpc::ServerCredentials> credentials =
      grpc::InsecureServerCredentials();
  if (options_.tls.enabled()) {
    absl::StatusOr<TlsCopies> copies = TlsCopies::Make(options_.tls);
    if (!copies.ok()) return copies.status();
    tls_copies_.emplace(*std::move(copies));
    credentials = MakeTlsCredentials(tls_copies_->paths());
  }
  if (absl::Status status = ReloadTokens(); !status.ok()) return status;
  if (absl::Status status = OpenStores(); !status.ok()) return status;
  if (absl::Status status = Listen(std::move(credentials)); !status.ok()) {
    return status;
  }
  absl::Status status = OpenDoor();
  if (status.ok()) status = StartOperations();
  if (!status.ok()) {
    door_.reset();
    acceptor_->Stop();
    grpc_server_.reset();
    return status;
  }
  SetServing(true);
  return absl::OkStatus();
}

absl::Status Server::Listen(
    std::shared_ptr<grpc::ServerCredentials> credentials) {
  absl::StatusOr<std::unique_ptr<Acceptor>> acceptor =
      Acceptor::Listen(options_.listen);
  if (!acceptor.ok()) return acceptor.status();
  // Registers the descriptor of the health service for reflection.
  grpc::health::v1::HealthCheckRequest::descriptor();

  // Both act on every server that is built afterwards, which is only this one.
  grpc::EnableDefaultHealthCheckService(true);
  grpc::reflection::InitProtoReflectionServerBuilderPlugin();

  grpc::ServerBuilder builder;
  BoundConnections(options_, builder);
  builder.SetMaxReceiveMessageSize(
      static_cast<int>(options_.max_message_bytes));
  const std::shared_ptr<grpc::experimental::ExternalConnectionAcceptor>
      connections = builder.experimental().AddExternalConnectionAcceptor(
          grpc::ServerBuilder::experimental_type::ExternalConnectionType::
              FROM_FD,
          std::move(credentials));
  for (const auto& service : services_) builder.RegisterService(service.get());
  grpc_server_ = builder.BuildAndStart();
  if (grpc_server_ == nullptr) {
    return absl::UnavailableError("gRPC cannot start a server");
  }
  acceptor_ = *std::move(acceptor);
  acceptor_->Start([connections](int connection, int listener) {
    grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters
        accepted;
    accepted.listener_fd = listener;
    accepted.fd = connection;
    connections->HandleNewConnection(&accepted);
  });
  return absl::OkStatus();
}

absl::Status Server::OpenDoor() {
  if (options_.web_listen.empty()) return absl::OkStatus();
  WebDoorOptions options = {.listen = options_.web_listen,
                            .origins = options_.web_origins,
                            .max_message_bytes = options_.max_message_bytes,
                            .max_body_bytes = MaxBodyBytes(options_.limits),
                            .patience = options_.receive_patience};
  if (options_.tls.enabled()) {
    options.certificate = tls_copies_->texts().certificate;
    options.key = tls_copies_->texts().key;
  }
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);  // the server's own answers
  door_.emplace(std::move(options), grpc_server_->InProcessChannel(arguments),
                peers_, intake_);
  absl::Status status = door_->Start();
  if (!status.ok()) return status;
  logger_->info("the page is on port {} of {}", door_->port(),
                options_.web_listen);
  return absl::OkStatus();
}

absl::Status Server::StartOperations() {
  if (options_.tls.enabled()) {
    WarnIfExpired(options_.tls, *logger_);
    tls_watch_ =
        Every(std::chrono::seconds(1), [this, last = absl::Status()]() mutable {
          const absl::StatusOr<bool> changed = tls_copies_->Refresh();
          const absl::Status before = std::exchange(last, changed.status());
          if (changed.ok() && *changed) {
            logger_->info("the certificate in {} was read again",
                          options_.tls.certificate);
            WarnIfExpired(options_.tls, *logger_);
          } else if (!changed.ok() && changed.status() != before) {
            logger_->error("the certificate stays as it was: {}",
                           PrintableMessage(changed.status()));
          }
        });
  }
  if (!options_.token_file.empty()) {
    if (!options_.tls.enabled()) {
      logger_->warn(
          "tokens come in clear: without TLS whoever listens in on "
          "the way has them");
    }
    token_watch_ = WatchFile(options_.token_file, [this] { Reload(); });
  }
  if (!options_.web_token_file.empty()) {
    web_token_watch_ = WatchFile(options_.web_token_file, [this] { Reload(); });
  }
  if (options_.exit_when_idle.count() > 0) {
    idle_watch_ = Every(std::chrono::seconds(1), [this] {
      if (log_.IdleTime() < options_.exit_when_idle || !IsReady()) return;
      logger_->info("no request for {} s", options_.exit_when_idle.count());
      Shutdown(std::chrono::milliseconds(0));
    });
  }
  if (options_.metrics_listen.empty()) return absl::OkStatus();
  http_.emplace(HttpServer::Pages{.metrics = [this] { return metrics_.Text(); },
                                  .is_ready = [this] { return IsReady(); },
                                  .is_alive = [this] { return IsAlive(); }});
  absl::Status status = http_->Start(options_.metrics_listen);
  if (status.ok()) logger_->info("metrics on port {}", http_->port());
  return status;
}

absl::Status Server::ReloadTokens() {
  absl::Status status = access_.Reload();
  status.Update(web_access_.Reload());
  return status;
}

void Server::Reload() {
  if (options_.token_file.empty() && options_.web_token_file.empty()) return;
  const absl::Status status = ReloadTokens();
  metrics_.TokensReloaded(status.ok());
  if (status.ok()) {
    logger_->info("the tokens were read again");
  } else {
    logger_->error("the tokens stay as they were: {}",
                   PrintableMessage(status));
  }
}

bool Server::IsReady() {
  MutexLock lock(mutex_);
  return !draining_;
}

bool Server::IsAlive() {
  // The kernel does not say how many wait at a socket with a path.
  const std::optional<uint64_t> waiting =
      SocketPath(options_.listen) ? std::nullopt : WaitingConnections(port());
  return accept_watch_.IsServed(waiting.value_or(0), clock_.Now());
}

void Server::Shutdown(std::chrono::milliseconds grace) {
  MutexLock lock(mutex_);
  if (draining_) {
    hurry_.request_stop();
    return;
  }
  draining_ = true;
  drain_until_ = clock_.Now() + grace;
  SetServing(false);
  engine_.scheduler().BeginDrain();
  logger_->info("draining: {} requests go on for at most {:.0f} s",
                log_.active(), std::chrono::duration<double>(grace).count());
  shutdown_.notify_all();
}

Server::Ending Server::Wait() {
  TimePoint until;
  {
    MutexLock lock(mutex_);
    while (!draining_) shutdown_.wait(lock);
    until = drain_until_;
  }
  const bool in_order = log_.WaitIdle(until, hurry_.get_token());
  if (!in_order) logger_->warn("{} requests are cancelled", log_.active());
  // The jobs that are left write fields to disk.
  if (in_order) engine_.scheduler().WaitIdle(kStoreGrace);
  // Ends the requests that wait for a job. Shutdown cuts off those that stream.
  engine_.scheduler().StopAll();
  acceptor_->Stop();
  grpc_server_->Shutdown(std::chrono::system_clock::now() + kFlushGrace);
  log_.WaitIdle(clock_.Now() + kCancelGrace, std::stop_token());
  // What computes has stopped.
  if (!engine_.scheduler().WaitIdle(kStoreGrace)) {
    logger_->error(
        "{} jobs do not end; perhaps a disk does not answer, or a mesh is very "
        "hard",
        engine_.scheduler().running());
    return Ending::kStuck;
  }
  door_.reset();
  grpc_server_.reset();
  logger_->info("stopped");
  return in_order ? Ending::kInOrder : Ending::kCancelled;
}

void Server::SetServing(bool serving) {
  grpc::HealthCheckServiceInterface* health =
      grpc_server_->GetHealthCheckService();
  health->SetServingStatus("", serving);
  for (const auto& service : services_) {
    health->SetServingStatus(service->name(), serving);
  }
}

}  // namespace geodesic::server
