#include "server/engine/jobs/processor_share.h"

#include <sys/resource.h>

namespace geodesic::server {
namespace {

// Five steps of nice leave a third of a thread's weight (each takes a fifth).
constexpr int kThird = 5;
constexpr int kMost = 2 * kThird;

thread_local int steps = 0;

}  // namespace

void ShareByAge(Duration ran) {
  int wanted = 0;
  for (Duration age = kYoung; age <= ran && wanted < kMost; age *= 4) {
    wanted += kThird;
  }
  if (wanted <= steps) return;
  // Of Linux, for the calling thread alone.
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + (wanted - steps));
  steps = wanted;
}

bool HasSmallShare() { return steps > 0; }

}  // namespace geodesic::server
