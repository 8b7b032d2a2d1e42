// Shows progress to the user.

#ifndef GEODESIC_CLIENT_CLI_TERMINAL_PROGRESS_DISPLAY_H_
#define GEODESIC_CLIENT_CLI_TERMINAL_PROGRESS_DISPLAY_H_

#include <chrono>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace geodesic::client {

// It shows nothing in the first half second, so short work leaves no trace. Not
// thread-safe.
class ProgressDisplay {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  enum class Style {
    kBar,    // One line, redrawn at most ten times a second, wiped at the end.
    kLines,  // A plain line now and then: the first after one second, the next
             // after five, then ever less often.
    kNone,
  };

  // `start` is when the work begins. A line takes at most `width` columns.
  ProgressDisplay(Style style, int width, TimePoint start, std::ostream* out);
  // Wipes the bar.
  ~ProgressDisplay();
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  // `fraction` from 0 to 1 of `what` is done; `detail` says more.
  void Update(TimePoint now, std::string_view what, double fraction,
              std::string_view detail);

 private:
  Style style_;
  int width_;
  TimePoint start_;
  TimePoint next_;
  std::chrono::steady_clock::duration pause_;
  bool on_screen_ = false;
  std::ostream* out_;
};

// "  solving   42% [=========>            ] detail", exactly `width` columns or
// fewer.
std::string BarLine(std::string_view what, double fraction,
                    std::string_view detail, int width);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_TERMINAL_PROGRESS_DISPLAY_H_
