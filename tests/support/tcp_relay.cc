#include "tests/support/tcp_relay.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace geodesic::test {
namespace {

void Check(bool ok, const char* what) {
  if (ok) return;
  std::perror(what);
  std::abort();
}

sockaddr_in Loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<uint16_t>(port));
  return address;
}

bool WriteAll(int to, const char* data, size_t size) {
  while (size > 0) {
    const ssize_t written = send(to, data, size, MSG_NOSIGNAL);
    if (written <= 0) return false;
    data += written;
    size -= static_cast<size_t>(written);
  }
  return true;
}

}  // namespace

TcpRelay::TcpRelay(int server_port)
    : server_port_(server_port), listener_(socket(AF_INET, SOCK_STREAM, 0)) {
  Check(listener_ >= 0, "socket");
  sockaddr_in address = Loopback(0);
  socklen_t size = sizeof(address);
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  Check(bind(listener_, generic, size) == 0, "bind");
  Check(listen(listener_, SOMAXCONN) == 0, "listen");
  Check(getsockname(listener_, generic, &size) == 0, "getsockname");
  port_ = ntohs(address.sin_port);
  acceptor_ = std::jthread([this] { Accept(); });
}

TcpRelay::~TcpRelay() {
  Release();
  shutdown(listener_, SHUT_RDWR);
  acceptor_.join();
  {
    std::lock_guard lock(mutex_);
    CutAll();
  }
  for (Connection& connection : connections_) {
    connection.up.join();
    connection.down.join();
    close(connection.client);
    close(connection.server);
  }
  close(listener_);
}

void TcpRelay::Accept() {
  for (;;) {
    const int client = accept(listener_, nullptr, nullptr);
    if (client < 0) return;
    {
      std::unique_lock lock(mutex_);
      released_.wait(lock, [this] { return !held_; });
    }
    const int server = socket(AF_INET, SOCK_STREAM, 0);
    const sockaddr_in address = Loopback(server_port_);
    // When nobody is there, the client hears so by the end of its connection.
    (void)connect(server, reinterpret_cast<const sockaddr*>(&address),
                  sizeof(address));
    std::lock_guard lock(mutex_);
    Connection& connection = connections_.emplace_back();
    connection.client = client;
    connection.server = server;
    connection.up = std::jthread([=, this] { Copy(client, server, false); });
    connection.down = std::jthread([=, this] { Copy(server, client, true); });
  }
}

void TcpRelay::Copy(int from, int to, bool is_down) {
  std::array<char, 16384> buffer;
  for (;;) {
    const ssize_t got = recv(from, buffer.data(), buffer.size(), 0);
    auto size = static_cast<uint64_t>(got > 0 ? got : 0);
    bool cut = false;
    if (is_down && size > 0) {
      std::lock_guard lock(mutex_);
      cut = size >= bytes_left_;
      if (cut) size = bytes_left_;
      bytes_left_ =
          cut ? std::numeric_limits<uint64_t>::max() : bytes_left_ - size;
    }
    const bool passed = WriteAll(to, buffer.data(), size);
    if (cut) Cut();
    if (got <= 0 || cut || !passed) break;
  }
  // The other direction ends, too.
  shutdown(from, SHUT_RDWR);
  shutdown(to, SHUT_RDWR);
}

void TcpRelay::Cut() {
  std::lock_guard lock(mutex_);
  CutAll();
  ++cuts_;
}

void TcpRelay::CutAll() {
  for (const Connection& connection : connections_) {
    shutdown(connection.client, SHUT_RDWR);
    shutdown(connection.server, SHUT_RDWR);
  }
}

void TcpRelay::CutAfter(uint64_t bytes) {
  std::lock_guard lock(mutex_);
  bytes_left_ = bytes;
}

void TcpRelay::Hold() {
  std::lock_guard lock(mutex_);
  held_ = true;
}

void TcpRelay::Release() {
  std::lock_guard lock(mutex_);
  held_ = false;
  released_.notify_all();
}

int TcpRelay::cuts() const {
  std::lock_guard lock(mutex_);
  return cuts_;
}

}  // namespace geodesic::test
