#include "client/cli/commands/stopwatch.h"

#include "absl/strings/str_cat.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

double PartReached(const SolveProgress& progress) {
  if (progress.vertex_count == 0) return 0;
  return static_cast<double>(progress.vertices_reached) /
         static_cast<double>(progress.vertex_count);
}

}  // namespace

SolveProgressCallback Stopwatch::OnSolve(bool is_exact) {
  return [this, is_exact](const SolveProgress& progress) {
    const bool waits =
        progress.vertices_reached == 0 && progress.windows_propagated == 0;
    display_.Update(
        Clock::now(), waits ? "waiting" : "solving", PartReached(progress),
        waits ? "for a free thread"
              : absl::StrCat(is_exact ? "exact" : "certified", " up to ",
                             ShortNumber(progress.settled_radius), ", ",
                             GroupedNumber(progress.windows_propagated),
                             " windows"));
  };
}

std::function<void(uint64_t, uint64_t)> Stopwatch::OnCount(
    const std::string& what) {
  return [this, what](uint64_t finished, uint64_t total) {
    display_.Update(
        Clock::now(), "solving",
        total == 0 ? 0
                   : static_cast<double>(finished) / static_cast<double>(total),
        absl::StrCat(GroupedNumber(finished), " of ", GroupedNumber(total), " ",
                     what));
  };
}

}  // namespace geodesic::client
