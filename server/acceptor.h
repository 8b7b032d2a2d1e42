// Listens on the port of gRPC and accepts connections there. gRPC's own
// listeners stop for good once they find no descriptor for a connection.

#ifndef GEODESIC_SERVER_ACCEPTOR_H_
#define GEODESIC_SERVER_ACCEPTOR_H_

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

class Acceptor {
 public:
  // Takes a connection and its descriptor, which it closes.
  using Take = std::function<void(int connection, int listener)>;

  // Descriptors that connections leave to all else: files, the page's port, the
  // port of metrics.
  static constexpr int kKeptDescriptors = 64;

  // Binds "HOST:PORT", on each address that the host has, or "unix:PATH", which
  // is then this user's alone. Port 0: any that is free.
  // Errors: INVALID_ARGUMENT, UNAVAILABLE naming the address.
  static absl::StatusOr<std::unique_ptr<Acceptor>> Listen(
      const std::string& address);

  // Removes the socket of a path.
  ~Acceptor();
  Acceptor(const Acceptor&) = delete;
  Acceptor& operator=(const Acceptor&) = delete;

  // 0 for a path.
  int port() const { return port_; }

  // From now on passes connections to `take`, from one thread. Those that would
  // take one of the last kKeptDescriptors are closed instead.
  void Start(Take take);

  // Closes the sockets; `take` is called no more.
  void Stop();

 private:
  Acceptor() = default;

  absl::Status ListenOnPath(const std::string& path);
  absl::Status ListenOnPort(const std::string& address);
  void Serve();
  // Accepts all who wait. Whether there was a descriptor for each.
  bool AcceptAll(int listener);
  // Closes a connection that waits; false, and errno set, if it cannot.
  bool CloseOne(int listener);

  std::vector<FileDescriptor> listeners_;
  int port_ = 0;
  std::string path_;
  // Given up for a moment to close a connection for which there is no other.
  FileDescriptor spare_;
  FileDescriptor stop_;  // an eventfd
  Take take_;
  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ACCEPTOR_H_
