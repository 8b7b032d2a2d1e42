// libFuzzer target: a server's door for browsers gets an input as the bytes of
// a connection, or as the body of a call. It must answer every call, in time,
// and go on.

#include <arpa/inet.h>
#include <fuzzer/FuzzedDataProvider.h>
#include <netinet/in.h>
#include <poll.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/server.h"

namespace geodesic::server {
namespace {

// Much longer than any answer takes.
constexpr timeval kPatience = {.tv_sec = 20, .tv_usec = 0};

constexpr const char* kMethods[] = {
    "/grpc.health.v1.Health/Check",
    "/geodesic.v1.MeshService/FindMissingMeshes",
    "/geodesic.v1.MeshService/CreateMesh",
    "/geodesic.v1.MeshService/GetMesh",
    "/geodesic.v1.MeshService/ReadMesh",
    "/geodesic.v1.QuestionService/ComputeField",
    "/geodesic.v1.QuestionService/ComputePairs",
    "/geodesic.v1.CapabilitiesService/GetCapabilities",
    "/nothing.Here/AtAll"};
constexpr const char* kTypes[] = {"application/grpc-web+proto",
                                  "application/grpc-web-text", "text/plain"};

ServerOptions SmallServer() {
  ServerOptions options;
  options.listen = "127.0.0.1:0";
  options.web_listen = "127.0.0.1:0";
  options.limits.max_concurrent_jobs = 1;
  options.limits.max_vertices = 10'000;
  options.limits.max_faces = 20'000;
  options.limits.max_upload_bytes = 1 << 20;
  options.max_message_bytes = 1 << 18;
  return options;
}

// libFuzzer's clock has interrupted connect(), which goes on. Whether it
// succeeds; errno says why it does not.
bool Connects(int connection) {
  pollfd events = {.fd = connection, .events = POLLOUT};
  while (poll(&events, 1, -1) < 0 && errno == EINTR) {
  }
  socklen_t size = sizeof(errno);
  getsockopt(connection, SOL_SOCKET, SO_ERROR, &errno, &size);
  return errno == 0;
}

class Door {
 public:
  Door() {
    if (!server_.Start().ok()) std::abort();
  }

  // A connection to it, whose reads do not wait for ever.
  int Connect() const {
    const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(server_.web_port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(connection, reinterpret_cast<const sockaddr*>(&address),
                sizeof(address)) != 0 &&
        (errno != EINTR || !Connects(connection))) {
      std::perror("connect");
      std::abort();
    }
    setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &kPatience,
               sizeof(kPatience));
    return connection;
  }

 private:
  Server server_{SmallServer(),
                 std::make_shared<spdlog::logger>(
                     "", std::make_shared<spdlog::sinks::null_sink_mt>())};
};

void Send(int connection, const std::string& bytes) {
  size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = send(connection, bytes.data() + sent,
                               bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    // The server may end a connection that makes no sense.
    if (count <= 0) return;
    sent += static_cast<size_t>(count);
  }
}

// What comes until the server ends the connection.
std::string ReceiveAll(int connection) {
  std::string received;
  std::array<char, 4096> piece = {};
  for (;;) {
    const ssize_t count = recv(connection, piece.data(), piece.size(), 0);
    if (count == 0) return received;
    if (count < 0) {
      // libFuzzer's clock interrupts.
      if (errno == EINTR) continue;
      if (errno == ECONNRESET) return received;
      std::fprintf(stderr, "no end of the answer in time: %s\n",
                   received.c_str());
      std::abort();
    }
    received.append(piece.data(), static_cast<size_t>(count));
  }
}

void Check(FuzzedDataProvider& data) {
  static const Door door;
  const int connection = door.Connect();
  if (data.ConsumeBool()) {
    // What it makes of this is its own affair, as long as it goes on.
    Send(connection, data.ConsumeRemainingBytesAsString());
    const int other = door.Connect();
    Send(other,
         "GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    if (!ReceiveAll(other).starts_with("HTTP/1.1 200")) std::abort();
    close(other);
  } else {
    const std::string method = data.PickValueInArray(kMethods);
    const std::string type = data.PickValueInArray(kTypes);
    const std::string header = data.ConsumeRandomLengthString(64);
    const std::string body = data.ConsumeRemainingBytesAsString();
    const bool is_plain =
        header.find_first_of(std::string("\r\n\0", 3)) == std::string::npos;
    Send(connection,
         absl::StrCat("POST ", method,
                      " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n",
                      "Content-Type: ", type, "\r\n",
                      is_plain ? absl::StrCat("x-fuzz-bin: ", header, "\r\n")
                               : std::string(),
                      "Content-Length: ", body.size(), "\r\n\r\n", body));
    const std::string answer = ReceiveAll(connection);
    if (!answer.starts_with("HTTP/1.1 ")) std::abort();
  }
  close(connection);
}

}  // namespace
}  // namespace geodesic::server

// The server's threads live on when libFuzzer looks for leaks at its end, and
// what OpenSSL keeps for a thread is not seen from there.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libcrypto.so\n";
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  FuzzedDataProvider data(bytes, size);
  geodesic::server::Check(data);
  return 0;
}
