#include "server/acceptor.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/operations/listen_address.h"
#include "server/unix_socket.h"

namespace geodesic::server {
namespace {

// The kernel's own bound is net.core.somaxconn.
constexpr int kBacklog = 4096;

// How long nobody is accepted when even the spare descriptor is of no use.
constexpr int kPauseMilliseconds = 100;

int OpenSpare() { return open("/dev/null", O_RDONLY | O_CLOEXEC); }

int PortOf(const sockaddr_storage& address) {
  return ntohs(address.ss_family == AF_INET6
                   ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                   : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

void SetPort(int port, sockaddr_storage& address) {
  (address.ss_family == AF_INET6
       ? reinterpret_cast<sockaddr_in6&>(address).sin6_port
       : reinterpret_cast<sockaddr_in&>(address).sin_port) =
      htons(static_cast<uint16_t>(port));
}

// A socket that listens; `is_only`: there is no other for this server. Its
// number is negative, and errno set, if it cannot.
FileDescriptor ListenAt(const sockaddr* address, socklen_t size, bool is_only) {
  FileDescriptor listener(socket(
      address->sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (listener.get() < 0) return listener;
  if (address->sa_family != AF_UNIX) {
    const int on = 1;
    // "[::]" alone is all addresses, of both kinds.
    const int v6_only = !is_only;
    setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
    // Accepted sockets inherit it.
    setsockopt(listener.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    setsockopt(listener.get(), IPPROTO_IPV6, IPV6_V6ONLY, &v6_only,
               sizeof(v6_only));
  }
  if (bind(listener.get(), address, size) != 0 ||
      listen(listener.get(), kBacklog) != 0) {
    const int error = errno;
    listener = FileDescriptor();
    errno = error;
  }
  return listener;
}

}  // namespace

absl::StatusOr<std::unique_ptr<Acceptor>> Acceptor::Listen(
    const std::string& address) {
  std::unique_ptr<Acceptor> acceptor(new Acceptor());
  const std::optional<std::string> path = SocketPath(address);
  absl::Status status =
      path ? acceptor->ListenOnPath(*path) : acceptor->ListenOnPort(address);
  if (!status.ok()) return status;
  acceptor->spare_ = FileDescriptor(OpenSpare());
  acceptor->stop_ = FileDescriptor(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  return acceptor;
}

Acceptor::~Acceptor() { Stop(); }

absl::Status Acceptor::ListenOnPath(const std::string& path) {
  if (absl::Status status = CheckSocketPath(path); !status.ok()) return status;
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.data(), path.size());
  unlink(path.c_str());  // of a server that was killed
  const PrivateFiles only_for_this_user;
  FileDescriptor listener =
      ListenAt(reinterpret_cast<const sockaddr*>(&address), sizeof(address),
               /*is_only=*/true);
  if (listener.get() < 0) {
    return absl::UnavailableError(
        absl::StrCat("cannot listen on unix:", path,
                     ": its folder is missing or cannot be written to"));
  }
  listeners_.push_back(std::move(listener));
  path_ = path;
  return absl::OkStatus();
}

absl::Status Acceptor::ListenOnPort(const std::string& address) {
  const auto found = ResolveListenAddress(address);
  int error = 0;
  std::vector<std::string> bound;
  for (const addrinfo* each = found.get(); each != nullptr;
       each = each->ai_next) {
    sockaddr_storage at = {};
    std::memcpy(&at, each->ai_addr, each->ai_addrlen);
    const bool may_choose = PortOf(at) == 0;
    if (may_choose) SetPort(port_, at);
    // Names may stand for an address twice.
    std::string name(reinterpret_cast<const char*>(&at), each->ai_addrlen);
    if (std::ranges::find(bound, name) != bound.end()) continue;
    FileDescriptor listener =
        ListenAt(reinterpret_cast<const sockaddr*>(&at), each->ai_addrlen,
                 found->ai_next == nullptr);
    if (listener.get() < 0) {
      // A machine need not have each kind of address that a name stands for;
      // but another server may not have the port on one of them.
      if (errno == EADDRINUSE && !may_choose) error = errno;
      continue;
    }
    socklen_t size = sizeof(at);
    getsockname(listener.get(), reinterpret_cast<sockaddr*>(&at), &size);
    port_ = PortOf(at);
    bound.push_back(std::move(name));
    listeners_.push_back(std::move(listener));
  }
  if (!listeners_.empty() && error == 0) return absl::OkStatus();
  return absl::UnavailableError(absl::StrCat(
      "cannot listen on ", address,
      ": the port is in use or the address is not of this machine"));
}

void Acceptor::Start(Take take) {
  take_ = std::move(take);
  thread_ = std::jthread([this] { Serve(); });
}

void Acceptor::Stop() {
  if (thread_.joinable()) {
    eventfd_write(stop_.get(), 1);
    thread_.join();
  }
  if (!path_.empty() && !listeners_.empty()) unlink(path_.c_str());
  listeners_.clear();
}

void Acceptor::Serve() {
  std::vector<pollfd> watched = {{stop_.get(), POLLIN, 0}};
  for (const FileDescriptor& listener : listeners_) {
    watched.push_back({listener.get(), POLLIN, 0});
  }
  for (;;) {
    poll(watched.data(), watched.size(), -1);
    if (watched[0].revents != 0) return;
    for (size_t i = 1; i < watched.size(); ++i) {
      if (watched[i].revents == 0 || AcceptAll(watched[i].fd)) continue;
      if (poll(watched.data(), 1, kPauseMilliseconds) > 0) return;
    }
  }
}

bool Acceptor::AcceptAll(int listener) {
  rlimit limit = {};
  getrlimit(RLIMIT_NOFILE, &limit);
  const uint64_t all = limit.rlim_cur;
  const uint64_t most = all - std::min<uint64_t>(kKeptDescriptors, all / 8);
  for (;;) {
    FileDescriptor connection(
        accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (connection.get() < 0) {
      switch (errno) {
        case EAGAIN:
          return true;
        case ECONNABORTED:
        case EINTR:
        case EPERM:
        case EPROTO:
          continue;  // it has gone, or a firewall is against it
        case EMFILE:
        case ENFILE:
          if (!CloseOne(listener)) return errno == EAGAIN;
          continue;
        default:
          return false;
      }
    }
    // The kernel gives the lowest number that is free.
    if (static_cast<uint64_t>(connection.get()) < most) {
      take_(connection.Release(), listener);
    }
  }
}

bool Acceptor::CloseOne(int listener) {
  spare_ = FileDescriptor();
  const int connection = accept(listener, nullptr, nullptr);
  const int error = errno;
  if (connection >= 0) close(connection);
  spare_ = FileDescriptor(OpenSpare());
  errno = error;
  return connection >= 0;
}

}  // namespace geodesic::server
