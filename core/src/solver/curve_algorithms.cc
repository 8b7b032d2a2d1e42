#include "solver/rule_times_queue.h"
#include "solver/windows/mixed_origin.h"

namespace geodesic {

StartFunction CurveStart(Algorithm algorithm) {
  return StartFunctionOf<MixedOrigin>(algorithm);
}

}  // namespace geodesic
