// SIGTERM and SIGINT, taken on a thread of their own.

#ifndef GEODESIC_SERVER_TERMINATION_SIGNALS_H_
#define GEODESIC_SERVER_TERMINATION_SIGNALS_H_

#include <functional>
#include <thread>

namespace geodesic::server {

// Keeps both signals away from the calling thread and those it starts later.
// Call it before any thread is started.
void BlockTerminationSignals();

// While it lives, each SIGTERM and SIGINT calls `received`, from an ordinary
// thread, where everything is allowed.
// REQUIRES: BlockTerminationSignals was called.
class TerminationSignals {
 public:
  explicit TerminationSignals(std::function<void(int signal)> received);

  // A call that is going on ends first.
  ~TerminationSignals();

 private:
  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_TERMINATION_SIGNALS_H_
