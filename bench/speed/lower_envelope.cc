#include "bench/speed/lower_envelope.h"

#include <cmath>

#include "solver/queues/fwp_buckets.h"
#include "solver/rules/anchor_seeding.h"
#include "solver/rules/expansion.h"
#include "solver/rules/front.h"
#include "solver/rules/mmp_rule.h"
#include "surface/anchors.h"

namespace geodesic::speed {
namespace {

// Nothing is ever settled for the rule, so that it drops no list.
class NeverSettled : public FwpBuckets {
 public:
  using FwpBuckets::FwpBuckets;
  double SettledRadius() const { return 0; }
};

}  // namespace

uint64_t LowerEnvelope(const Mesh& mesh, uint32_t source) {
  const ValidQuery query =
      ValidQuery::Make({.sources = {{VertexPoint{source}}}}, mesh).value();
  NeverSettled queue(
      {.bucket_width = mesh.mean_edge_length() /
                       std::sqrt(static_cast<double>(mesh.face_count()))});
  Front<NeverSettled, Origin> front(mesh, *query, queue, nullptr);
  MmpRule<Front<NeverSettled, Origin>> rule(front);
  DirectSink sink(front, rule);
  for (const Anchor& anchor : AnchorsOf(query)) AddAnchor(front, anchor, sink);
  for (uint32_t id = queue.Pop(); id != kNothing; id = queue.Pop()) {
    while (rule.HasToSpread()) rule.Spread();
    if (id & kVertexEvent) {
      const uint32_t v = id & ~kVertexEvent;
      if (front.TakeEvent(v)) Expand(front, v, sink);
    } else {
      rule.Propagate(id);
    }
  }
  return rule.windows();
}

}  // namespace geodesic::speed
