// SIGTERM, SIGINT and SIGHUP, taken on a thread of their own.

#ifndef GEODESIC_SERVER_PROCESS_SIGNALS_H_
#define GEODESIC_SERVER_PROCESS_SIGNALS_H_

#include <functional>
#include <thread>

namespace geodesic::server {

// Keeps these signals away from the calling thread and those it starts later.
// Call it before any thread is started.
void BlockProcessSignals();

// While it lives, each of these signals calls `received`, from an ordinary
// thread, where everything is allowed.
// REQUIRES: BlockProcessSignals was called.
class ProcessSignals {
 public:
  explicit ProcessSignals(std::function<void(int signal)> received);

  // A call that is going on ends first.
  ~ProcessSignals();

 private:
  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_PROCESS_SIGNALS_H_
