// What the front finds is applied at once.

#ifndef GEODESIC_SOLVER_RULES_DIRECT_SINK_H_
#define GEODESIC_SOLVER_RULES_DIRECT_SINK_H_

#include <cstdint>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/rules/shadow_fan.h"
#include "solver/windows/window.h"

namespace geodesic {

// A sink for Front::AddAnchor and Front::Expand.
template <typename Front, typename Rule>
class DirectSink {
 public:
  // Both outlive the sink.
  DirectSink(Front& front, Rule& rule) : front_(front), rule_(rule) {}

  void Relax(uint32_t vertex, double distance, const Arrival& arrival,
             const IncomingRay& ray = {}) {
    front_.Relax(vertex, distance, arrival, ray);
  }
  void Observe(HalfEdge h, const typename Front::Window& window,
               uint32_t pseudo_source) {
    front_.Observe(h, window, pseudo_source);
  }
  void Open(HalfEdge half_edge, uint32_t pseudo_source,
            const typename Front::Origin& origin, const Interval& interval) {
    rule_.Open(half_edge, pseudo_source, origin, interval);
  }

 private:
  Front& front_;
  Rule& rule_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_DIRECT_SINK_H_
