#include "server/process_signals.h"

#include <pthread.h>
#include <signal.h>

#include <stop_token>
#include <utility>

namespace geodesic::server {
namespace {

sigset_t WatchedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGHUP);
  return signals;
}

}  // namespace

void BlockProcessSignals() {
  const sigset_t signals = WatchedSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

ProcessSignals::ProcessSignals(std::function<void(int signal)> received)
    : thread_([received = std::move(received)](const std::stop_token& stop) {
        const sigset_t signals = WatchedSignals();
        for (int signal = 0;;) {
          if (sigwait(&signals, &signal) != 0) continue;
          if (stop.stop_requested()) return;
          received(signal);
        }
      }) {}

ProcessSignals::~ProcessSignals() {
  thread_.request_stop();
  // Wakes sigwait, which then finds the request.
  pthread_kill(thread_.native_handle(), SIGTERM);
}

}  // namespace geodesic::server
