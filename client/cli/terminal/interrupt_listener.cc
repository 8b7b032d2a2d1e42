#include "client/cli/terminal/interrupt_listener.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include "client/cli/terminal/exit_code.h"

namespace geodesic::client {
namespace {

// Ends the listener's thread; of no other use here.
constexpr int kWake = SIGUSR1;

sigset_t Signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, kWake}) {
    sigaddset(&signals, signal);
  }
  return signals;
}

}  // namespace

InterruptListener::InterruptListener() {
  // A blocked signal waits until sigwait takes it, in this thread and in those
  // made from it.
  const sigset_t signals = Signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  thread_ = std::thread([this, signals] {
    int signal = 0;
    while (sigwait(&signals, &signal) == 0 && signal != kWake) {
      if (!source_.request_stop()) {
        _exit(static_cast<int>(ExitCode::kInterrupted));
      }
    }
  });
}

InterruptListener::~InterruptListener() {
  pthread_kill(thread_.native_handle(), kWake);
  thread_.join();
}

}  // namespace geodesic::client
