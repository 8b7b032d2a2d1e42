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

template <typename OriginType>
class RuleTimesQueue {
 public:
  static StartFunction Of(Algorithm algorithm) {
    switch (algorithm) {
      case Algorithm::kFwpCh:
        return StartWith<IchRule, FwpBuckets>;
      case Algorithm::kFwpList:
        if constexpr (std::is_same_v<OriginType, Origin>) {
          return StartWith<ListRule, FwpBuckets>;
        }
        return nullptr;
      case Algorithm::kFwpMmp:
        return StartWith<MmpRule, FwpBuckets>;
      case Algorithm::kIch:
        return StartWith<IchRule, BinaryHeap>;
      case Algorithm::kMmp:
        return StartWith<MmpRule, BinaryHeap>;
      case Algorithm::kLcCh:
        return StartWith<IchRule, LabelCorrecting>;
      case Algorithm::kLcMmp:
        return StartWith<MmpRule, LabelCorrecting>;
      case Algorithm::kCh:
        return StartWith<ChRule, Fifo>;
    }
    return nullptr;
  }

 private:
  template <template <typename> typename Rule, WindowQueue Queue>
  static std::unique_ptr<Computation> StartWith(const Mesh& mesh,
                                                const ValidQuery& query,
                                                const Tuning& tuning,
                                                WindowObserver* observer) {
    return std::make_unique<Propagation<Rule, Queue, OriginType>>(
        mesh, query, tuning, observer);
  }
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULE_TIMES_QUEUE_H_
