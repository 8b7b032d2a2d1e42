// A hop on the way to a server that can be cut, as cables are.

#ifndef GEODESIC_TESTS_SUPPORT_TCP_RELAY_H_
#define GEODESIC_TESTS_SUPPORT_TCP_RELAY_H_

#include <condition_variable>
#include <cstdint>
#include <limits>
#include <list>
#include <mutex>
#include <thread>

namespace geodesic::test {

// Passes on what connections to port() say to a port of this machine, and what
// it answers. A thread a direction, so that whoever is slow slows the other.
class TcpRelay {
 public:
  // REQUIRES: sockets can be had; anything else ends the program.
  explicit TcpRelay(int server_port);
  ~TcpRelay();
  TcpRelay(const TcpRelay&) = delete;
  TcpRelay& operator=(const TcpRelay&) = delete;

  int port() const { return port_; }

  // Cuts the connections there are; later ones are passed on.
  void Cut();
  // Cuts, once, when so many more bytes have come from the server.
  void CutAfter(uint64_t bytes);
  // Connections that come from now on wait until Release.
  void Hold();
  void Release();
  // How often there was something to cut.
  int cuts() const;

 private:
  struct Connection {
    int client = -1;
    int server = -1;
    std::jthread up;
    std::jthread down;
  };

  void Accept();
  void Copy(int from, int to, bool is_down);
  // REQUIRES: mutex_ held.
  void CutAll();

  const int server_port_;
  int listener_ = -1;
  int port_ = 0;

  mutable std::mutex mutex_;
  // Guarded by mutex_:
  std::list<Connection> connections_;
  uint64_t bytes_left_ = std::numeric_limits<uint64_t>::max();
  int cuts_ = 0;
  bool held_ = false;
  std::condition_variable released_;

  std::jthread acceptor_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_TCP_RELAY_H_
