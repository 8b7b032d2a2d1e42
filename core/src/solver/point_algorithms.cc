#include "solver/rule_times_queue.h"
#include "solver/windows/window.h"

namespace geodesic {

StartFunction PointStart(Algorithm algorithm) {
  return StartFunctionOf<Origin>(algorithm);
}

}  // namespace geodesic
