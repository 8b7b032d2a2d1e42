// A page of this machine over HTTP.

#ifndef GEODESIC_TESTS_SUPPORT_HTTP_GET_H_
#define GEODESIC_TESTS_SUPPORT_HTTP_GET_H_

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace geodesic::test {

// A connection to a port of this machine over which `bytes` were sent; `from`:
// the address of loopback that it comes from.
// Errors: throws std::runtime_error if nobody takes them.
inline int ConnectAndSend(int port, const std::string& bytes,
                          const char* from = "127.0.0.1") {
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  inet_pton(AF_INET, from, &address.sin_addr);
  if (bind(connection, reinterpret_cast<const sockaddr*>(&address),
           sizeof(address)) != 0) {
    throw std::runtime_error("no connection comes from " + std::string(from));
  }
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(connection, reinterpret_cast<const sockaddr*>(&address),
              sizeof(address)) != 0 ||
      write(connection, bytes.data(), bytes.size()) !=
          static_cast<ssize_t>(bytes.size())) {
    close(connection);
    throw std::runtime_error("nobody listens on port " + std::to_string(port));
  }
  return connection;
}

// The whole answer to a request after which the server closes the connection,
// head and body.
// Errors: throws std::runtime_error if nobody answers on the port.
inline std::string HttpExchange(int port, const std::string& request) {
  const int connection = ConnectAndSend(port, request);
  std::string answer;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(connection, buffer, sizeof(buffer))) > 0;) {
    answer.append(buffer, static_cast<size_t>(n));
  }
  close(connection);
  if (answer.empty()) throw std::runtime_error("no answer to " + request);
  return answer;
}

// The same for a page of /metrics and its neighbours.
inline std::string HttpGet(int port, const std::string& path) {
  return HttpExchange(port, "GET " + path + " HTTP/1.1\r\nHost: test\r\n\r\n");
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_HTTP_GET_H_
