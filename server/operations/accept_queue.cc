#include "server/operations/accept_queue.h"

#include <fstream>
#include <sstream>
#include <string>

namespace geodesic::server {
namespace {

// Of one table of the kernel's; a socket that listens has there how many wait.
std::optional<uint64_t> WaitingIn(const char* table, int port) {
  constexpr char kListens[] = "0A";
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);  // the names of the columns
  std::optional<uint64_t> waiting;
  while (std::getline(file, line)) {
    std::istringstream columns(line);
    std::string number, local, remote, state, queues;
    if (!(columns >> number >> local >> remote >> state >> queues)) continue;
    const size_t colon = local.rfind(':'), between = queues.find(':');
    if (state != kListens || colon == local.npos || between == queues.npos) {
      continue;
    }
    if (std::stoi(local.substr(colon + 1), nullptr, 16) != port) continue;
    waiting = waiting.value_or(0) +
              std::stoull(queues.substr(between + 1), nullptr, 16);
  }
  return waiting;
}

}  // namespace

std::optional<uint64_t> WaitingConnections(int port) {
  std::optional<uint64_t> all;
  for (const char* table : {"/proc/self/net/tcp", "/proc/self/net/tcp6"}) {
    const std::optional<uint64_t> waiting = WaitingIn(table, port);
    if (waiting.has_value()) all = all.value_or(0) + *waiting;
  }
  return all;
}

bool AcceptWatch::IsServed(uint64_t waiting, Clock::time_point now) {
  if (waiting == 0) {
    waiting_since_.reset();
    return true;
  }
  if (!waiting_since_.has_value()) waiting_since_ = now;
  return now - *waiting_since_ < kPatience;
}

}  // namespace geodesic::server
