#include "rule_times_queue.h"
#include "windows/window.h"

namespace geodesic {

StartFunction PointStart(Algorithm algorithm) {
  return RuleTimesQueue<Origin>::Of(algorithm);
}

}  // namespace geodesic
