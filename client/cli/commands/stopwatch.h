// The progress and the time of a call.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_STOPWATCH_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_STOPWATCH_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "client/cli/commands/command.h"
#include "client/cli/terminal/progress_display.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// Shows the progress of a computation, and measures how long it takes.
class Stopwatch {
 public:
  explicit Stopwatch(const Session& session)
      : start_(Clock::now()),
        display_(session.progress_style, session.terminal_width, start_,
                 &session.err) {}

  // The callbacks must not outlive the Stopwatch. `is_exact`: not within a
  // tolerance.
  SolveProgressCallback OnSolve(bool is_exact = true);
  // `what` names the counted things, in the plural.
  std::function<void(uint64_t, uint64_t)> OnCount(const std::string& what);

  double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_;
  ProgressDisplay display_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_STOPWATCH_H_
