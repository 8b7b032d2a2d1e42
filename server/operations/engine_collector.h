// The engine's own figures, read at each scrape.

#ifndef GEODESIC_SERVER_OPERATIONS_ENGINE_COLLECTOR_H_
#define GEODESIC_SERVER_OPERATIONS_ENGINE_COLLECTOR_H_

#include <prometheus/metric_family.h>

#include <vector>

#include "server/engine/base/byte_budget.h"
#include "server/engine/query_engine.h"

namespace geodesic::server {

// `requests` is the memory of requests. Thread-safe.
std::vector<prometheus::MetricFamily> CollectEngine(const QueryEngine& engine,
                                                    const ByteBudget& requests);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPERATIONS_ENGINE_COLLECTOR_H_
