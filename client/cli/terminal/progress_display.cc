#include "client/cli/terminal/progress_display.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

using std::chrono::milliseconds;

// Goes back to the first column and erases the line.
constexpr char kWipe[] = "\r\x1b[K";

constexpr milliseconds kBarDelay(500);
constexpr milliseconds kBarPause(100);
constexpr milliseconds kLineDelay(1000);

std::string Percent(double fraction) {
  const auto percent = static_cast<int>(std::floor(100 * fraction));
  return absl::StrCat(absl::Dec(percent, absl::kSpacePad3), "%");
}

double Clamped(double fraction) {
  return std::isnan(fraction) ? 0 : std::clamp(fraction, 0.0, 1.0);
}

}  // namespace

std::string BarLine(std::string_view what, double fraction,
                    std::string_view detail, int width) {
  fraction = Clamped(fraction);
  std::string line =
      absl::StrCat(std::string(what), " ", Percent(fraction), " ");
  // The detail is left out if the bar would get too short to be read.
  constexpr int kLeastBar = 12;
  constexpr int kMostBar = 40;
  const int room = width - static_cast<int>(line.size()) - 2;
  const int with_detail = room - static_cast<int>(detail.size()) - 1;
  const bool show_detail = !detail.empty() && with_detail >= kLeastBar;
  const int bar = std::min(show_detail ? with_detail : room, kMostBar);
  if (bar >= kLeastBar) {
    const int filled = static_cast<int>(std::lround(fraction * bar));
    line.push_back('[');
    line.append(static_cast<size_t>(filled), '=');
    if (filled < bar) line.push_back('>');
    line.append(static_cast<size_t>(std::max(0, bar - filled - 1)), ' ');
    line.push_back(']');
    if (show_detail) absl::StrAppend(&line, " ", std::string(detail));
  }
  if (static_cast<int>(line.size()) > width) line.resize(std::max(0, width));
  return line;
}

ProgressDisplay::ProgressDisplay(Style style, int width, TimePoint start,
                                 std::ostream* out)
    : style_(style),
      width_(width),
      start_(start),
      next_(start + (style == Style::kBar ? kBarDelay : kLineDelay)),
      pause_(style == Style::kBar ? kBarPause : 5 * kLineDelay),
      out_(out) {}

void ProgressDisplay::Update(TimePoint now, std::string_view what,
                             double fraction, std::string_view detail) {
  if (style_ == Style::kNone || now < next_) return;
  next_ = now + pause_;
  if (style_ == Style::kBar) {
    *out_ << kWipe << BarLine(what, fraction, detail, width_) << std::flush;
    on_screen_ = true;
    return;
  }
  pause_ += pause_ / 2;
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(now - start_).count();
  *out_ << what << ' ' << Percent(Clamped(fraction)) << " after " << seconds
        << " s";
  if (!detail.empty()) *out_ << ", " << detail;
  *out_ << std::endl;
}

ProgressDisplay::~ProgressDisplay() {
  if (on_screen_) *out_ << kWipe << std::flush;
}

}  // namespace geodesic::client
