// Ctrl-C -> a stop request.

#ifndef GEODESIC_CLIENT_CLI_TERMINAL_INTERRUPT_LISTENER_H_
#define GEODESIC_CLIENT_CLI_TERMINAL_INTERRUPT_LISTENER_H_

#include <stop_token>
#include <thread>

namespace geodesic::client {

// While it lives SIGINT and SIGTERM request a stop instead of ending the
// process; the second of them ends it at once with exit code 130. To be made
// before any other thread, which would otherwise take the signals.
class InterruptListener {
 public:
  InterruptListener();
  ~InterruptListener();
  InterruptListener(const InterruptListener&) = delete;
  InterruptListener& operator=(const InterruptListener&) = delete;

  std::stop_token stop() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::thread thread_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_INTERRUPT_LISTENER_H_
