// The engine's own figures, read at each scrape.

#ifndef GEODESIC_SERVER_OPERATIONS_ENGINE_COLLECTOR_H_
#define GEODESIC_SERVER_OPERATIONS_ENGINE_COLLECTOR_H_

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <vector>

#include "server/engine/base/byte_budget.h"
#include "server/engine/query_engine.h"

namespace geodesic::server {

// Thread-safe.
class EngineCollector final : public prometheus::Collectable {
 public:
  // REQUIRES: `engine` and the budget of requests outlive the collector.
  EngineCollector(const QueryEngine& engine, const ByteBudget& requests)
      : engine_(engine), requests_(requests) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  std::vector<prometheus::MetricFamily> CollectMemory() const;

  const QueryEngine& engine_;
  const ByteBudget& requests_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPERATIONS_ENGINE_COLLECTOR_H_
