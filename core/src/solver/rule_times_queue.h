// The table behind algorithm_table.h, for either kind of origin.

#ifndef GEODESIC_SOLVER_RULE_TIMES_QUEUE_H_
#define GEODESIC_SOLVER_RULE_TIMES_QUEUE_H_

#include <memory>
#include <type_traits>

#include "solver/algorithm_table.h"
#include "solver/propagation.h"
#include "solver/queues/binary_heap.h"
#include "solver/queues/fifo.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/queues/label_correcting.h"
#include "solver/rules/ch_rule.h"
#include "solver/rules/list_rule.h"
#include "solver/rules/mmp_rule.h"

namespace geodesic {

// Curves are asked of algorithms that trim only (ValidQuery sees to it).
template <typename OriginType>
StartFunction StartFunctionOf(Algorithm algorithm) {
  switch (algorithm) {
#define GEODESIC_START(id, name, Rule, Queue, with_trimming, summary)         \
  case Algorithm::k##id:                                                      \
    if constexpr (std::is_same_v<OriginType, Origin> ||                       \
                  Algorithm::k##id == Algorithm::k##with_trimming) {          \
      return                                                                  \
          [](const Mesh& mesh, const ValidQuery& query, const Tuning& tuning, \
             WindowObserver* observer) -> std::unique_ptr<Computation> {      \
            return std::make_unique<Propagation<Rule, Queue, OriginType>>(    \
                mesh, query, tuning, observer);                               \
          };                                                                  \
    }                                                                         \
    break;
    GEODESIC_ALGORITHMS(GEODESIC_START)
#undef GEODESIC_START
  }
  return nullptr;
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULE_TIMES_QUEUE_H_
